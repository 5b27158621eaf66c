// The replicas of an artificial reference: every pixel has one decision, which rounding may change.
#pragma once
#include <random>
#include <stdexcept>

#include "host/judge/verify/decisions.h"
#include "host/trace/render/extent.h"
#include "host/trace/render/replicas.h"

namespace candela::verify {

/// A pixel shows `left` or, with probability `share` in each replica, `right`; `noise` is the relative rounding of
/// both.
struct MadePixel {
  double left = 1;
  double right = 1;
  double share = 0;
  double noise = 1e-7;
};

class MadeReplicas final : public render::ReplicaSource {
 public:
  MadeReplicas(render::Extent size, std::vector<MadePixel> pixels, unsigned seed)
      : size_(size), pixels_(std::move(pixels)), seed_(seed) {}

  render::ReplicaRecords replicas() override {
    render::ReplicaRecords records;
    for (std::uint32_t i = 0; i < pixels_.size(); ++i) {
      for (std::uint32_t k = 0; k < kReplicas; ++k) {
        records.replicas.push_back(replica({i % size_.width, i / size_.width, 0}, k));
      }
    }
    return records;
  }

  render::Replica replica(const render::PixelSample& sample, std::uint32_t index) override {
    ++traced;
    return made(pixels_[sample.y * size_.width + sample.x], {seed_, sample.x, sample.y, index});
  }

  std::vector<render::PathTrace> replayReplicas(const render::PixelSample&, std::uint32_t) override {
    throw std::logic_error("not made");
  }

  /// Returns the value of a correct tracer: that of a replica with other random numbers.
  static render::Replica made(const MadePixel& pixel, std::initializer_list<unsigned> seeds) {
    std::seed_seq sequence(seeds);
    std::mt19937 random(sequence);
    const bool right = static_cast<double>(random()) * 0x1p-32 < pixel.share;
    const double error = std::normal_distribution<double>(0, pixel.noise)(random);
    return {glm::dvec3((right ? pixel.right : pixel.left) * (1 + error)), right ? 2u : 1u, right ? 3u : 0u, 100};
  }

  std::uint64_t traced = 0;

 private:
  render::Extent size_;
  std::vector<MadePixel> pixels_;
  unsigned seed_;
};

}  // namespace candela::verify
