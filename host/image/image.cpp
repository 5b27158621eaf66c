// Converts films to images, and images to pixels of 8 bits.
#include "host/image/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "host/base/errors.h"
#include "host/image/chromaticities.h"
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

namespace {

/// Returns the values of the part of an image of `width` columns that begins at (x, y).
template <typename Value>
std::vector<Value> partOf(const std::vector<Value>& values, std::size_t width, const PixelBox& part) {
  if (values.empty()) return {};
  std::vector<Value> result;
  result.reserve(static_cast<std::size_t>(part.width * part.height));
  for (std::int64_t y = part.y; y < part.y + part.height; ++y) {
    const auto row = values.begin() + static_cast<std::ptrdiff_t>(width) * y + part.x;
    result.insert(result.end(), row, row + part.width);
  }
  return result;
}

}  // namespace

std::string boxText(const PixelBox& box) { return fmt::format("{},{},{},{}", box.x, box.y, box.width, box.height); }

PixelBox windowOf(const Image& image) { return {image.origin.x, image.origin.y, image.width, image.height}; }

PixelBox frameOf(const Image& image) { return image.frame.value_or(PixelBox{0, 0, image.width, image.height}); }

Image partOf(const Image& image, const PixelBox& window) {
  const PixelBox part{window.x - image.origin.x, window.y - image.origin.y, window.width, window.height};
  const auto cut = [&](const auto& values) { return partOf(values, image.width, part); };
  Image result;
  result.width = static_cast<std::uint32_t>(window.width);
  result.height = static_cast<std::uint32_t>(window.height);
  result.rgb = cut(image.rgb);
  result.luminanceVariance = cut(image.luminanceVariance);
  result.sampleCounts = cut(image.sampleCounts);
  result.badSampleCounts = cut(image.badSampleCounts);
  result.metadata = image.metadata;
  result.alpha = cut(image.alpha);
  for (const Channel& channel : image.channels) {
    result.channels.push_back({channel.name, cut(channel.values), channel.isId});
  }
  result.origin = {window.x, window.y};
  result.frame = frameOf(image);
  return result;
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

namespace {

/// Returns the linear values of all signals from 0 to `largest`. A gamma near 1/2.2 stands for sRGB, as in libpng.
std::vector<float> linearValues(std::uint32_t largest, double gamma) {
  constexpr double kSignificant = 0.05;
  const bool isSrgb = gamma <= 0 || std::abs(2.2 * gamma - 1) <= kSignificant;
  std::vector<float> linear(std::size_t{largest} + 1);
  for (std::size_t i = 0; i < linear.size(); ++i) {
    const double signal = static_cast<double>(i) / largest;
    linear[i] = static_cast<float>(isSrgb ? srgbDecode(signal) : std::pow(signal, 1 / gamma));
  }
  return linear;
}

/// Appends the pixels of texels with `Bits` bits per channel.
template <int Bits, typename Texel>
void appendTexels(const std::vector<Texel>& texels, double gamma, Image& image) {
  constexpr std::uint32_t kLargest = (1u << Bits) - 1;
  const std::vector<float> linear = linearValues(kLargest, gamma);
  const auto channel = [](Texel texel, int c) { return static_cast<std::uint32_t>(texel >> Bits * c) & kLargest; };
  const bool isOpaque = std::ranges::all_of(texels, [&](Texel texel) { return channel(texel, 3) == kLargest; });
  image.rgb.reserve(texels.size());
  if (!isOpaque) image.alpha.reserve(texels.size());
  for (const Texel texel : texels) {
    glm::vec3 colour(linear[channel(texel, 0)], linear[channel(texel, 1)], linear[channel(texel, 2)]);
    if (!isOpaque) {
      image.alpha.push_back(static_cast<float>(channel(texel, 3)) / kLargest);
      colour *= image.alpha.back();
    }
    image.rgb.push_back(colour);
  }
}

}  // namespace

Image toImage(const Texels& texels) {
  Image image;
  image.isDisplayReferred = true;
  image.width = texels.width;
  image.height = texels.height;
  if (texels.deepRgba.empty()) {
    appendTexels<8>(texels.rgba, texels.gamma, image);
  } else {
    appendTexels<16>(texels.deepRgba, texels.gamma, image);
  }
  if (const std::vector<double>& p = texels.primaries; !p.empty()) {
    convertToRec709({{p[0], p[1]}, {p[2], p[3]}, {p[4], p[5]}, {p[6], p[7]}}, image);
  }
  if (texels.hasProfile) image.warnings.emplace_back("its ICC profile is not applied; the colours are taken as sRGB");
  return image;
}

Image toImage(const Pixels8& pixels) {
  const std::vector<float> linear = linearValues(255, 0);
  Image image{pixels.width, pixels.height, {}, {}, {}, {}, {}};
  image.rgb.reserve(pixels.rgb.size() / 3);
  for (std::size_t i = 0; i + 2 < pixels.rgb.size(); i += 3) {
    image.rgb.emplace_back(linear[pixels.rgb[i]], linear[pixels.rgb[i + 1]], linear[pixels.rgb[i + 2]]);
  }
  return image;
}

}  // namespace candela::image
