// Surfaces whose index of refraction differs between red, green and blue: docs/light-transport.md section 5.13.
#pragma once
#include <array>

#include "host/trace/reference/surface_bsdf.h"

namespace candela::reference {

/// The channel by which a direction is sampled, and the probabilities with which each of the three would have been.
struct ChannelChoice {
  std::size_t channel;
  dvec3 probabilities;
};

/// Chooses in proportion to the throughput, whose channels are at least 0. `number` is in [0, 1).
ChannelChoice chooseChannel(const dvec3& throughput, double number);

/// Returns the surface as it refracts light of one channel.
scene::SurfaceParameters inChannel(const scene::SurfaceParameters& surface, std::size_t channel);

/// The three surfaces as seen from one direction, whose lobes are sampled by that of the choice.
class DispersiveBsdf {
 public:
  /// `choice` states the channel; the other arguments are those of SurfaceBsdf.
  DispersiveBsdf(const scene::SurfaceParameters& surface, const dvec3& wo, bool outside, bool isCoatAlone,
                 const ChannelChoice& choice);

  const SurfaceBsdf& chosen() const { return channels_[choice_.channel]; }
  /// Returns f of each channel, and the density of a choice that is followed by the sampling of its surface.
  BsdfValue evaluate(const dvec3& wi) const {
    return mixed([&](const SurfaceBsdf& surface) { return surface.evaluate(wi); });
  }
  /// Returns SurfaceBsdf::diffuseLobe(), mixed over the channels like evaluate().
  BsdfValue diffuseLobe() const {
    return mixed([](const SurfaceBsdf& surface) { return surface.diffuseLobe(); });
  }

 private:
  template <class Evaluate>
  BsdfValue mixed(Evaluate&& evaluate) const {
    BsdfValue mixture;
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const auto channel = static_cast<glm::length_t>(i);
      const BsdfValue value = evaluate(channels_[i]);
      mixture.f[channel] = value.f[channel];
      mixture.pdf += choice_.probabilities[channel] * value.pdf;
    }
    return mixture;
  }

  ChannelChoice choice_;
  std::array<SurfaceBsdf, 3> channels_;
};

}  // namespace candela::reference
