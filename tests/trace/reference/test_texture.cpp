// Lookups of textures, compared with values computed by hand.
#include <catch2/catch.hpp>

#include "host/trace/reference/texture.h"

using namespace candela;
using namespace candela::reference;
using scene::TextureFilter;
using scene::TextureWrap;

namespace {

// Texels 0 to count - 1 at s, without jitter.
std::vector<std::uint32_t> texelsAt(const std::vector<double>& coordinates, TextureWrap wrap, double displacement = 0) {
  std::vector<std::uint32_t> texels;
  for (const double s : coordinates) texels.push_back(texelIndex(s, 4, wrap, displacement));
  return texels;
}

using Indices = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("wrap modes place coordinates outside of the image") {
  const std::vector<double> s{-1.1, -0.3, -0.1, 0, 0.24, 0.25, 0.99, 1, 1.1, 1.6, 2.1};
  CHECK(texelsAt(s, TextureWrap::repeat) == Indices{3, 2, 3, 0, 0, 1, 3, 0, 0, 2, 0});
  CHECK(texelsAt(s, TextureWrap::mirroredRepeat) == Indices{3, 1, 0, 0, 0, 1, 3, 3, 3, 1, 0});
  CHECK(texelsAt(s, TextureWrap::clampToEdge) == Indices{0, 0, 0, 0, 0, 1, 3, 3, 3, 3, 3});
}

TEST_CASE("the jitter reaches the neighbour across the border that the wrap mode names") {
  const std::vector<double> s{0.05, 0.95};
  CHECK(texelsAt(s, TextureWrap::repeat, -0.5) == Indices{3, 3});
  CHECK(texelsAt(s, TextureWrap::repeat, 0.4) == Indices{0, 0});
  CHECK(texelsAt(s, TextureWrap::mirroredRepeat, -0.5) == Indices{0, 3});
  CHECK(texelsAt(s, TextureWrap::mirroredRepeat, 0.4) == Indices{0, 3});
  CHECK(texelsAt(s, TextureWrap::clampToEdge, -0.5) == Indices{0, 3});
  CHECK(texelsAt(s, TextureWrap::clampToEdge, 0.4) == Indices{0, 3});
}

TEST_CASE("huge and undefined coordinates count as 0") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double s : {0x1p23, -0x1p23, 1e300, infinity, -infinity, std::nan("")}) {
    CHECK(texelIndex(s, 4, TextureWrap::repeat, 0) == 0);
    CHECK(texelIndex(s, 4, TextureWrap::clampToEdge, 0) == 0);
  }
  CHECK(texelIndex(0x1p23 - 0.25, 4, TextureWrap::repeat, 0) == 3);
}

TEST_CASE("jitter averages to bilinear interpolation, and the filter nearest ignores it") {
  scene::TextureImage image{"", 3, 2, {10, 20, 30, 40, 50, 60}};
  scene::TextureReference reference{.wrapS = TextureWrap::repeat, .wrapT = TextureWrap::clampToEdge};
  const glm::dvec2 st(0.4, 0.6);  // 0.7 and 0.7 of the way from the centre of texel (0, 0) to that of (1, 1)
  constexpr int kSteps = 100;
  double sum = 0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const glm::dvec2 jitter((i % kSteps + 0.5) / kSteps, (i / kSteps + 0.5) / kSteps);
    sum += 255 * redOf(texelAt(image, reference, st, jitter));
  }
  CHECK(sum / (kSteps * kSteps) == Approx(0.3 * 0.3 * 10 + 0.7 * 0.3 * 20 + 0.3 * 0.7 * 40 + 0.7 * 0.7 * 50));
  reference.filter = TextureFilter::nearest;
  for (const double jitter : {0.0, 0.4, 0.999}) {
    CHECK(redOf(texelAt(image, reference, st, glm::dvec2(jitter))) == 50 / 255.0);
  }
}

TEST_CASE("colours are decoded from sRGB") {
  const scene::TextureImage image{"", 2, 1, {0x330bbc00u, 0x00ffffffu}};  // red 0, green 188, blue 11
  const Texel first = texelAt(image, {.filter = TextureFilter::nearest}, {0.25, 0.5}, {});
  const dvec3 colour = linearColour(first);
  CHECK(colour.x == 0);
  CHECK(colour.y == Approx(0.5028864580325687));
  CHECK(colour.z == Approx(0.003346535763899161));
  CHECK(alphaOf(first) == 0.2);
  CHECK(linearColour(texelAt(image, {.filter = TextureFilter::nearest}, {0.75, 0.5}, {})) == dvec3(1));
}

TEST_CASE("channels of 16 bits are not rounded") {
  const scene::TextureImage image{"", 1, 2, {}, {0, 0x0001'ffff'bc3a'3039}};  // red 12345, green 48186, alpha 1
  const Texel texel = texelAt(image, {.filter = TextureFilter::nearest}, {0.5, 0.75}, {});
  CHECK(redOf(texel) == 12345 / 65535.0);
  CHECK(greenOf(texel) == 48186 / 65535.0);
  CHECK(blueOf(texel) == 1);
  CHECK(alphaOf(texel) == 1 / 65535.0);
  CHECK(linearColour(texel).x == Approx(std::pow((12345 / 65535.0 + 0.055) / 1.055, 2.4)).epsilon(1e-6));
  CHECK(filteredTexel(image, {}, {0.5, 0.5}).w == Approx(0.5 / 65535));
}
