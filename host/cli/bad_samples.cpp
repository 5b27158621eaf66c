// Finds bad samples in the film's counts.
#include "host/cli/bad_samples.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/cli/option_table.h"

namespace candela::cli {
namespace {

constexpr std::size_t kPixelsShown = 5;

// A sample depends on those before it in nothing but the film, so the replay ends with it. Strata depend on the number
// of samples: there all are replayed. A single sample may be one that is not jittered.
std::string replayCommand(const RenderJob& job, std::uint32_t sample) {
  Arguments replay = job.arguments;
  const std::uint32_t fewest = job.settings.integrator != Integrator::path && job.settings.jittersPixels() ? 2 : 1;
  if (job.settings.sampler != SamplerKind::stratified) replay.sampleCount = std::max(sample + 1, fewest);
  std::string command = "candela render " + shellQuoted(job.arguments.files.front());
  for (const OptionGroup group : {OptionGroup::image, OptionGroup::sceneFile, OptionGroup::execution}) {
    const std::string options = commandLineOf(replay, group, true);
    if (!options.empty()) command += " " + options;
  }
  return command + " -o replay.exr";
}

std::string pixelLine(const RenderJob& job, std::uint32_t x, std::uint32_t y, const FilmPixel& pixel) {
  const std::uint32_t sample = pixel.firstBadSample - 1;
  return fmt::format("pixel ({}, {}): {} bad, the first is sample {}; replay: {}", x, y, pixel.badCount, sample,
                     replayCommand(job, sample));
}

}  // namespace

std::vector<std::string> badSampleReport(const Film& film, const RenderJob& job) {
  std::uint64_t total = 0;
  std::uint64_t pixelCount = 0;
  std::vector<std::string> lines(1);
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      const FilmPixel& pixel = film.at(x, y);
      if (pixel.badCount == 0) continue;
      total += pixel.badCount;
      ++pixelCount;
      if (lines.size() <= kPixelsShown) lines.push_back(pixelLine(job, x, y, pixel));
    }
  }
  if (total == 0) return {};
  lines[0] = fmt::format("{} samples in {} pixels were not finite (they count as 0) or too bright (they are clamped)",
                         total, pixelCount);
  return lines;
}

}  // namespace candela::cli
