// Selects and decodes texels.
#include "host/trace/reference/texture.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela::reference {
namespace {

constexpr double kLimit = 0x1p23;  // of texture coordinates

// IEC 61966-2-1, rounded to single precision as the specification of the lookup has it.
std::vector<float> makeSrgbTable() {
  std::vector<float> table;
  table.reserve(65536);
  for (int i = 0; i < 65536; ++i) {
    const double signal = i / 65535.0;
    const double linear = signal > 0.04045 ? std::exp(2.4 * std::log((signal + 0.055) / 1.055)) : signal / 12.92;
    table.push_back(static_cast<float>(linear));
  }
  return table;
}

unsigned channel(Texel texel, int index) { return texel >> 16 * index & 0xffff; }

// Returns the texel of an image of 8 bits.
Texel widened(std::uint32_t texel) {
  Texel channels = 0;
  for (int c = 3; c >= 0; --c) channels = channels << 16 | (texel >> 8 * c & 0xff);
  return channels * 257;
}

std::int64_t remainder(std::int64_t x, std::int64_t period) { return (x % period + period) % period; }

// The weights of the next texels across and down among the four around texture coordinates.
dvec2 fractionBetweenTexels(const scene::TextureImage& image, const dvec2& st) {
  const dvec2 limited = glm::lessThan(glm::abs(st), dvec2(kLimit)) == glm::bvec2(true) ? st : dvec2(0);
  return glm::fract(limited * dvec2(image.width, image.height) - 0.5);
}

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

Texel texelAt(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st,
              const dvec2& jitter) {
  const dvec2 displacement = reference.filter == scene::TextureFilter::linear ? jitter - 0.5 : dvec2(0);
  const std::uint32_t x = texelIndex(st.x, image.width, reference.wrapS, displacement.x);
  const std::uint32_t y = texelIndex(st.y, image.height, reference.wrapT, displacement.y);
  const std::size_t index = std::size_t{y} * image.width + x;
  return image.isDeep() ? image.deepTexels[index] : widened(image.texels[index]);
}

dvec2 textureCoordinates(const scene::TextureReference& reference, const MeshAttributes& attributes) {
  const dvec3 uv(attributes.texCoords[reference.texCoordSet], 1);
  return {dot(dvec3(reference.rowS), uv), dot(dvec3(reference.rowT), uv)};
}

double redOf(Texel texel) { return channel(texel, 0) / 65535.0; }
double greenOf(Texel texel) { return channel(texel, 1) / 65535.0; }
double blueOf(Texel texel) { return channel(texel, 2) / 65535.0; }
double alphaOf(Texel texel) { return channel(texel, 3) / 65535.0; }

glm::dvec4 channelsOf(Texel texel) { return {redOf(texel), greenOf(texel), blueOf(texel), alphaOf(texel)}; }

glm::dvec4 filteredTexel(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st) {
  if (reference.filter == scene::TextureFilter::nearest) return channelsOf(texelAt(image, reference, st, dvec2(0)));
  const dvec2 fraction = fractionBetweenTexels(image, st);
  glm::dvec4 channels(0);
  for (int corner = 0; corner < 4; ++corner) {
    const dvec2 next(corner % 2, corner / 2);  // a jitter of 1 leads to the next texel
    const dvec2 weight = glm::mix(1.0 - fraction, fraction, next);
    channels += weight.x * weight.y * channelsOf(texelAt(image, reference, st, next));
  }
  return channels;
}

dvec2 gradientOfRed(const scene::TextureImage& image, const scene::TextureReference& reference, const dvec2& st) {
  scene::TextureReference linear = reference;
  linear.filter = scene::TextureFilter::linear;
  const dvec2 fraction = fractionBetweenTexels(image, st);
  const auto red = [&](double x, double y) { return redOf(texelAt(image, linear, st, dvec2(x, y))); };
  const double byS = glm::mix(red(1, 0) - red(0, 0), red(1, 1) - red(0, 1), fraction.y);
  const double byT = glm::mix(red(0, 1) - red(0, 0), red(1, 1) - red(1, 0), fraction.x);
  return {byS * image.width, byT * image.height};
}

dvec3 linearColour(Texel texel) {
  static const std::vector<float> kTable = makeSrgbTable();
  return {kTable[channel(texel, 0)], kTable[channel(texel, 1)], kTable[channel(texel, 2)]};
}

}  // namespace candela::reference
