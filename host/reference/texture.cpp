// Selects and decodes texels.
#include "host/reference/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/reference/rounding.h"

namespace candela::reference {
namespace {

constexpr double kLimit = 0x1p23;  // of texture coordinates

// IEC 61966-2-1, rounded to single precision as the specification of the lookup has it.
std::array<double, 256> makeSrgbTable() {
  std::array<double, 256> table{};
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double signal = static_cast<double>(i) / 255;
    const double linear = signal > 0.04045 ? std::exp(2.4 * std::log((signal + 0.055) / 1.055)) : signal / 12.92;
    table[i] = static_cast<float>(linear);
  }
  return table;
}

const std::array<double, 256> kSrgbTable = makeSrgbTable();

double coordinateError(const glm::vec3& row, const dvec2& scale) {
  const dvec3 terms = glm::abs(dvec3(row)) * dvec3(scale, 1);
  return kRoundingBounds.texCoord * kRoundoff * (1 + terms.x + terms.y + terms.z);
}

std::int64_t remainder(std::int64_t x, std::int64_t period) { return (x % period + period) % period; }

}  // namespace

std::uint32_t texelIndex(double s, std::uint32_t count, scene::TextureWrap wrap, double displacement) {
  if (!(std::abs(s) < kLimit)) s = 0;
  const std::int64_t n = count;
  const auto x = static_cast<std::int64_t>(std::floor(s * static_cast<double>(n) + displacement));
  switch (wrap) {
    case scene::TextureWrap::repeat:
      return static_cast<std::uint32_t>(remainder(x, n));
    case scene::TextureWrap::mirroredRepeat: {
      const std::int64_t folded = remainder(x, 2 * n);
      return static_cast<std::uint32_t>(std::min(folded, 2 * n - 1 - folded));
    }
    case scene::TextureWrap::clampToEdge:
      break;
  }
  return static_cast<std::uint32_t>(std::clamp<std::int64_t>(x, 0, n - 1));
}

std::uint32_t texelAt(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st,
                      const dvec2& jitter) {
  const dvec2 displacement = reference.filter == scene::TextureFilter::linear ? jitter - 0.5 : dvec2(0);
  const std::uint32_t x = texelIndex(st.x, image.width, reference.wrapS, displacement.x);
  const std::uint32_t y = texelIndex(st.y, image.height, reference.wrapT, displacement.y);
  return image.texels[std::size_t{y} * image.width + x];
}

dvec2 textureCoordinates(const scene::TextureReference& reference, const MeshAttributes& attributes) {
  const dvec3 uv(attributes.texCoords[reference.texCoordSet], 1);
  return {dot(dvec3(reference.rowS), uv), dot(dvec3(reference.rowT), uv)};
}

dvec2 coordinateErrors(const scene::TextureReference& reference, const MeshAttributes& attributes) {
  const dvec2& scale = attributes.texCoordScale[reference.texCoordSet];
  return {coordinateError(reference.rowS, scale), coordinateError(reference.rowT, scale)};
}

double alphaOf(std::uint32_t texel) { return (texel >> 24) / 255.0; }

double filteredAlpha(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st) {
  if (reference.filter == scene::TextureFilter::nearest) return alphaOf(texelAt(image, reference, st, dvec2(0)));
  const dvec2 limited = glm::lessThan(glm::abs(st), dvec2(kLimit)) == glm::bvec2(true) ? st : dvec2(0);
  const dvec2 share = glm::fract(limited * dvec2(image.width, image.height) - 0.5);
  double alpha = 0;
  for (int corner = 0; corner < 4; ++corner) {
    const dvec2 next(corner % 2, corner / 2);  // a jitter of 1 leads to the next texel
    const dvec2 weight = glm::mix(1.0 - share, share, next);
    alpha += weight.x * weight.y * alphaOf(texelAt(image, reference, st, next));
  }
  return alpha;
}

dvec3 linearColour(std::uint32_t texel) {
  return {kSrgbTable[texel % 256], kSrgbTable[texel / 256 % 256], kSrgbTable[texel / 65536 % 256]};
}

}  // namespace candela::reference
