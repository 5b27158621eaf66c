// Transfer function and tone curves, compared with values computed independently.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "host/image/colour_transfer.h"
#include "host/image/exposure.h"
#include "host/image/image.h"

using namespace candela;
using namespace candela::image;

namespace {

glm::ivec3 display(const glm::vec3& linear, ToneMap toneMap, float exposure = 0) {
  return glm::ivec3(toDisplay(linear, {toneMap, exposure}));
}

}  // namespace

TEST_CASE("sRGB signals decode to the values of IEC 61966-2-1") {
  // ((n/255 + 0.055)/1.055)^2.4, and n/255/12.92 up to n = 10, computed with Python in binary64.
  CHECK(srgbDecode(0) == 0);
  CHECK(srgbDecode(1 / 255.0) == Approx(0.0003035269835488375).epsilon(1e-14));
  CHECK(srgbDecode(10 / 255.0) == Approx(0.003035269835488375).epsilon(1e-14));
  CHECK(srgbDecode(11 / 255.0) == Approx(0.003346535763899161).epsilon(1e-14));
  CHECK(srgbDecode(50 / 255.0) == Approx(0.03189603307301153).epsilon(1e-14));
  CHECK(srgbDecode(128 / 255.0) == Approx(0.21586050011389926).epsilon(1e-14));
  CHECK(srgbDecode(188 / 255.0) == Approx(0.5028864580325687).epsilon(1e-14));
  CHECK(srgbDecode(254 / 255.0) == Approx(0.9911020971138298).epsilon(1e-14));
  CHECK(srgbDecode(1) == 1);
}

TEST_CASE("sRGB encoding inverts decoding and is continuous at the joint of its pieces") {
  for (int i = 0; i <= 1000; ++i) {
    const double signal = i / 1000.0;
    CHECK(srgbEncode(srgbDecode(signal)) ==
          Approx(signal).margin(1e-7));  // the standard's pieces agree to 1e-8 at their joint
  }
  CHECK(srgbEncode(0.0031308) == Approx(srgbEncode(std::nextafter(0.0031308, 1.0))).margin(1e-7));
}

TEST_CASE("every 8-bit sRGB value survives decoding and display") {
  for (int i = 0; i < 256; ++i) {
    CHECK(display(glm::vec3(static_cast<float>(srgbDecode(i / 255.0))), ToneMap::srgb) == glm::ivec3(i));
  }
}

TEST_CASE("tone curves give the pixels of their published formulas") {
  struct Row {
    glm::vec3 linear;
    glm::ivec3 none, srgb, aces, acesHill, agx, neutral;
  };
  // Computed with Python in binary64 from the published formulas.
  const Row rows[] = {
      {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}},
      {{.18f, .18f, .18f},
       {46, 46, 46},
       {118, 118, 118},
       {141, 141, 141},
       {127, 127, 127},
       {128, 128, 128},
       {105, 105, 105}},
      {{1, 1, 1}, {255, 255, 255}, {255, 255, 255}, {232, 232, 232}, {226, 226, 226}, {202, 202, 202}, {240, 240, 240}},
      {{.5f, .25f, .05f},
       {128, 64, 13},
       {188, 137, 63},
       {206, 165, 59},
       {199, 153, 69},
       {179, 145, 84},
       {182, 128, 34}},
      {{4, .5f, .1f},
       {255, 128, 26},
       {255, 188, 89},
       {252, 206, 99},
       {255, 214, 149},
       {249, 184, 143},
       {253, 166, 152}},
      {{16, 16, 16},
       {255, 255, 255},
       {255, 255, 255},
       {255, 255, 255},
       {255, 255, 255},
       {254, 254, 254},
       {255, 255, 255}},
      {{.02f, .03f, .01f}, {5, 8, 3}, {39, 48, 25}, {26, 38, 12}, {21, 31, 10}, {37, 51, 19}, {26, 39, 2}},
  };
  for (const Row& row : rows) {
    CAPTURE(row.linear.x, row.linear.y, row.linear.z);
    CHECK(display(row.linear, ToneMap::none) == row.none);
    CHECK(display(row.linear, ToneMap::srgb) == row.srgb);
    CHECK(display(row.linear, ToneMap::aces) == row.aces);
    CHECK(display(row.linear, ToneMap::acesHill) == row.acesHill);
    CHECK(display(row.linear, ToneMap::agx) == row.agx);
    CHECK(display(row.linear, ToneMap::neutral) == row.neutral);
  }
}

TEST_CASE("the automatic exposure makes the geometric mean of the luminance 0.18") {
  Image image{2, 2, {glm::vec3(0.09f), glm::vec3(0.36f), glm::vec3(0), glm::vec3(-1)}, {}, {}, {}, {}};
  CHECK(automaticExposure(image) == Approx(0).margin(1e-6));
  for (glm::vec3& pixel : image.rgb) pixel *= 8;
  CHECK(automaticExposure(image) == Approx(-3));
  image.rgb = {glm::vec3(0), glm::vec3(std::numeric_limits<float>::infinity()), glm::vec3(NAN), glm::vec3(0)};
  CHECK(automaticExposure(image) == 0);
}

TEST_CASE("exposure is measured in stops") {
  CHECK(display({0.5f, 0.25f, 0.125f}, ToneMap::none, 1) == glm::ivec3(255, 128, 64));
  CHECK(display({0.5f, 0.25f, 0.125f}, ToneMap::none, -1) == glm::ivec3(64, 32, 16));
  CHECK(display({0.18f, 0.18f, 0.18f}, ToneMap::aces, 2) == display({0.72f, 0.72f, 0.72f}, ToneMap::aces));
}

TEST_CASE("every tone curve handles values that are no radiance") {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kMaxValue = std::numeric_limits<float>::max();
  for (const ToneMap toneMap :
       {ToneMap::none, ToneMap::srgb, ToneMap::aces, ToneMap::acesHill, ToneMap::agx, ToneMap::neutral}) {
    CAPTURE(static_cast<int>(toneMap));
    CHECK(display({kNan, kNan, kNan}, toneMap) == glm::ivec3(0));
    CHECK(display({-kInfinity, -1, -0.0f}, toneMap) == glm::ivec3(0));
    CHECK(glm::all(glm::greaterThanEqual(display({kInfinity, kInfinity, kInfinity}, toneMap), glm::ivec3(254))));
    CHECK(glm::all(glm::greaterThanEqual(display({kMaxValue, kMaxValue, kMaxValue}, toneMap, 100), glm::ivec3(254))));
  }
}

TEST_CASE("the result of a tone curve never gets darker as grey gets brighter") {
  for (const ToneMap toneMap :
       {ToneMap::none, ToneMap::srgb, ToneMap::aces, ToneMap::acesHill, ToneMap::agx, ToneMap::neutral}) {
    int last = 0;
    for (float stops = -14; stops < 8; stops += 0.01f) {
      const int now = display(glm::vec3(std::exp2(stops)), toneMap).x;
      CHECK(now >= last);
      last = now;
    }
  }
}
