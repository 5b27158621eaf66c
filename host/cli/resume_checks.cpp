// Compares a render with the film file that it resumes.
#include "host/cli/resume_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/film_identity.h"
#include "host/cli/film_options.h"
#include "host/cli/option_table.h"
#include "host/core/errors.h"

namespace candela::cli {
namespace {

// Returns the reason, as a clause, why a film with another number of samples per pixel cannot be resumed by the job;
// null: it can.
const char* whyFixedCount(const RenderJob& job, std::uint32_t begunWith) {
  render::ImageSettings before = job.settings.image;
  before.sampleCount = begunWith;
  if (before.sampler == render::SamplerKind::stratified) return "the strata of --sampler stratified depend on --spp";
  if (before.jittersPixels() != job.settings.image.jittersPixels()) {
    return "rays of one sample per pixel are not jittered, and those of several are";
  }
  return nullptr;
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
                  "with `candela film {4} -o FILE`",
                  film.file().string(), isMaximum ? "up to " : "", count, isMaximum ? count : count + 1,
                  shellQuoted(film.file().string())));
}

}  // namespace

void adoptSampleCount(const RenderJob& job, const film::FilmReader& reader, film::FilmHeader& film) {
  const std::uint32_t wanted = job.settings.image.sampleCount;
  if (film.samplesPerPixel == wanted) return;
  const char* const why = whyFixedCount(job, film.samplesPerPixel);
  if (why == nullptr) {
    film.samplesPerPixel = wanted;
  } else if (!job.arguments.resumeAnyway) {
    throw FileError(fmt::format("{}: the film was started with --spp {}, and cannot be resumed with --spp {}: {}",
                                reader.file().string(), film.samplesPerPixel, wanted, why));
  }
}

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

void requireSameLayers(const RenderJob& job, const film::FilmReader& film, const film::FilmHeader& header) {
  const image::LayerSet has = film.header().layers;
  if (has == header.layers) return;
  throw FileError(fmt::format("{}: the film has the layers {}, and the render {}; {}", film.file().string(),
                              layerText(has), layerText(header.layers),
                              stepsToLayers(has, header.layers, job.arguments.denoise)));
}

void requireSameScale(const film::FilmReader& film, const film::FilmHeader& header) {
  if (film.header().filmScale() == header.filmScale()) return;
  throw FileError(fmt::format("{0}: the film has the scale {1}, and the render {2}; use --film-scale {1}",
                              film.file().string(), film.header().filmScale(), header.filmScale()));
}

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
  if (!isPart && *first == 0) refuseFewer(reader, next, !film.begun.empty());
  throw FileError(
      fmt::format("{}: the film starts at sample {} and ends before sample {}, and the render has samples {}:{}; use "
                  "--samples {}:N",
                  reader.file().string(), *first, next, range.first, range.end, *first));
}

void requireNoMoreSamples(const RenderJob& job, const film::FilmReader& reader, const image::Film& film) {
  if (!reader.header().noiseThreshold()) return;
  const std::uint32_t maxCount = std::ranges::max(film.pixels(), {}, &image::FilmPixel::sampleCount).sampleCount;
  if (maxCount > samplesOf(job).end) refuseFewer(reader, maxCount, true);
}

}  // namespace candela::cli
