// Halves images.
#include "host/scene/shrink_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "host/scene/quote.h"

namespace candela::scene {
namespace {

/// The mean of one channel of four texels, rounded to the nearest value.
std::uint32_t meanOf(const std::uint32_t (&texels)[4], std::uint32_t shift) {
  std::uint32_t sum = 2;
  for (const std::uint32_t texel : texels) sum += texel >> shift & 255u;
  return sum / 4 << shift;
}

/// An odd last row or column is averaged with itself.
TextureImage halved(const TextureImage& image) {
  TextureImage half{image.name, std::max(image.width / 2, 1u), std::max(image.height / 2, 1u), {}};
  half.texels.reserve(std::size_t{half.width} * half.height);
  const auto texelAt = [&](std::uint32_t x, std::uint32_t y) {
    return image.texels[std::size_t{std::min(y, image.height - 1)} * image.width + std::min(x, image.width - 1)];
  };
  for (std::uint32_t y = 0; y < half.height; ++y) {
    for (std::uint32_t x = 0; x < half.width; ++x) {
      const std::uint32_t four[4]{texelAt(2 * x, 2 * y), texelAt(2 * x + 1, 2 * y), texelAt(2 * x, 2 * y + 1),
                                  texelAt(2 * x + 1, 2 * y + 1)};
      half.texels.push_back(meanOf(four, 0) | meanOf(four, 8) | meanOf(four, 16) | meanOf(four, 24));
    }
  }
  return half;
}

std::string sizeText(const TextureImage& image) { return fmt::format("{} x {}", image.width, image.height); }

}  // namespace

std::vector<std::string> shrinkImages(std::vector<TextureImage>& images, std::uint64_t maxTexels) {
  std::uint64_t total = 0;
  for (const TextureImage& image : images) total += image.texels.size();
  std::map<std::size_t, std::string> former;  // sizes, by index
  while (total > maxTexels) {
    const auto largest = std::ranges::max_element(images, {}, [](const TextureImage& i) { return i.texels.size(); });
    if (largest->texels.size() == 1) break;
    former.emplace(static_cast<std::size_t>(largest - images.begin()), sizeText(*largest));
    total -= largest->texels.size();
    *largest = halved(*largest);
    total += largest->texels.size();
  }
  std::vector<std::string> sentences;
  for (const auto& [index, size] : former) {
    sentences.push_back(fmt::format("the image {} is scaled down from {} to {} pixels", quote(images[index].name), size,
                                    sizeText(images[index])));
  }
  return sentences;
}

}  // namespace candela::scene
