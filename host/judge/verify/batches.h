// The batches of one side: independent renders of one scene, of which only the means over regions are stored.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "host/judge/verify/paired_sums.h"
#include "host/judge/verify/regions.h"
#include "host/trace/render/bad_sample_tally.h"
#include "host/trace/render/film_coverage.h"
#include "host/trace/render/renderer.h"

namespace candela::verify {

inline constexpr std::uint32_t kBatchCount = 32;

enum class Side : std::uint32_t { device = 0, reference = 1 };

/// Returns a different seed for every side, batch and look of a run, by SplitMix64's finaliser (Steele et al., OOPSLA
/// 2014).
std::uint32_t batchSeed(std::uint32_t runSeed, Side side, std::uint32_t batch, std::uint32_t look);

/// Returns the minimum number of samples per pixel with which batches differ: most integrators do not jitter a single
/// sample, so that it would be the same with every seed.
constexpr std::uint32_t minBatchSamples(render::Integrator integrator) {
  return integrator == render::Integrator::path ? 1 : 2;
}

class Batches {
 public:
  /// The arguments that are references must outlive the object.
  Batches(Side side, render::Renderer& renderer, const scene::Scene& scene, const render::RenderSettings& settings,
          std::span<const Region> regions);

  /// Prepares the session of all batches. Must be called once, before render(). Throws as Renderer::prepare() does.
  void prepare() { session_ = renderer_.prepare(scene_, settings_); }
  /// Adds `samples` samples per pixel, or minBatchSamples() if these are more, to every batch. Returns false if
  /// `control` stopped it; the batches are then unequal and useless. Throws the exceptions of Renderer::render, and
  /// InternalError if work was truncated.
  bool render(std::uint32_t samples, std::uint32_t look, const render::RenderControl& control);

  /// Returns the number of samples per pixel of each batch so far.
  std::uint64_t samples() const { return samples_; }
  /// Stores the sum of all batches from now on, in a film of 64 bytes per pixel.
  void keepFilm() { film_ = render::emptyFilm(settings_.image, settings_.image.size); }
  /// Adds what the replicas of all batches from now on excuse to `excuses`, which must outlive the object. The settings
  /// must request a replica.
  void noteExcuses(PairedSums& excuses) { excuses_ = &excuses; }
  image::Film takeFilm() { return std::move(film_); }
  /// Returns the batches' means of one region.
  std::array<double, kBatchCount> means(std::size_t region) const;
  /// Statistics of the last batch.
  const render::RenderStatistics& statistics() const { return statistics_; }
  const render::BadSampleTally& badSamples() const { return badSamples_; }

 private:
  void addFilm(const image::Film& film, std::uint32_t batch);

  Side side_;
  render::Renderer& renderer_;
  const scene::Scene& scene_;
  render::RenderSettings settings_;
  std::uint32_t runSeed_;
  std::unique_ptr<render::Session> session_;  ///< null before prepare()
  std::span<const Region> regions_;
  std::uint64_t samples_ = 0;
  render::BadSampleTally badSamples_;
  PairedSums* excuses_ = nullptr;
  image::Film film_;                                   ///< empty unless it is kept
  std::array<std::vector<double>, kBatchCount> sums_;  ///< by region: mean times samples
  render::RenderStatistics statistics_;
};

}  // namespace candela::verify
