// How the kinds of lights share the probability of being sampled: docs/light-transport.md section 6.
#pragma once
#include <array>

#include "host/scene/scene.h"

namespace candela::flatten {

/// A value for each group of lights: emitters, lights without extent, and the environment.
using GroupValues = std::array<double, 3>;

/// Returns the probabilities of the groups, whose sum is 1, or 0 for all of them if no group has a light of positive
/// weight. `weights` are the sums of the weights of each group's lights.
GroupValues groupProbabilities(const scene::Scene& scene, const GroupValues& weights);

}  // namespace candela::flatten
