// Small images for the tests of image files.
#pragma once
#include <cmath>
#include <cstddef>
#include <random>

#include "host/image/image.h"

/// Colours over ten decades, with variance, counts and metadata.
inline candela::image::Image testImage(std::uint32_t width, std::uint32_t height) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> exponent(-20, 14);
  candela::image::Image image{width, height, {}, {}, {}, {}, {}};
  for (std::uint32_t i = 0; i < width * height; ++i) {
    image.rgb.emplace_back(std::exp2(exponent(random)), std::exp2(exponent(random)), std::exp2(exponent(random)));
    image.luminanceVariance.push_back(std::exp2(exponent(random)));
    image.sampleCounts.push_back(static_cast<std::uint32_t>(random()));
    image.badSampleCounts.push_back(static_cast<std::uint32_t>(random()));
  }
  image.metadata = {{"candela.scene", "balls.p3f"}, {"a name of more than thirty-one characters", "a longer\nvalue"}};
  return image;
}

/// All 256 values in each channel, in different orders.
inline candela::image::Pixels8 testPixels() {
  candela::image::Pixels8 pixels{16, 16, {}};
  for (unsigned i = 0; i < 256; ++i) {
    for (const unsigned value : {i, 255 - i, (i * 77) % 256}) pixels.rgb.push_back(static_cast<std::uint8_t>(value));
  }
  return pixels;
}
