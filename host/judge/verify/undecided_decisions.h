// The decisions that rounding changes in undecidable samples, and the surfaces that take part in them.
#pragma once
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/render/replay.h"
#include "host/trace/render/replicas.h"

namespace candela::verify {

/// A kind of decision at the same surfaces, in all examined pixels.
struct UndecidedDecision {
  std::string kind;                   ///< primitive, side, light, shadow, lobe, roulette or other
  std::vector<std::string> surfaces;  ///< names of objects: first the one that the ray starts on, if it starts on one
  std::string text;                   ///< a clause about the decision, with the names
  std::uint64_t pixels = 0;
  double light = 0;  ///< sum of |differences| of luminance between replica and exact sample
};

struct UndecidedDecisions {
  std::uint64_t undecidable = 0;         ///< number of pixels
  std::uint64_t examined = 0;            ///< number of them that were traced again: at most kMaxExamined
  std::vector<UndecidedDecision> kinds;  ///< by falling light, then by falling number of pixels

  /// Returns the most important kinds in words, a line each.
  std::vector<std::string> lines() const;
  nlohmann::ordered_json json() const;
};

inline constexpr std::uint32_t kMaxExamined = 256;

/// Returns the first decision in which `replica` differs from `exact`, two paths of one sample. `vertex`, from 1, is
/// the one at which their decisions differ: paths do not record the decision of kind `other`, such as a texel.
UndecidedDecision firstUndecided(const render::PathTrace& exact, const render::PathTrace& replica, std::uint32_t vertex,
                                 const scene::Scene& scene);

/// Traces undecidable pixels again. Both interfaces are those of a session that has advanced by one sample of each
/// pixel, with kReplicas replicas. `width` is that of the image.
UndecidedDecisions examineUndecided(const scene::Scene& scene, std::uint32_t width, render::SampleReplayer& replayer,
                                    render::ReplicaSource& replicas);

}  // namespace candela::verify
