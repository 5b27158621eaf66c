// Encodes bytes in base64.
#include "host/judge/report/base64.h"

#include <bit>
#include <cstdint>
#include <vector>

namespace candela::report {

std::string base64(std::span<const std::byte> bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < count; ++k) word |= std::to_integer<std::uint32_t>(bytes[i + k]) << (16 - 8 * k);
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kDigits[(word >> (18 - 6 * k)) & 63] : '=';
  }
  return text;
}

std::string pngUri(const image::Pixels8& pixels) { return "data:image/png;base64," + base64(toPng(pixels)); }

std::string floatText(const image::Image& image) {
  std::vector<std::byte> bytes;
  bytes.reserve(12 * image.rgb.size());
  for (const glm::vec3& pixel : image.rgb) {
    for (int channel = 0; channel < 3; ++channel) {
      const auto word = std::bit_cast<std::uint32_t>(pixel[channel]);
      for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::byte>(word >> shift));
    }
  }
  return base64(bytes);
}

}  // namespace candela::report
