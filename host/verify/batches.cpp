// Renders batches with different seeds, and adds up the means of their regions.
#include "host/verify/batches.h"

#include <fmt/format.h>

#include "host/core/errors.h"

namespace candela::verify {
namespace {

std::uint64_t mix(std::uint64_t value) {
  value += 0x9e3779b97f4a7c15u;
  value = (value ^ (value >> 30)) * 0xbf58476d1ce4e5b9u;
  value = (value ^ (value >> 27)) * 0x94d049bb133111ebu;
  return value ^ (value >> 31);
}

}  // namespace

std::uint32_t batchSeed(std::uint32_t runSeed, Side side, std::uint32_t batch, std::uint32_t look) {
  const std::uint64_t place = (std::uint64_t{look} * kBatchCount + batch) * 2 + static_cast<std::uint32_t>(side);
  return static_cast<std::uint32_t>(mix(mix(runSeed) + place) >> 32);
}

Batches::Batches(Side side, render::Renderer& renderer, const scene::Scene& scene,
                 const render::RenderSettings& settings, std::span<const Region> regions)
    : side_(side), renderer_(renderer), scene_(scene), settings_(settings), runSeed_(settings.seed), regions_(regions) {
  for (std::vector<double>& sums : sums_) sums.resize(regions.size());
}

bool Batches::render(std::uint32_t samples, std::uint32_t look, const render::RenderControl& control) {
  settings_.sampleCount = samples;
  for (std::uint32_t batch = 0; batch < kBatchCount; ++batch) {
    settings_.seed = batchSeed(runSeed_, side_, batch, look);
    render::RenderResult result = renderer_.render(scene_, settings_, control);
    if (result.interrupted) return false;
    statistics_ = std::move(result.statistics);
    badSamples_ += statistics_.badSamples;
    if (statistics_.truncated > 0) {
      throw InternalError(fmt::format("{} loops ended before their work was done", statistics_.truncated));
    }
    if (!film_.pixels().empty()) film_.merge(result.film);
    for (std::size_t i = 0; i < regions_.size(); ++i) {
      sums_[batch][i] += samples * regionMean(result.film, regions_[i]);
    }
  }
  samples_ += samples;
  return true;
}

std::array<double, kBatchCount> Batches::means(std::size_t region) const {
  std::array<double, kBatchCount> means{};
  for (std::uint32_t batch = 0; batch < kBatchCount; ++batch) {
    means[batch] = sums_[batch][region] / static_cast<double>(samples_);
  }
  return means;
}

}  // namespace candela::verify
