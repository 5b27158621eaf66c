// Writes the report on bad samples, and the commands that replay them.
#include "host/app/cli/bad_samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/app/cli/option_table.h"
#include "host/base/counted.h"

namespace candela::cli {
namespace {

using nlohmann::ordered_json;

// The number of samples is always stated, since the default could be that of the scene file, which may not include the
// sample.
std::string sceneAndOptions(const render::BadPixel& pixel, std::uint32_t sampleCount, RenderArguments arguments) {
  arguments.request.sampleCount.reset();
  arguments.film.noiseThreshold.reset();  // the sample is the same without it
  arguments.request.image.seed = pixel.seed;
  std::string words = shellQuoted(arguments.files.front());
  for (const OptionGroup group : {OptionGroup::image, OptionGroup::sceneFile, OptionGroup::execution}) {
    const std::string options = commandLineOf(arguments, group, true);
    if (!options.empty()) words += " " + options;
  }
  return fmt::format("{} --spp {}", words, sampleCount);
}

// A sample depends on earlier ones only through the film, so that the image can end with it. Strata depend on the
// number of samples, so that all are rendered. An image with a single sample might not be jittered.
std::uint32_t samplesToRepeat(const render::BadPixel& pixel, const render::RenderSettings& settings) {
  if (settings.image.sampler == render::SamplerKind::stratified || pixel.sampleCount == 1) return pixel.sampleCount;
  return std::max(pixel.firstSample + 1, 2u);
}

std::string renderAgain(const render::BadPixel& pixel, const RenderJob& job) {
  const std::uint32_t sampleCount = samplesToRepeat(pixel, job.settings);
  return fmt::format("candela render {} -o replay.exr", sceneAndOptions(pixel, sampleCount, statedArguments(job)));
}

// `explain` compares a device with the reference, so that --device cpu is omitted.
std::string explainPath(const render::BadPixel& pixel, const RenderJob& job) {
  RenderArguments arguments = statedArguments(job);
  if (arguments.usesReference()) arguments.device.clear();
  return fmt::format("candela explain {} --pixel {},{} --sample {}",
                     sceneAndOptions(pixel, pixel.sampleCount, std::move(arguments)), pixel.x, pixel.y,
                     pixel.firstSample);
}

std::string pixelLine(const render::BadPixel& pixel, const RenderJob& job) {
  return fmt::format("pixel ({}, {}): {} bad, the first is sample {}; replay: {}", pixel.x, pixel.y, pixel.badCount,
                     pixel.firstSample, replayCommand(pixel, job));
}

}  // namespace

std::string replayCommand(const render::BadPixel& pixel, const RenderJob& job) {
  return job.settings.image.integrator == render::Integrator::path ? explainPath(pixel, job) : renderAgain(pixel, job);
}

std::vector<std::string> badSampleLines(const render::BadSampleTally& tally, const RenderJob& job) {
  if (tally.samples() == 0) return {};
  const std::uint32_t scale = job.settings.image.filmScale;
  std::vector<std::string> lines{
      fmt::format("bad samples: {} in {}, not finite or negative (they count as 0) or above 2^{} (they are clamped{})",
                  counted(tally.samples(), "sample"), counted(tally.pixels(), "pixel"), 20 + scale,
                  scale < image::kMaxFilmScale ? "; --film-scale raises this limit" : "")};
  for (const render::BadPixel& pixel : tally.firstPixels()) lines.push_back(pixelLine(pixel, job));
  return lines;
}

ordered_json badSamplesJson(const render::BadSampleTally& tally) {
  ordered_json pixels = ordered_json::array();
  for (const render::BadPixel& pixel : tally.firstPixels()) {
    pixels.push_back({{"x", pixel.x}, {"y", pixel.y}, {"samples", pixel.badCount}, {"firstSample", pixel.firstSample}});
  }
  return {{"samples", tally.samples()}, {"pixels", tally.pixels()}, {"firstPixels", pixels}};
}

ordered_json badSamplesJson(const render::BadSampleTally& tally, const RenderJob& job) {
  ordered_json json = badSamplesJson(tally);
  for (std::size_t i = 0; i < tally.firstPixels().size(); ++i) {
    json["firstPixels"][i]["replay"] = replayCommand(tally.firstPixels()[i], job);
  }
  return json;
}

ordered_json badSamplesJson(const render::BadSampleTallies& tallies, const RenderJob& job) {
  return {{"device", badSamplesJson(tallies.device, job)}, {"reference", badSamplesJson(tallies.reference, job)}};
}

void reportBadSamples(const render::BadSampleTallies& tallies, const RenderJob& job, const Log& log) {
  for (const std::string& line : badSampleLines(tallies.device, job)) log.problem("device: " + line);
  for (const std::string& line : badSampleLines(tallies.reference, job)) log.problem("reference: " + line);
}

ExitCode strictly(ExitCode code, std::uint64_t badSamples, const StrictArguments& arguments, const Log& log) {
  if (!arguments.strict || badSamples == 0) return code;
  log.problem(
      fmt::format("--strict: the run fails because of {} bad samples; its files are still written", badSamples));
  return code == ExitCode::done || code == ExitCode::undecided ? ExitCode::differ : code;
}

}  // namespace candela::cli
