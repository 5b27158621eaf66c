// Converts films to images, and images to pixels of 8 bits.
#include "host/image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "host/core/errors.h"
#include "host/image/codecs.h"
#include "host/image/colour_transfer.h"

namespace candela::image {
void checkImageSize(std::uint64_t width, std::uint64_t height) {
  if (width == 0 || height == 0) throw FileError("the image has no pixels");
  if (width > kMaxImageSide || height > kMaxImageSide || width * height > kMaxImagePixels) {
    throw FileError(fmt::format("{} x {} pixels exceed the limits of {} per side and {} in total", width, height,
                                kMaxImageSide, kMaxImagePixels));
  }
}

Image toImage(const Film& film) {
  Image image;
  image.width = film.width();
  image.height = film.height();
  image.rgb.reserve(film.pixels().size());
  for (std::uint32_t y = 0; y < image.height; ++y) {
    for (std::uint32_t x = 0; x < image.width; ++x) {
      image.rgb.emplace_back(film.mean(x, y));
      image.luminanceVariance.push_back(static_cast<float>(film.luminanceVariance(x, y)));
      image.sampleCounts.push_back(film.at(x, y).sampleCount);
      image.badSampleCounts.push_back(film.at(x, y).badCount);
    }
  }
  const std::uint64_t badCount = badSampleCount(image);
  if (badCount > 0) {
    image.metadata["candela.badSamples"] = std::to_string(badCount);
  } else {
    image.badSampleCounts.clear();
  }
  return image;
}

std::uint64_t badSampleCount(const Image& image) {
  return std::accumulate(image.badSampleCounts.begin(), image.badSampleCounts.end(), std::uint64_t{0});
}

void addAlpha(Image& image, const Film& film) {
  image.alpha.reserve(film.pixels().size());
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) image.alpha.push_back(static_cast<float>(film.alpha(x, y)));
  }
}

Pixels8 toStraightPixels8(const Image& image, const DisplayTransform& transform) {
  Image straight{image.width, image.height, image.rgb, {}, {}, {}, {}};
  std::vector<std::uint8_t> alpha;
  alpha.reserve(image.alpha.size());
  for (std::size_t i = 0; i < image.alpha.size(); ++i) {
    const float opacity = image.alpha[i] > 0 ? std::min(image.alpha[i], 1.0f) : 0;  // also where it is not a number
    straight.rgb[i] = opacity > 0 ? image.rgb[i] / opacity : glm::vec3(0);
    alpha.push_back(static_cast<std::uint8_t>(std::lround(255 * opacity)));
  }
  Pixels8 pixels = toPixels8(straight, transform);
  pixels.alpha = std::move(alpha);
  return pixels;
}

Pixels8 toPixels8(const Image& image, const DisplayTransform& transform) {
  Pixels8 pixels{image.width, image.height, {}};
  pixels.rgb.reserve(3 * image.rgb.size());
  for (const glm::vec3& linear : image.rgb) {
    const glm::u8vec3 pixel = toDisplay(linear, transform);
    pixels.rgb.insert(pixels.rgb.end(), {pixel.x, pixel.y, pixel.z});
  }
  return pixels;
}

std::vector<std::byte> toPng(const Pixels8& pixels) {
  checkImageSize(pixels.width, pixels.height);
  return encodePng(pixels);
}

Image toImage(const Pixels8& pixels) {
  std::array<float, 256> linear;
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(srgbDecode(static_cast<double>(i) / 255));
  Image image{pixels.width, pixels.height, {}, {}, {}, {}, {}};
  image.rgb.reserve(pixels.rgb.size() / 3);
  for (std::size_t i = 0; i + 2 < pixels.rgb.size(); i += 3) {
    image.rgb.emplace_back(linear[pixels.rgb[i]], linear[pixels.rgb[i + 1]], linear[pixels.rgb[i + 2]]);
  }
  return image;
}

}  // namespace candela::image
