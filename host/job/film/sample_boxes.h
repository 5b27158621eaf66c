// Sets of samples: boxes of pixels and sample indices, and what is missing from them.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/base/errors.h"
#include "host/trace/render/extent.h"
#include "host/trace/render/session.h"

namespace candela::film {

/// The samples of a range, of every pixel of a window. Neither is empty.
struct SampleBox {
  render::Window window;
  render::SampleRange samples;

  bool operator==(const SampleBox&) const = default;
};

/// Maximum number of boxes in a film file. An image of 7680x4320 pixels has 129,600 tiles of 16x16 pixels, which are as
/// many boxes if some are missing and the others have different samples.
inline constexpr std::size_t kMaxBoxes = std::size_t{1} << 17;

/// Maximum number of steps that a function of this header takes: one for each band of rows and each box in it, and one
/// for each interval of columns of a band and each box in it. The tiles of 8K above, each divided into 64 ranges of
/// samples, take a quarter of them.
inline constexpr std::uint64_t kMaxBoxSteps = std::uint64_t{1} << 26;

/// Maximum number of boxes in a result.
inline constexpr std::size_t kMaxResultBoxes = 8 * kMaxBoxes;

/// Two boxes that have a sample in common.
struct OverlapError : UsageError {
  OverlapError(const SampleBox& a, const SampleBox& b) : UsageError("two boxes of samples overlap"), boxes{a, b} {}
  std::array<SampleBox, 2> boxes;
};

/// Returns the canonical list of disjoint boxes of the union: the bands of rows with equal samples, as tall as
/// possible, from the top; in each the runs of columns with equal samples, as wide as possible, from the left; for each
/// run its ranges in rising order. Sets that are equal have equal lists. Throws OverlapError if two boxes overlap, and
/// FileError if it takes more than kMaxBoxSteps or the result has more than kMaxResultBoxes.
std::vector<SampleBox> canonicalBoxes(std::span<const SampleBox> boxes);

/// Returns whether a list is what canonicalBoxes() makes of it, in a time proportional to its length.
bool isCanonical(std::span<const SampleBox> boxes);

/// Throws OverlapError unless the boxes are disjoint, and FileError if the test takes more than kMaxBoxSteps.
void requireDisjoint(std::span<const SampleBox> boxes);

/// The samples of `whole` that no box has, as canonicalBoxes() lists them. The boxes are disjoint and lie within it.
/// Throws FileError as canonicalBoxes() does.
std::vector<SampleBox> missingBoxes(std::span<const SampleBox> boxes, const SampleBox& whole);

/// E.g. "samples 64:128 of crop 0,0,32,32".
std::string boxText(const SampleBox& box);

}  // namespace candela::film
