// How the kinds of lights share the probability of being sampled: docs/light-transport.md section 6.
#pragma once
#include <array>
#include <span>

#include "host/scene/scene.h"
#include "host/trace/flatten/light_table.h"

namespace candela::flatten {

/// A value for each group of lights: emitters, lights without extent, and the environment; with a light tree: its
/// lights, other lights without extent, and the environment.
using GroupValues = std::array<double, 3>;
/// Returns the group of a kind of lights.
std::size_t groupOf(LightKind kind, render::LightSelection selection);

/// Returns the probabilities of the groups, whose sum is 1, or 0 for all of them if no group has a light of positive
/// weight. `weights` are the sums of the weights of each group's lights.
GroupValues groupProbabilities(const scene::Scene& scene, std::span<const LightEntry> entries,
                               render::LightSelection selection, const GroupValues& weights);

}  // namespace candela::flatten
