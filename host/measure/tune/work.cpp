// Fits the work to the speed of the device, and measures candidates on it.
#include "host/measure/tune/work.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/formats/nff/nff_loader.h"
#include "host/scene/generate/kinds.h"

namespace candela::tune {
namespace {

constexpr double kFirstPixels = 128 * 128;
constexpr double kMaxSamples = 1 << 16;
// Maximum growth per step: an estimate from a hundredth of the work is too inaccurate for a single step.
constexpr double kMaxStep = 32;

scene::Scene generatedScene(std::uint32_t size) {
  const auto kinds = generate::kindTable();
  const auto kind = std::ranges::find(kinds, std::string_view("sphere"), &generate::Kind::name);
  std::string text;
  generate::generateScene(*kind, size, [&](std::string_view block) { text += block; });
  return scene::parseScene(text, fmt::format("{} triangles", kind->primitiveCount(size)), ".").scene;
}

double pixelsOf(const render::Extent& size) { return static_cast<double>(size.width) * size.height; }

// Returns a size of about this many pixels with the aspect ratio of `largest`, and not larger than it.
render::Extent shrunk(const render::Extent& largest, double pixels) {
  const double scale = std::min(1.0, std::sqrt(pixels / pixelsOf(largest)));
  const auto side = [&](std::uint32_t length) { return std::max(1u, static_cast<std::uint32_t>(length * scale)); };
  return {side(largest.width), side(largest.height)};
}

// Returns the seconds of a render, on a GPU at the clock that timed runs will have.
double secondsOf(render::Renderer& renderer, const Work& work, const render::RenderControl& control) {
  const std::unique_ptr<render::Session> session = renderer.prepare(work.scene, work.settings);
  const render::ImageSettings& image = work.settings.image;
  if (!bench::warmUp(*session, image, control) || !session->advance({0, image.sampleCount}, control)) {
    throw InterruptedError("interrupted; nothing is written");
  }
  return session->statistics().seconds["trace"];
}

// Multiplies the work by `factor`: first the number of pixels, up to its limit, then the number of samples.
void grow(double factor, const render::Extent& largest, const WorkSize& asked, render::RenderSettings& settings) {
  if (!asked.size) {
    const double before = pixelsOf(settings.image.size);
    settings.image.size = shrunk(largest, before * factor);
    factor *= before / pixelsOf(settings.image.size);
  }
  if (!asked.sampleCount) {
    settings.image.sampleCount = static_cast<std::uint32_t>(
        std::clamp(std::round(settings.image.sampleCount * factor), 1.0, kMaxSamples));
  }
}

// Maps the progress of one of several works to that of all works.
render::RenderControl shareOf(const render::RenderControl& whole, std::size_t index, std::size_t count,
                              std::uint64_t samplesOver) {
  render::RenderControl part = whole;
  if (!whole.progress) return part;
  part.progress = [&whole, index, count, samplesOver](double fraction, std::uint64_t samples) {
    whole.progress((static_cast<double>(index) + fraction) / static_cast<double>(count), samplesOver + samples);
  };
  return part;
}

}  // namespace

std::vector<scene::Scene> builtInScenes() {
  constexpr std::uint32_t kBox = 2;
  constexpr std::uint32_t kMesh = 91;
  std::vector<scene::Scene> scenes;
  for (const std::uint32_t size : {kBox, kMesh}) scenes.push_back(generatedScene(size));
  return scenes;
}

void fitToDevice(render::Renderer& renderer, const WorkSize& asked, const render::RenderControl& control, Work& work) {
  const render::Extent largest = work.settings.image.size;
  work.settings.image.size = asked.size.value_or(shrunk(largest, kFirstPixels));
  work.settings.image.sampleCount = asked.sampleCount.value_or(1);
  if (asked.size && asked.sampleCount) return;
  constexpr int kMaxSteps = 4;
  for (int step = 0; step < kMaxSteps; ++step) {
    const double seconds = secondsOf(renderer, work, control);
    if (seconds > 0.5 * kRunSeconds) return;
    grow(std::min(kMaxStep, kRunSeconds / std::max(seconds, 1e-6)), largest, asked, work.settings);
  }
}

std::vector<Row> measureWork(render::Renderer& renderer, std::span<const Work> works,
                             std::span<const Candidate> candidates, std::uint32_t repeats,
                             const render::RenderControl& control) {
  std::vector<Row> rows;
  for (const Candidate& candidate : candidates) rows.push_back({candidate, {}});
  std::uint64_t samples = 0;
  for (std::size_t w = 0; w < works.size(); ++w) {
    const Work& work = works[w];
    std::vector<bench::Variant> variants;
    for (const Candidate& candidate : candidates) {
      variants.push_back({nameOf(candidate), work.settings});
      variants.back().settings.execution.automatic = choicesOf(candidate);
      variants.back().settings.execution.automatic.origin = "tried";
    }
    std::vector<bench::Measurement> measurements = bench::measureInterleaved(
        renderer, work.scene, variants, repeats, shareOf(control, w, works.size(), samples));
    if (measurements.empty()) throw InterruptedError("interrupted; nothing is written");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      samples += repeats * measurements[i].statistics.samples;
      rows[i].scenes.push_back({work.scene.name, work.scene.hash, std::move(measurements[i])});
    }
  }
  return rows;
}

}  // namespace candela::tune
