// Depths and costs as 8-bit pixels.
#include "host/image/false_colour.h"

#include <catch2/catch.hpp>
#include <limits>

#include "host/image/colour_map.h"

using namespace candela;
using namespace candela::image;

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image greys(const std::vector<float>& values) {
  Image image;
  image.width = static_cast<std::uint32_t>(values.size());
  image.height = 1;
  for (const float value : values) image.rgb.emplace_back(value);
  return image;
}

int depthShade(float value, float scale, float exposure = 0) {
  return toDisplay(glm::vec3(value), {ToneMap::depth, exposure, scale}).x;
}

glm::ivec3 heat(float value, float scale, float exposure = 0) {
  return glm::ivec3(toDisplay(glm::vec3(value), {ToneMap::heat, exposure, scale}));
}

}  // namespace

TEST_CASE("the shades of depth decrease from white over middle grey at the scale to black, the shade of misses") {
  CHECK(depthShade(1e-4f, 5) == 255);
  CHECK(depthShade(5, 5) == 128);       // 255 / 2
  CHECK(depthShade(10, 5) == 51);       // 255 / (1 + 4)
  CHECK(depthShade(10, 5, -1) == 128);  // a stop less is half the depth
  CHECK(depthShade(1e6f, 5) == 0);
  CHECK(depthShade(0, 5) == 0);
  CHECK(depthShade(kNan, 5) == 0);
  CHECK(depthShade(kInfinity, 5) == 0);
}

TEST_CASE("heat uses the colour map up to the scale, and its last colour beyond") {
  for (const float share : {0.f, 0.25f, 0.5f, 1.f}) {
    const glm::ivec3 expected(glm::round(255.0 * magma(share)));
    CHECK(heat(share * 200, 200) == expected);
    CHECK(heat(share * 100, 200, 1) == expected);
  }
  CHECK(heat(300, 200) == heat(200, 200));
  CHECK(heat(kNan, 200) == heat(0, 200));
}

TEST_CASE("heat gets lighter as the value grows") {
  int last = -1;
  for (int i = 0; i <= 100; ++i) {
    const glm::ivec3 colour = heat(static_cast<float>(i), 100);
    const int lightness = 2126 * colour.x + 7152 * colour.y + 722 * colour.z;
    CHECK(lightness > last);
    last = lightness;
  }
}

TEST_CASE("the scale is the maximum of costs, and the median of the depths of hits") {
  const Image image = greys({0, 4, 1, 0, 9, 2, 1000, 0});
  CHECK(falseColourScale(image, ToneMap::heat) == 1000);
  CHECK(falseColourScale(image, ToneMap::depth) == 4);
  CHECK(falseColourScale(greys({3, kNan, kInfinity, 0}), ToneMap::heat) == 3);
  CHECK(falseColourScale(greys({0, 0}), ToneMap::heat) == 1);
  CHECK(falseColourScale(greys({0, 0}), ToneMap::depth) == 1);
}

TEST_CASE("only depth and heat are false colours") {
  CHECK(isFalseColour(ToneMap::depth));
  CHECK(isFalseColour(ToneMap::heat));
  for (const ToneMap toneMap :
       {ToneMap::none, ToneMap::srgb, ToneMap::aces, ToneMap::acesHill, ToneMap::agx, ToneMap::neutral}) {
    CHECK_FALSE(isFalseColour(toneMap));
  }
}
