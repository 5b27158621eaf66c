// Sets of samples: boxes of pixels and sample indices, and what is missing from them.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "host/render/extent.h"
#include "host/render/session.h"

namespace candela::film {

/// The samples of a range, of every pixel of a window. Neither is empty.
struct SampleBox {
  render::Window window;
  render::SampleRange samples;

  bool operator==(const SampleBox&) const = default;
};

/// Returns whether two boxes have a sample in common.
bool overlap(const SampleBox& a, const SampleBox& b);

/// Returns the canonical list of disjoint boxes of the union: the bands of rows with equal samples, as tall as
/// possible, from the top; in each the runs of columns with equal samples, as wide as possible, from the left; for each
/// run its ranges in rising order. Sets that are equal have equal lists. Throws UsageError if two boxes overlap.
std::vector<SampleBox> canonicalBoxes(std::span<const SampleBox> boxes);

/// The samples of `whole` that no box has, as canonicalBoxes() lists them. The boxes are disjoint and lie within it.
std::vector<SampleBox> missingBoxes(std::span<const SampleBox> boxes, const SampleBox& whole);

/// E.g. "samples 64:128 of crop 0,0,32,32".
std::string boxText(const SampleBox& box);

}  // namespace candela::film
