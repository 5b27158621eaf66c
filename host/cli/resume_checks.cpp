// Compares a render with the film file that it resumes.
#include "host/cli/resume_checks.h"

#include <fmt/format.h>

#include "host/cli/film_options.h"
#include "host/cli/option_table.h"
#include "host/core/errors.h"

namespace candela::cli {
namespace {

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

}  // namespace

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

void requireSameLayers(const film::FilmReader& film, const film::FilmHeader& header) {
  if (film.header().layers == header.layers) return;
  const std::string layers = layerText(film.header().layers);
  throw FileError(fmt::format("{}: the film has the layers {}, and the render {}; use --aov {}", film.file().string(),
                              layers, layerText(header.layers), layers));
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
    throw FileError(
        fmt::format("{}: the film was merged from parts with gaps between them; render the missing parts separately, "
                    "and merge them",
                    reader.file().string()));
  }
  const std::uint32_t next = film.covered.empty() ? *first : film.covered.front().samples.end;
  if (range.first == *first && range.end >= next) return first;
  if (!isPart) {
    throw FileError(fmt::format(
        "{0}: the film already has {1} samples per pixel; use --spp {2} or more, or make a picture of it with `candela "
        "film {3} -o FILE`",
        reader.file().string(), next, next + 1, shellQuoted(reader.file().string())));
  }
  throw FileError(
      fmt::format("{}: the film starts at sample {} and ends before sample {}, and the render has samples {}:{}; use "
                  "--samples {}:N",
                  reader.file().string(), *first, next, range.first, range.end, *first));
}

}  // namespace candela::cli
