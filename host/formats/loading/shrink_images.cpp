// Halves images.
#include "host/formats/loading/shrink_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/base/quote.h"

namespace candela::scene {
namespace {

/// The mean of each channel of four texels, rounded to the nearest value. Channels have a fourth of the texel's bits.
template <class Texel>
Texel meanOf(const Texel (&texels)[4]) {
  constexpr int kBits = 2 * sizeof(Texel);
  constexpr Texel kMask = (Texel{1} << kBits) - 1;
  Texel mean = 0;
  for (int shift = 0; shift < 4 * kBits; shift += kBits) {
    Texel sum = 2;
    for (const Texel texel : texels) sum += texel >> shift & kMask;
    mean |= sum / 4 << shift;
  }
  return mean;
}

/// The texels of `image`, in one of its arrays, averaged to the size of `half`. An odd last row or column is averaged
/// with itself.
template <class Texel>
std::vector<Texel> halved(const std::vector<Texel>& texels, const TextureImage& image, const TextureImage& half) {
  std::vector<Texel> means;
  if (texels.empty()) return means;
  means.reserve(std::size_t{half.width} * half.height);
  const auto texelAt = [&](std::uint32_t x, std::uint32_t y) {
    return texels[std::size_t{std::min(y, image.height - 1)} * image.width + std::min(x, image.width - 1)];
  };
  for (std::uint32_t y = 0; y < half.height; ++y) {
    for (std::uint32_t x = 0; x < half.width; ++x) {
      means.push_back(meanOf({texelAt(2 * x, 2 * y), texelAt(2 * x + 1, 2 * y), texelAt(2 * x, 2 * y + 1),
                              texelAt(2 * x + 1, 2 * y + 1)}));
    }
  }
  return means;
}

TextureImage halved(const TextureImage& image) {
  TextureImage half{image.name, std::max(image.width / 2, 1u), std::max(image.height / 2, 1u), {}};
  half.texels = halved(image.texels, image, half);
  half.deepTexels = halved(image.deepTexels, image, half);
  return half;
}

/// Size in texels of 8 bits per channel.
std::uint64_t sizeOf(const TextureImage& image) { return image.texels.size() + 2 * image.deepTexels.size(); }

std::string sizeText(const TextureImage& image) { return fmt::format("{} x {}", image.width, image.height); }

}  // namespace

std::vector<std::string> shrinkImages(std::vector<TextureImage>& images, std::uint64_t maxTexels) {
  std::uint64_t total = 0;
  for (const TextureImage& image : images) total += sizeOf(image);
  std::map<std::size_t, std::string> former;  // sizes, by index
  while (total > maxTexels) {
    const auto largest = std::ranges::max_element(images, {}, sizeOf);
    if (largest->width == 1 && largest->height == 1) break;
    former.emplace(static_cast<std::size_t>(largest - images.begin()), sizeText(*largest));
    total -= sizeOf(*largest);
    *largest = halved(*largest);
    total += sizeOf(*largest);
  }
  std::vector<std::string> sentences;
  for (const auto& [index, size] : former) {
    sentences.push_back(fmt::format("the image {} is scaled down from {} to {} pixels", quote(images[index].name), size,
                                    sizeText(images[index])));
  }
  return sentences;
}

}  // namespace candela::scene
