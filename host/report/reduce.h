// Pictures that are too large for a page are shown smaller.
#pragma once
#include <cstdint>

#include "host/image/image.h"

namespace candela::report {

/// Pixels that a page shows: their values take 32 MB in it.
inline constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 20;

/// The smallest k such that blocks of k x k pixels are no more than kMostPixels; 1 for what is small enough.
std::uint32_t reductionOf(std::uint32_t width, std::uint32_t height);

/// Means of blocks of k x k pixels, cut at the right and lower edge; colours alone, without variance and counts.
image::Image reduced(const image::Image& image, std::uint32_t k);

}  // namespace candela::report
