// Two renderers that draw the same random numbers: an exact one, which traces replicas, and one that rounds.
#pragma once
#include <functional>
#include <random>

#include "host/image/film.h"
#include "tests/trace/render/one_shot_renderer.h"

namespace candela::verify {

/// A sample of mean 1 and deviation 1. Rounding can decide a fraction of the samples, which then are brighter by
/// `jump`: in a replica with probability 1/2, on the device always (oneWay) or with probability 1/2.
struct PairedOptions {
  double flips = 0;
  double jump = 1;
  bool oneWay = false;
  double rounding = 1e-7;  ///< relative
  /// Factor of the device's pixel x, y.
  std::function<double(std::uint32_t, std::uint32_t)> factor = [](std::uint32_t, std::uint32_t) { return 1.0; };
  double referenceFactor = 1;
  std::uint64_t truncated = 0;  ///< loops of the device that end early in images of one sample
};

enum class PairedRole { device, reference };

class PairedRenderer final : public render::Renderer {
 public:
  PairedRenderer(PairedRole role, PairedOptions options) : role_(role), options_(std::move(options)) {}

  std::unique_ptr<render::Session> prepare(const scene::Scene&, const render::RenderSettings& settings) override {
    return std::make_unique<PairedSession>(*this, settings);
  }

 private:
  class PairedSession final : public render::Session, public render::PathRecorder, public render::ReplicaSource {
   public:
    PairedSession(const PairedRenderer& renderer, const render::RenderSettings& settings)
        : renderer_(renderer), settings_(settings) {}

    bool advance(render::SampleRange range, const render::RenderControl& control) override {
      if (control.stop != nullptr && *control.stop) return false;
      const render::Extent size = settings_.image.window().extent();
      film_ = image::Film(size.width, size.height);
      const bool hasReplicas = settings_.execution.replicas > 0;
      records_.deviations.assign(hasReplicas ? std::size_t{size.width} * size.height : 0, {});
      std::mt19937 shared(settings_.image.seed);
      std::mt19937 own(settings_.image.seed ^ (renderer_.role_ == PairedRole::device ? 0x5bd1e995u : 0x1b873593u));
      for (std::uint32_t y = 0; y < size.height; ++y) {
        for (std::uint32_t x = 0; x < size.width; ++x) {
          for (std::uint32_t i = 0; i < range.end; ++i) addSample(x, y, i, shared, own);
        }
      }
      return true;
    }

    void restrictTo(const render::PixelMask&) override { throw std::logic_error("noise is traced in all pixels"); }
    image::Film film() override { return film_; }
    void reset(std::uint32_t seed, std::uint32_t sampleCount) override {
      settings_.image.seed = seed;
      settings_.image.sampleCount = sampleCount;
    }
    void setCamera(const scene::Camera&) override {}
    void setView(const scene::Camera&, const render::Extent&) override {}
    void load(const image::Film&, std::uint32_t) override {}
    render::RenderStatistics statistics() override {
      render::RenderStatistics statistics;
      const bool isTruncated = renderer_.role_ == PairedRole::device && settings_.image.sampleCount == 1;
      statistics.truncated = isTruncated ? renderer_.options_.truncated : 0;
      return statistics;
    }
    render::PathRecorder* recorder() override { return this; }
    render::PathRecords paths() override { return render::PathRecords(film_.pixels().size()); }
    render::ReplicaSource* replicaSource() override { return records_.deviations.empty() ? nullptr : this; }
    render::ReplicaRecords replicas() override { return records_; }
    render::Replica replica(const render::PixelSample&, std::uint32_t) override {
      throw std::logic_error("noise has no paths");
    }
    std::vector<render::PathTrace> replayReplicas(const render::PixelSample&, std::uint32_t) override {
      throw std::logic_error("noise has no paths");
    }

   private:
    void addSample(std::uint32_t x, std::uint32_t y, std::uint32_t index, std::mt19937& shared, std::mt19937& own) {
      const PairedOptions& options = renderer_.options_;
      const double value = std::exponential_distribution<double>()(shared);
      const bool mayFlip = static_cast<double>(shared()) * 0x1p-32 < options.flips;
      const bool isUp = own() % 2 == 0;
      const double error = options.rounding * value * (own() % 2 == 0 ? 1 : -1);
      if (renderer_.role_ == PairedRole::device) {
        const double jump = mayFlip && (options.oneWay || isUp) ? options.jump : 0;
        film_.addSample(x, y, glm::dvec3((value + jump + error) * options.factor(x, y)), index);
        return;
      }
      film_.addSample(x, y, glm::dvec3(value * options.referenceFactor), index);
      if (records_.deviations.empty()) return;
      const double deviation = std::abs(error) + (mayFlip && isUp ? options.jump : 0);
      render::Deviation& sum = records_.deviations[std::size_t{y} * film_.width() + x];
      sum.magnitude += deviation;
      sum.lean += error + (mayFlip && isUp ? options.jump : 0);
    }

    const PairedRenderer& renderer_;
    render::RenderSettings settings_;
    image::Film film_;
    render::ReplicaRecords records_;
  };

  PairedRole role_;
  PairedOptions options_;
};

}  // namespace candela::verify
