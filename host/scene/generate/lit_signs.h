// Pictures of lit signs.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace candela::generate {

/// Number of pictures.
inline constexpr std::size_t kSignCount = 6;

/// 8-bit sRGB pixels, as GltfDocument::addTexture() takes them.
struct SignPicture {
  static constexpr std::uint32_t kWidth = 148, kHeight = 44;
  std::vector<std::byte> rgb;
};

/// Returns `kSignCount` pictures of bright words on darker grounds, each with colours of its own.
std::vector<SignPicture> signPictures();

}  // namespace candela::generate
