// Maps of the tests of tiles.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/image/image.h"
#include "host/judge/verify/region_result.h"

namespace candela::report {

/// Returns the sizes of tiles among the results, ascending.
std::vector<std::uint32_t> tileSizes(std::span<const verify::RegionResult> results);

/// Draws each tile of one size as a block of colour, in an image of width x height pixels: black where the t of its
/// test is 0, orange where the first image is brighter and blue where it is darker, full strength at the critical t.
/// Tiles that differ significantly have a white frame.
image::Pixels8 tileMap(std::span<const verify::RegionResult> results, std::uint32_t tileSize, double level,
                       std::uint32_t width, std::uint32_t height);

}  // namespace candela::report
