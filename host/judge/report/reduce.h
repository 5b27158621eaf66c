// Reduces pictures that are too large for a page.
#pragma once
#include <cstdint>

#include "host/image/image.h"

namespace candela::report {

/// Maximum number of pixels on a page, where their values take 32 MB.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 20;

/// Returns the minimum k such that there are at most kMaxPixels blocks of k x k pixels; 1 for small images.
std::uint32_t reductionOf(std::uint32_t width, std::uint32_t height);

/// Returns the means of blocks of k x k pixels, cut at the right and lower edge. Only colours are computed, not
/// variances and counts.
image::Image reduced(const image::Image& image, std::uint32_t k);

}  // namespace candela::report
