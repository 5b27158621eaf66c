// The comparison of two images: figures, FLIP and a verdict.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/cli/image_verdict.h"
#include "host/image/flip.h"
#include "host/image/metrics.h"

namespace candela::cli {

/// The bad samples of an image file, whose commands are unknown.
struct ImageBadSamples {
  struct Pixel {
    std::uint32_t x, y, samples;
  };
  std::uint64_t samples = 0;
  std::uint64_t pixels = 0;
  std::vector<Pixel> firstPixels;  ///< at most as many as BadSampleTally stores, row by row
};

struct ImagePair {
  image::ImageComparison comparison;
  image::FlipResult flip;
  ImageVerdict verdict;
  ImageBadSamples badInA, badInB;

  std::uint64_t badSamples() const { return badInA.samples + badInB.samples; }
};

/// Compares `a` with `reference` by the options of `arguments`. Throws UsageError if the sizes differ, or as
/// judgeImages() does.
ImagePair comparePair(const Arguments& arguments, const image::Image& a, const image::Image& reference);

/// Returns lines, each ending in a newline.
std::string toText(const ImagePair& pair);
nlohmann::ordered_json toJson(const ImagePair& pair);

}  // namespace candela::cli
