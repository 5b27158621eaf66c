// Replicas of samples by stochastic arithmetic, which show what single precision can decide, and how large its errors
// may be. Only the reference traces them (ExecutionSettings::replicas).
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "host/trace/render/path_trace.h"

namespace candela::render {

/// A sample traced again with every quantity perturbed by its rounding error.
struct Replica {
  glm::dvec3 radiance{0};
  std::uint64_t decisions = 0;  ///< hash of all decisions
  /// Vertex or node, from 1, at which decisions first differ from those of the exact sample; 0: none do.
  std::uint32_t vertex = 0;
  /// Distance of its ray from the exact one, in units of 2^-24 of their coordinates: at `vertex`, or at the last one.
  float amplification = 0;
  /// The same distance, along a segment of the path, in units of one rounding of the path's largest coordinate: how far
  /// the geometry has spread errors, at any distance from the origin.
  float growth = 0;
};

/// Differences of replica 1 from the exact sample, summed over the samples of a pixel: red, green, blue, luminance.
struct Deviation {
  glm::dvec4 magnitude{0};      ///< sum of |difference| over samples whose errors are not amplified
  glm::dvec4 lean{0};           ///< sum of the differences of the same samples, with their signs
  glm::dvec4 drift{0};          ///< sum of the differences of all other samples
  std::uint32_t undecided = 0;  ///< number of samples whose decisions differ
  std::uint32_t amplified = 0;  ///< number of samples with amplified errors
};

struct ReplicaRecords {
  std::vector<Replica> replicas;      ///< ExecutionSettings::replicas for each pixel, of its sample 0
  std::vector<Deviation> deviations;  ///< one per pixel
};

/// Traces replicas of the samples of a session: Session::replicaSource().
class ReplicaSource {
 public:
  /// Returns the replicas of the samples that advance() added.
  virtual ReplicaRecords replicas() = 0;
  /// Traces replica `index`, from 0, of one sample. Those of replicas() are the first ones.
  virtual Replica replica(const PixelSample& sample, std::uint32_t index) = 0;
  /// Returns the paths of the first `count` replicas of a sample, like SampleReplayer::replay() for the exact one. The
  /// session must have a replayer.
  virtual std::vector<PathTrace> replayReplicas(const PixelSample& sample, std::uint32_t count) = 0;

 protected:
  ~ReplicaSource() = default;
};

}  // namespace candela::render
