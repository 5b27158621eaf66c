// Compares a render with the film file that it resumes, and says which settings remove a difference.
#include "host/job/resumption.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "host/base/errors.h"
#include "host/base/setting_words.h"
#include "host/job/film_identity.h"

namespace candela::job {
namespace {

template <class T>
void insertSorted(std::vector<T>& items, const T& item) {
  const auto found = std::ranges::lower_bound(items, item);
  if (found == items.end() || *found != item) items.insert(found, item);
}

/// The changes that make the settings of a render those of a film.
class Changes {
 public:
  Changes(const film::FilmHeader& film, const film::FilmHeader& render) {
    if (film.size != render.size) use("size", render::extentText(film.size));
    if (film.seed != render.seed) use("seed", fmt::to_string(film.seed));
    std::set<std::string> names;
    for (const auto& settings : {film.settings, render.settings}) {
      for (const auto& [name, ignored] : settings) names.insert(name);
    }
    for (const std::string& name : names) {
      if (film.setting(name) != render.setting(name)) adopt(name, film, render);
    }
  }

  /// E.g. "use --size 96x96 --seed 3, and leave out --one-sided". Empty if no settings achieve that.
  std::string text() const {
    std::vector<std::string> steps;
    if (!added_.empty()) steps.push_back(fmt::format("use {}", fmt::join(added_, " ")));
    if (!removed_.empty()) steps.push_back(fmt::format("leave out {}", fmt::join(removed_, " and ")));
    return fmt::format("{}", fmt::join(steps, ", and "));
  }

 private:
  void use(const std::string& name, const std::string& value) { added_.push_back(settingWords(name, value)); }

  void adopt(const std::string& name, const film::FilmHeader& film, const film::FilmHeader& render) {
    const std::string value = film.setting(name);
    if (name == kAntialiasing) return use("spp", value == "off" ? "0" : fmt::to_string(film.samplesPerPixel));
    if (name == kAccel) return adoptStructure(value, render.setting(name));
    const FilmSetting* const setting = filmSettingNamed(name);
    if (setting == nullptr) return;
    const bool hasValue = setting->unrecorded != nullptr && setting->wordsOfDefault == nullptr && !setting->isFlag;
    if (value.empty() && hasValue) return use(name, setting->unrecorded);
    const bool isDefault = setting->wordsOfDefault != nullptr && value == setting->wordsOfDefault;
    if (value.empty() || isDefault || (setting->isFlag && value == "off"))
      return removed_.push_back(settingWords(name));
    use(name, value);
  }

  // Films without a description of the structure do not depend on it.
  void adoptStructure(const std::string& film, const std::string& render) {
    const std::string kind = film.substr(0, film.find(' '));
    if (!film.empty() && kind != render.substr(0, render.find(' '))) use("accel", kind);
  }

  std::vector<std::string> added_, removed_;
};

std::string stepsToResume(const film::FilmHeader& film, const film::FilmHeader& render) {
  return Changes(film, render).text();
}

// Returns the next step after a refusal. Films of other pixels cannot be resumed at all.
std::string remedyFor(const film::FilmHeader& film, const film::FilmHeader& render) {
  const std::string steps = stepsToResume(film, render);
  if (film.window != render.window && !steps.empty()) return steps;
  return fmt::format("{}{}{} resumes nevertheless, and marks the film as mixed", steps, steps.empty() ? "" : "; ",
                     settingWords("resume-anyway"));
}

// Returns the reason, as a clause, why a film with another number of samples per pixel cannot be resumed by the job;
// null: it can.
const char* whyFixedCount(const Job& job, std::uint32_t begunWith) {
  render::ImageSettings before = job.settings.image;
  before.sampleCount = begunWith;
  if (before.sampler == render::SamplerKind::stratified) return "the strata of a pixel depend on the number";
  if (before.jittersPixels() != job.settings.image.jittersPixels()) {
    return "rays of one sample per pixel are not jittered, and those of several are";
  }
  return nullptr;
}

// Sets the number of samples per pixel in a film's header to that of the job. A film may be resumed with another number
// if its samples do not depend on it.
void adoptSampleCount(const Job& job, const film::FilmReader& reader, film::FilmHeader& film) {
  const std::uint32_t wanted = job.settings.image.sampleCount;
  if (film.samplesPerPixel == wanted) return;
  const char* const why = whyFixedCount(job, film.samplesPerPixel);
  if (why == nullptr) {
    film.samplesPerPixel = wanted;
  } else if (!job.film.resumeAnyway) {
    throw FileError(fmt::format("{}: the film was started with {} samples per pixel, and cannot be resumed with {}: {}",
                                reader.file().string(), film.samplesPerPixel, wanted, why));
  }
}

void requireSameWindow(const film::FilmReader& film, const film::FilmHeader& header) {
  if (film.header().window == header.window) return;
  if (film.header().size != header.size) {
    throw FileError(fmt::format("{}: the film is part of an image of {} pixels, and the render of one of {}; {}",
                                film.file().string(), render::extentText(film.header().size),
                                render::extentText(header.size), stepsToResume(film.header(), header)));
  }
  const std::string window = render::windowText(film.header().window);
  throw FileError(fmt::format("{}: the film has the pixels {}, and the render {}; use {}", film.file().string(), window,
                              render::windowText(header.window), settingWords("crop", window)));
}

// Denoising adds the layer `moments`.
std::string stepsToLayers(const image::LayerSet& film, const image::LayerSet& render) {
  const std::string layers = settingWords("aov", layerText(film)), denoise = settingWords("denoise");
  const bool hasMoments = film.has(image::Layer::moments);
  if (render.has(image::Layer::moments) && !hasMoments) return fmt::format("use {}, and leave out {}", layers, denoise);
  image::LayerSet denoised = render;
  denoised.add(image::Layer::moments);
  return denoised == film ? fmt::format("use {} or {}", denoise, layers) : "use " + layers;
}

// Sums that samples did not add cannot be computed later, whatever the user accepts.
void requireSameLayers(const film::FilmReader& film, const film::FilmHeader& header) {
  const image::LayerSet has = film.header().layers;
  if (has == header.layers) return;
  throw FileError(fmt::format("{}: the film has the layers {}, and the render {}; {}", film.file().string(),
                              layerText(has), layerText(header.layers), stepsToLayers(has, header.layers)));
}

// Sums of different units cannot be added, whatever the user accepts.
void requireSameScale(const film::FilmReader& film, const film::FilmHeader& header) {
  const std::uint32_t scale = film.header().filmScale();
  if (scale == header.filmScale()) return;
  throw FileError(fmt::format("{}: the film has the scale {}, and the render {}; use {}", film.file().string(), scale,
                              header.filmScale(), settingWords("film-scale", fmt::to_string(scale))));
}

// Returns the end of the samples of a film that can be continued. A film with a noise threshold states only the maximum
// of those that were begun.
std::uint32_t endOf(const film::FilmHeader& film) {
  if (!film.begun.empty() && !film.noiseThreshold()) return film.begun.front().samples.end;
  return film.covered.empty() ? 0 : film.covered.front().samples.end;
}

// `count` is the number of samples that each pixel of the film has, or `isMaximum` the maximum of pixels that differ.
[[noreturn]] void refuseFewer(const film::FilmReader& film, std::uint32_t count, bool isMaximum) {
  throw FileError(
      fmt::format("{0}: the film already has {1}{2} samples per pixel; use {3} or more, or make a picture of it with "
                  "`candela film`",
                  film.file().string(), isMaximum ? "up to " : "", count,
                  settingWords("spp", fmt::to_string(isMaximum ? count : count + 1))));
}

// Returns the first sample of a film, which must be one that samples can be appended to; nothing for a film without
// samples.
std::optional<std::uint32_t> requireContinuable(const Job& job, const film::FilmReader& reader) {
  const film::FilmHeader& film = reader.header();
  if (film.covered.empty() && film.begun.empty()) return std::nullopt;
  const std::optional<std::uint32_t> first = film::firstSampleOf(film);
  if (!first) {
    throw FileError(fmt::format("{}: the film was merged {}", reader.file().string(),
                                film.begun.empty()
                                    ? "from parts with gaps between them; render the missing parts separately, and "
                                      "merge them"
                                    : "with interrupted parts; resume the films of these parts, and merge again"));
  }
  const render::SampleRange range = samplesOf(job);
  const std::uint32_t next = endOf(film);
  if (range.first == *first && range.end >= next) return first;
  if (!job.film.samples && *first == 0) refuseFewer(reader, next, !film.begun.empty());
  throw FileError(fmt::format(
      "{}: the film starts at sample {} and ends before sample {}, and the render has samples {}:{}; use {}",
      reader.file().string(), *first, next, range.first, range.end,
      settingWords("samples", fmt::format("{}:N", *first))));
}

}  // namespace

void continueWith(film::FilmHeader& film, const film::FilmHeader& now, bool mayDiffer) {
  const film::Tracer& tracer = now.tracers.front();
  const bool isKnown = std::ranges::find(film.tracers, tracer) != film.tracers.end();
  if (!isKnown && !mayDiffer) {
    throw DeviceLostError(fmt::format(
        "after the failure, {}", tracerDifferences(film.tracers.front(), tracer, "the film", "the device").front()));
  }
  insertSorted(film.tracers, tracer);
  for (const std::string& line : mixedDifferences(film, now)) {
    insertSorted(film.mixed, line);
  }
}

std::optional<std::uint32_t> adoptFilm(const Job& job, const film::FilmReader& reader, film::FilmHeader& header,
                                       const Log& log) {
  film::FilmHeader film = reader.header();
  adoptSampleCount(job, reader, film);
  requireSameLayers(reader, header);
  requireSameScale(reader, header);
  std::vector<std::string> differences = estimateDifferences(film, header, "the film", "this render");
  for (const film::Tracer& tracer : film.tracers) {
    const auto more = tracerDifferences(tracer, header.tracers.front(), "the film", "this render");
    differences.insert(differences.end(), more.begin(), more.end());
  }
  if (!differences.empty() && !job.film.resumeAnyway) {
    throw FileError(
        fmt::format("{}: {}{}; {}", reader.file().string(), differences.front(),
                    film.sceneHash == header.sceneHash
                        ? ""
                        : ": a file of the scene, its environment, its camera or the time of its animation differs",
                    remedyFor(reader.header(), header)));
  }
  for (const std::string& difference : differences) {
    log.warning(fmt::format("{}: {}", settingWords("resume-anyway"), difference));
  }
  requireSameWindow(reader, header);
  for (const std::string& line : mixedDifferences(film, header)) {
    insertSorted(header.mixed, line);
  }
  for (const std::string& line : film.mixed) insertSorted(header.mixed, line);
  for (const film::Tracer& tracer : film.tracers) insertSorted(header.tracers, tracer);
  return requireContinuable(job, reader);
}

void requireNoMoreSamples(const Job& job, const film::FilmReader& reader, const image::Film& film) {
  if (!reader.header().noiseThreshold()) return;
  const std::uint32_t maxCount = std::ranges::max(film.pixels(), {}, &image::FilmPixel::sampleCount).sampleCount;
  if (maxCount > samplesOf(job).end) refuseFewer(reader, maxCount, true);
}

}  // namespace candela::job
