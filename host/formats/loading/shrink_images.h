// Fits the images of textures into a limit.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/scene/texture.h"

namespace candela::scene {

/// Maximum number of texels of all images of a scene: 768 MiB of them, less than devices' records of textures can hold.
inline constexpr std::uint64_t kMaxTexels = std::uint64_t{3} << 26;

/// Halves both sides of the largest image until all images together have at most `maxTexels`, of which a texel of 16
/// bits per channel counts as two. Texels become the means of two times two, channel by channel as they are stored.
/// Returns a sentence for each image that was changed, with its name and both sizes.
std::vector<std::string> shrinkImages(std::vector<TextureImage>& images, std::uint64_t maxTexels = kMaxTexels);

}  // namespace candela::scene
