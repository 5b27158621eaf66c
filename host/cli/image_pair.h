// The comparison of two images: figures, FLIP and a verdict.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/cli/image_verdict.h"
#include "host/image/flip.h"
#include "host/image/metrics.h"

namespace candela::cli {

struct ImagePair {
  image::ImageComparison comparison;
  image::FlipResult flip;
  ImageVerdict verdict;
  std::uint64_t badSamples = 0;  ///< of both images
};

/// Compares `a` with `reference` by the options of `arguments`. Throws UsageError if the sizes differ, or as
/// judgeImages() does.
ImagePair comparePair(const Arguments& arguments, const image::Image& a, const image::Image& reference);

/// Returns lines, each ending in a newline.
std::string toText(const ImagePair& pair);
nlohmann::ordered_json toJson(const ImagePair& pair);

}  // namespace candela::cli
