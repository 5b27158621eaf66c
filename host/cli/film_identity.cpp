// Compares renders with film files.
#include "host/cli/film_identity.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "host/cli/film_options.h"
#include "host/cli/option_table.h"
#include "host/core/errors.h"
#include "host/core/hash_text.h"
#include "host/core/version.h"
#include "host/scene/object_names.h"

namespace candela::cli {
namespace {

// Size, samples and seed are members of the header. The folders that files may be in do not change what is read, the
// scene's hash covers the environment, and the scale in use is a setting of its own.
bool isSetting(const Option& option) {
  const bool decides = option.group == OptionGroup::image || option.group == OptionGroup::sceneFile;
  const std::string name = option.name();
  const bool stated = name == "--size" || name == "--spp" || name == "--seed" || name == "--allow-path" ||
                      name == "--env" || name == "--film-scale";
  return decides && !stated && option.isFor(Command::render);
}

// Films of earlier versions call the list of a small scene "row".
const char* layoutText(render::LayoutInUse layout) {
  return layout == render::LayoutInUse::list ? "row" : nameOf(layout);
}

std::string structureText(const RenderJob& job, const render::RenderStatistics& statistics) {
  return fmt::format("{} {} {} {} density {}", nameOf(statistics.structure), nameOf(statistics.bvhSplit),
                     nameOf(statistics.bvhQuality), layoutText(statistics.layout),
                     job.settings().structure.gridDensity);
}

// Films of versions without these options can be resumed, because films record these options only if they do not
// have their defaults.
constexpr std::array<std::string_view, 4> kLateSettings{"--background", "--noise-threshold", "--aov-through-specular",
                                                        "--animation"};

std::map<std::string, std::string> settingsOf(const RenderJob& job, const render::RenderStatistics& statistics) {
  std::map<std::string, std::string> settings;
  for (const Option& option : optionTable()) {
    if (!isSetting(option)) continue;
    const std::vector<std::string> values = option.show(job.arguments);
    const std::string value = values.empty() ? "off" : values.front();
    const bool isLate = std::ranges::find(kLateSettings, option.name()) != kLateSettings.end();
    if (isLate && option.isDefault(value)) continue;
    settings[option.name().substr(2)] = film::validText(value);
  }
  if (job.arguments.noiseThreshold) settings[film::kStoppingRule] = film::kCurrentStoppingRule;
  if (job.settings().image.filmScale > 0) settings[film::kFilmScale] = fmt::to_string(job.settings().image.filmScale);
  if (!job.settings().image.antialiasing) settings["antialiasing"] = "off";
  if (job.settings().image.integrator == render::Integrator::cost) settings["accel"] = structureText(job, statistics);
  return settings;
}

// Returns the reason, as a clause, why a film with another number of samples per pixel cannot be resumed by the job;
// null: it can.
const char* whyFixedCount(const RenderJob& job, std::uint32_t begunWith) {
  render::ImageSettings before = job.settings().image;
  before.sampleCount = begunWith;
  if (before.sampler == render::SamplerKind::stratified) return "the strata of --sampler stratified depend on --spp";
  if (before.jittersPixels() != job.settings().image.jittersPixels()) {
    return "rays of one sample per pixel are not jittered, and those of several are";
  }
  return nullptr;
}

// A film may be resumed with another --spp if its samples do not depend on it.
void adoptSampleCount(const RenderJob& job, const film::FilmReader& reader, film::FilmHeader& film) {
  const std::uint32_t wanted = job.settings().image.sampleCount;
  if (film.samplesPerPixel == wanted) return;
  const char* const why = whyFixedCount(job, film.samplesPerPixel);
  if (why == nullptr) {
    film.samplesPerPixel = wanted;
  } else if (!job.arguments.resumeAnyway) {
    throw FileError(fmt::format("{}: the film was started with --spp {}, and cannot be resumed with --spp {}: {}",
                                reader.file().string(), film.samplesPerPixel, wanted, why));
  }
}

// Returns the next step after a refusal. Films of other pixels cannot be resumed at all.
std::string remedyFor(const film::FilmHeader& film, const film::FilmHeader& render) {
  const std::string steps = stepsToResume(film, render);
  if (film.window != render.window && !steps.empty()) return steps;
  return steps + (steps.empty() ? "" : "; ") + "--resume-anyway resumes nevertheless, and marks the film as mixed";
}

void requireSameWindow(const film::FilmReader& film, const film::FilmHeader& header) {
  if (film.header().window == header.window) return;
  if (film.header().size != header.size) {
    throw FileError(fmt::format("{}: the film is part of an image of {} pixels, and the render of one of {}; {}",
                                film.file().string(), render::extentText(film.header().size),
                                render::extentText(header.size), stepsToResume(film.header(), header)));
  }
  throw FileError(fmt::format("{}: the film has the pixels {}, and the render {}; use --crop {}", film.file().string(),
                              render::windowText(film.header().window), render::windowText(header.window),
                              render::windowText(film.header().window)));
}

image::LayerSet withMoments(image::LayerSet layers) {
  layers.add(image::Layer::moments);
  return layers;
}

// Returns the change that gives a render the layers of a film. --denoise adds the layer `moments`.
std::string stepsToLayers(image::LayerSet film, image::LayerSet render, bool denoises) {
  const std::string aov = "--aov " + layerText(film);
  if (denoises && !film.has(image::Layer::moments)) {
    return withMoments(film) == render ? "leave out --denoise" : fmt::format("use {}, and leave out --denoise", aov);
  }
  return withMoments(render) == film ? fmt::format("use --denoise or {}", aov) : "use " + aov;
}

// Sums that samples did not add cannot be computed later, whatever the user accepts.
void requireSameLayers(const RenderJob& job, const film::FilmReader& film, const film::FilmHeader& header) {
  const image::LayerSet has = film.header().layers;
  if (has == header.layers) return;
  throw FileError(fmt::format("{}: the film has the layers {}, and the render {}; {}", film.file().string(),
                              layerText(has), layerText(header.layers),
                              stepsToLayers(has, header.layers, job.arguments.denoise)));
}

// Sums of different units cannot be added, whatever the user accepts.
void requireSameScale(const film::FilmReader& film, const film::FilmHeader& header) {
  if (film.header().filmScale() == header.filmScale()) return;
  throw FileError(fmt::format("{0}: the film has the scale {1}, and the render {2}; use --film-scale {1}",
                              film.file().string(), film.header().filmScale(), header.filmScale()));
}

template <class T>
void insertSorted(std::vector<T>& items, const T& item) {
  const auto found = std::ranges::lower_bound(items, item);
  if (found == items.end() || *found != item) items.insert(found, item);
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
      fmt::format("{0}: the film already has {1}{2} samples per pixel; use --spp {3} or more, or make a picture of it "
                  "with `candela "
                  "film {4} -o FILE`",
                  film.file().string(), isMaximum ? "up to " : "", count, isMaximum ? count : count + 1,
                  shellQuoted(film.file().string())));
}

// Returns the first sample of a film, which must be one that samples can be appended to. `isPart`: the range is that of
// --samples, rather than all samples.
std::optional<std::uint32_t> requireContinuable(const film::FilmReader& reader, const render::SampleRange& range,
                                                bool isPart) {
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
  const std::uint32_t next = endOf(film);
  if (range.first == *first && range.end >= next) return first;
  if (!isPart && *first == 0) {
    refuseFewer(reader, next, !film.begun.empty());
  }
  throw FileError(
      fmt::format("{}: the film starts at sample {} and ends before sample {}, and the render has samples {}:{}; use "
                  "--samples {}:N",
                  reader.file().string(), *first, next, range.first, range.end, *first));
}

}  // namespace

film::FilmHeader filmHeaderOf(const RenderJob& job, const render::RenderStatistics& statistics) {
  film::FilmHeader header;
  header.sceneHash = hashText(job.scene.hash);
  header.size = job.settings().image.size;
  header.samplesPerPixel = job.settings().image.sampleCount;
  header.seed = job.settings().image.seed;
  header.settings = settingsOf(job, statistics);
  header.layers = withSums(job.settings().image.layers);
  header.window = job.settings().image.window();
  header.tracers = {{film::validText(statistics.device), film::validText(statistics.driver), statistics.platform,
                     statistics.kernels, versionText()}};
  return header;
}

void setContent(film::FilmHeader& header, const image::Film& film, const scene::Scene& scene, std::uint32_t first) {
  setCoverage(header, film, first);
  header.matteNames = matteNamesOf(scene, film);
}

void continueWith(film::FilmHeader& film, const film::FilmHeader& now, bool mayDiffer) {
  const film::Tracer& tracer = now.tracers.front();
  const bool isKnown = std::ranges::find(film.tracers, tracer) != film.tracers.end();
  if (!isKnown && !mayDiffer) {
    throw DeviceLostError(fmt::format(
        "after the failure, {}", tracerDifferences(film.tracers.front(), tracer, "the film", "the device").front()));
  }
  insertSorted(film.tracers, tracer);
  for (const std::string& line : estimateDifferences(film, now, "an earlier part", "a later part")) {
    insertSorted(film.mixed, line);
  }
}

render::SampleRange samplesOf(const RenderJob& job) {
  const std::uint32_t total = job.settings().image.sampleCount;
  const render::SampleRange range = job.arguments.samples.value_or(render::SampleRange{0, total});
  if (range.end <= total) return range;
  throw UsageError(fmt::format("--samples {}:{} exceeds the {} samples per pixel; set the total with --spp",
                               range.first, range.end, total));
}

std::optional<std::uint32_t> adoptFilm(const RenderJob& job, const film::FilmReader& reader, film::FilmHeader& header,
                                       const Log& log) {
  film::FilmHeader film = reader.header();
  adoptSampleCount(job, reader, film);
  requireSameLayers(job, reader, header);
  requireSameScale(reader, header);
  std::vector<std::string> differences = estimateDifferences(film, header, "the film", "this render");
  for (const film::Tracer& tracer : film.tracers) {
    const auto more = tracerDifferences(tracer, header.tracers.front(), "the film", "this render");
    differences.insert(differences.end(), more.begin(), more.end());
  }
  if (!differences.empty() && !job.arguments.resumeAnyway) {
    throw FileError(fmt::format(
        "{}: {}{}; {}", reader.file().string(), differences.front(),
        film.sceneHash == header.sceneHash ? "" : ": a file of the scene, --env, --camera or --time differs",
        remedyFor(reader.header(), header)));
  }
  for (const std::string& difference : differences) log.warning("--resume-anyway: " + difference);
  requireSameWindow(reader, header);
  for (const std::string& line : estimateDifferences(film, header, "an earlier part", "a later part")) {
    insertSorted(header.mixed, line);
  }
  for (const std::string& line : film.mixed) insertSorted(header.mixed, line);
  for (const film::Tracer& tracer : film.tracers) insertSorted(header.tracers, tracer);
  return requireContinuable(reader, samplesOf(job), job.arguments.samples.has_value());
}

void requireNoMoreSamples(const RenderJob& job, const film::FilmReader& reader, const image::Film& film) {
  if (!reader.header().noiseThreshold()) return;
  const std::uint32_t most = std::ranges::max(film.pixels(), {}, &image::FilmPixel::sampleCount).sampleCount;
  if (most > samplesOf(job).end) refuseFewer(reader, most, true);
}

}  // namespace candela::cli
