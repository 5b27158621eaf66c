// Renders batches with different seeds, and adds up the means of their regions.
#include "host/judge/verify/batches.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/hash.h"

namespace candela::verify {
namespace {

// One step of SplitMix64.
std::uint64_t mix(std::uint64_t value) { return splitMix(value + kSplitMixStep); }

}  // namespace

std::uint32_t batchSeed(std::uint32_t runSeed, Side side, std::uint32_t batch, std::uint32_t look) {
  const std::uint64_t index = (std::uint64_t{look} << 33) + (std::uint64_t{batch} << 1) +
                              static_cast<std::uint32_t>(side);
  return static_cast<std::uint32_t>(mix(mix(runSeed) + index) >> 32);
}

Batches::Batches(Side side, render::Renderer& renderer, const scene::Scene& scene,
                 const render::RenderSettings& settings, std::span<const Region> regions)
    : side_(side),
      renderer_(renderer),
      scene_(scene),
      settings_(settings),
      runSeed_(settings.image.seed),
      regions_(regions) {
  for (std::vector<double>& sums : sums_) sums.resize(regions.size());
}

// One session serves all batches and looks, which have different random numbers.
bool Batches::render(std::uint32_t samples, std::uint32_t look, const render::RenderControl& control) {
  samples = std::max(samples, minBatchSamples(settings_.image.integrator));
  settings_.image.sampleCount = samples;
  for (std::uint32_t batch = 0; batch < kBatchCount; ++batch) {
    settings_.image.seed = batchSeed(runSeed_, side_, batch, look);
    session_->reset(settings_.image.seed, samples);
    if (!session_->advance({0, samples}, control)) return false;
    statistics_ = session_->statistics();
    render::requireComplete(statistics_);
    const image::Film film = session_->film();
    if (excuses_) excuses_->add(film, film, deviationsOf(*session_));
    addFilm(film, batch);
  }
  samples_ += samples;
  return true;
}

void Batches::addFilm(const image::Film& film, std::uint32_t batch) {
  badSamples_.add(film, settings_.image);
  if (!film_.pixels().empty()) film_.merge(film);
  for (std::size_t i = 0; i < regions_.size(); ++i) {
    sums_[batch][i] += settings_.image.sampleCount * regionMean(film, regions_[i]);
  }
}

std::array<double, kBatchCount> Batches::means(std::size_t region) const {
  std::array<double, kBatchCount> means{};
  for (std::uint32_t batch = 0; batch < kBatchCount; ++batch) {
    means[batch] = sums_[batch][region] / static_cast<double>(samples_);
  }
  return means;
}

}  // namespace candela::verify
