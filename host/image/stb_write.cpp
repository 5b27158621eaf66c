// Writes PNG, JPEG and HDR files with stb_image_write.
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/image/codecs.h"

namespace candela::image {
namespace {

constexpr int kJpegQuality = 95;

void append(void* bytes, void* data, int size) {
  const auto* first = static_cast<const std::byte*>(data);
  static_cast<Bytes*>(bytes)->insert(static_cast<Bytes*>(bytes)->end(), first, first + size);
}

Bytes checked(int succeeded, Bytes bytes) {
  if (!succeeded) throw OutOfMemoryError("not enough memory to compress the image");
  return bytes;
}

/// Clamps to the range of RGBE, whose shared exponents reach 2^127. NaN becomes 0.
float rgbeValue(float value) {
  constexpr float kMaxValue = 1.6e38f;
  return value > 0 ? std::min(value, kMaxValue) : 0;
}

/// Rounds a pixel to the nearest values m * 2^(e - 136) with integers m below 256 and a common exponent e.
/// stb_image_write truncates values to such multiples, by which pictures would be 0.4 % too dark in programs that read
/// m * 2^(e - 136).
glm::vec3 roundedToRgbe(const glm::vec3& pixel) {
  const glm::vec3 value(rgbeValue(pixel.x), rgbeValue(pixel.y), rgbeValue(pixel.z));
  const float largest = std::max({value.x, value.y, value.z});
  if (largest == 0) return value;
  int exponent = 0;
  std::frexp(largest, &exponent);
  constexpr int kMantissaBits = 8;
  const auto inSteps = [&](float channel) { return std::round(std::ldexp(channel, kMantissaBits - exponent)); };
  if (inSteps(largest) == 256) ++exponent;
  const auto rounded = [&](float channel) { return std::ldexp(inSteps(channel), exponent - kMantissaBits); };
  return {rounded(value.x), rounded(value.y), rounded(value.z)};
}

/// Returns the pixels with their alpha, 4 bytes each.
std::vector<std::uint8_t> interleaved(const Pixels8& pixels) {
  std::vector<std::uint8_t> rgba;
  rgba.reserve(4 * pixels.alpha.size());
  for (std::size_t i = 0; i < pixels.alpha.size(); ++i) {
    rgba.insert(rgba.end(), {pixels.rgb[3 * i], pixels.rgb[3 * i + 1], pixels.rgb[3 * i + 2], pixels.alpha[i]});
  }
  return rgba;
}

}  // namespace

Bytes encodePng(const Pixels8& pixels) {
  const auto width = static_cast<int>(pixels.width);
  const auto height = static_cast<int>(pixels.height);
  const int channels = pixels.alpha.empty() ? 3 : 4;
  const std::vector<std::uint8_t> rgba = pixels.alpha.empty() ? std::vector<std::uint8_t>{} : interleaved(pixels);
  const std::uint8_t* const first = rgba.empty() ? pixels.rgb.data() : rgba.data();
  Bytes bytes;
  const int succeeded = stbi_write_png_to_func(append, &bytes, width, height, channels, first, channels * width);
  return checked(succeeded, std::move(bytes));
}

Bytes encodeJpeg(const Pixels8& pixels) {
  const auto width = static_cast<int>(pixels.width);
  const auto height = static_cast<int>(pixels.height);
  Bytes bytes;
  const int succeeded = stbi_write_jpg_to_func(append, &bytes, width, height, 3, pixels.rgb.data(), kJpegQuality);
  return checked(succeeded, std::move(bytes));
}

Bytes encodeHdr(const Image& image) {
  std::vector<glm::vec3> rgb(image.rgb);
  for (glm::vec3& pixel : rgb) pixel = roundedToRgbe(pixel);
  Bytes bytes;
  const int succeeded = stbi_write_hdr_to_func(append, &bytes, static_cast<int>(image.width),
                                               static_cast<int>(image.height), 3, &rgb.data()->x);
  return checked(succeeded, std::move(bytes));
}

}  // namespace candela::image
