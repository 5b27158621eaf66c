// Numbers are rounded once, to the nearest binary32.
#include "host/formats/loading/number.h"

#include <fmt/format.h>

#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "tests/formats/nff/scene_text.h"

namespace candela::scene {

TEST_CASE("decimals are rounded once to binary32") {
  // Halfway cases of 24-bit significands: a detour through binary64 would round the second one to even, downwards.
  CHECK(std::bit_cast<std::uint32_t>(parseFloat("16777217").value) == 0x4b800000u);
  CHECK(std::bit_cast<std::uint32_t>(parseFloat("16777217.0000000000000001").value) == 0x4b800001u);
  CHECK(std::bit_cast<std::uint32_t>(parseFloat("0.1").value) == 0x3dcccccdu);
  CHECK(std::bit_cast<std::uint32_t>(parseFloat("-99918.4").value) == 0xc7c32733u);
  CHECK(std::bit_cast<std::uint32_t>(parseFloat("681.33").value) == 0x442a551fu);
  CHECK(std::bit_cast<std::uint32_t>(parseFloat("1e-45").value) == 1u);
}

TEST_CASE("numbers in all usual notations are read") {
  for (const char* text : {".5", "0.5", "+.5", "5e-1", "5E-1", "0.50", "00.5"}) CHECK(parseFloat(text).value == 0.5f);
  CHECK(parseFloat("8.").value == 8);
  CHECK(parseFloat("1.1e-16").value == 1.1e-16f);
  CHECK(parseFloat("-1e6").value == -1e6f);
}

TEST_CASE("numbers that are too small become 0, and numbers that are too large are refused") {
  for (const char* text : {"1e-50", "-1e-50", "1e-500", "1e-99999999999"}) {
    CHECK(parseFloat(text).status == NumberStatus::ok);
    CHECK(parseFloat(text).value == 0);
  }
  CHECK(parseFloat("0." + std::string(500, '0') + "1").status == NumberStatus::ok);
  for (const char* text : {"3.5e38", "-1e39", "1e500", "1e99999999999"}) {
    CHECK(parseFloat(text).status == NumberStatus::overflow);
  }
  CHECK(parseFloat("1" + std::string(500, '0')).status == NumberStatus::overflow);
  CHECK(parseFloat("3.4028234e38").value == std::numeric_limits<float>::max());
}

TEST_CASE("words that are not numbers are distinguished from numbers that are not finite") {
  for (const char* text : {"", "+", "-", ".", "e5", "1e", "1.2.3", "--1", "1f", "0x1", "1,5"}) {
    CHECK(parseFloat(text).status == NumberStatus::notANumber);
  }
  for (const char* text : {"inf", "-inf", "nan", "NaN", "infinity"}) {
    CHECK(parseFloat(text).status == NumberStatus::notFinite);
    CHECK(looksLikeNumber(text));
  }
  CHECK_FALSE(looksLikeNumber("info"));
  CHECK_FALSE(looksLikeNumber("nanometre"));
}

TEST_CASE("numbers written with nine digits are preserved bit for bit") {
  std::mt19937 random(7);
  std::string text;
  std::vector<float> expected;
  while (expected.size() < 4000) {
    const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
    if (!std::isfinite(value)) continue;
    expected.push_back(value);
  }
  for (std::size_t i = 0; i < expected.size(); i += 4) {
    text += fmt::format("s {:.9g} {:.9g} {:.9g} {:.9g}\n", expected[i], expected[i + 1], expected[i + 2],
                        expected[i + 3]);
  }
  const Scene scene = sceneOf(text);
  REQUIRE(scene.spheres.size() == expected.size() / 4);
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    REQUIRE(scene.spheres[i].centre == glm::vec3(expected[4 * i], expected[4 * i + 1], expected[4 * i + 2]));
    REQUIRE(scene.spheres[i].radius == expected[4 * i + 3]);
  }
}

}  // namespace candela::scene
