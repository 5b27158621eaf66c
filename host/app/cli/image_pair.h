// The comparison of two images: figures, FLIP and a verdict.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "host/app/cli/image_verdict.h"
#include "host/image/flip.h"
#include "host/image/metrics.h"

namespace candela::cli {

/// The bad samples of an image file, whose commands are unknown.
struct ImageBadSamples {
  struct Pixel {
    std::int64_t x, y;  ///< in the plane of the picture
    std::uint32_t samples;
  };
  std::uint64_t samples = 0;
  std::uint64_t pixels = 0;
  std::vector<Pixel> firstPixels;  ///< at most as many as BadSampleTally stores, row by row
};

struct ImagePair {
  /// Where the pixels are that are compared, and the frame of both pictures.
  image::PixelBox window, frame;
  image::ImageComparison comparison;
  image::ChannelComparison channels;
  image::FlipResult flip;
  ImageVerdict verdict;
  ImageBadSamples badInA, badInB;

  std::uint64_t badSamples() const { return badInA.samples + badInB.samples; }
};

/// Cuts both images to their common window, and compares `a` with `reference` by the options of `arguments`. If they
/// have none (image::whyApart), the images stay as they are, and there are no figures but the verdict. Throws
/// UsageError if a channel of --channels is missing, or as judgeImages() does.
ImagePair comparePair(const CompareArguments& arguments, image::Image& a, image::Image& reference);

/// Returns lines, each ending in a newline.
std::string toText(const ImagePair& pair);
nlohmann::ordered_json toJson(const ImagePair& pair);

}  // namespace candela::cli
