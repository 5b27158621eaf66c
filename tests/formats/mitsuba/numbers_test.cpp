// Numbers of several textures on the texels of one image.
#include "host/formats/mitsuba/numbers.h"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

namespace candela::mitsuba {
namespace {

using scene::TextureFilter, scene::TextureReference, scene::TextureWrap;

TextureReference useWith(TextureFilter filter, TextureWrap wrap) {
  TextureReference use;
  use.filter = filter;
  use.wrapS = use.wrapT = wrap;
  return use;
}

/// A row of two numbers, resampled to four texels.
std::vector<double> widened(const TextureReference& use) {
  std::array<Numbers, 2> numbers{Numbers{use, 2, 1, {1, 9}, "a"}, Numbers{use, 4, 1, {0, 1, 2, 3}, "b"}};
  REQUIRE(putOnOneGrid(numbers));
  CHECK(numbers[0].width == 4);
  CHECK(numbers[0].height == 1);
  CHECK(numbers[1].values == std::vector<double>{0, 1, 2, 3});
  return numbers[0].values;
}

}  // namespace

TEST_CASE("Smaller images are resampled with the filter and the wrap mode of their use") {
  CHECK(widened(useWith(TextureFilter::nearest, TextureWrap::repeat)) == std::vector<double>{1, 1, 9, 9});
  CHECK(widened(useWith(TextureFilter::linear, TextureWrap::clampToEdge)) == std::vector<double>{1, 3, 7, 9});
  CHECK(widened(useWith(TextureFilter::linear, TextureWrap::mirroredRepeat)) == std::vector<double>{1, 3, 7, 9});
  CHECK(widened(useWith(TextureFilter::linear, TextureWrap::repeat)) == std::vector<double>{3, 3, 7, 7});
}

TEST_CASE("The grid has the largest width and the largest height, and numbers without a texture fill it") {
  const TextureReference use = useWith(TextureFilter::nearest, TextureWrap::repeat);
  std::array<Numbers, 3> numbers{Numbers{{}, 1, 1, {5}, "5"}, Numbers{use, 1, 2, {1, 2}, "a"},
                                 Numbers{use, 3, 1, {6, 7, 8}, "b"}};
  REQUIRE(putOnOneGrid(numbers));
  for (const Numbers& each : numbers) {
    CHECK(each.use == use);
    CHECK(each.width == 3);
    CHECK(each.height == 2);
  }
  for (std::size_t i = 0; i < 6; ++i) CHECK(numbers[0].at(i) == 5);
  CHECK(numbers[2].at(4) == 7);
  CHECK(numbers[1].values == std::vector<double>{1, 1, 1, 2, 2, 2});
  CHECK(numbers[2].values == std::vector<double>{6, 7, 8, 6, 7, 8});
}

TEST_CASE("Numbers without any texture stay as they are") {
  std::array<Numbers, 2> numbers{Numbers{{}, 1, 1, {5}, "5"}, Numbers{{}, 1, 1, {6}, "6"}};
  CHECK(putOnOneGrid(numbers));
  CHECK_FALSE(numbers[0].use);
  CHECK(numbers[1].values == std::vector<double>{6});
}

TEST_CASE("The largest number takes the place of a texture with another use than the first one") {
  const TextureReference use = useWith(TextureFilter::nearest, TextureWrap::repeat);
  std::vector<TextureReference> others(4, use);
  others[0].filter = TextureFilter::linear;
  others[1].wrapT = TextureWrap::clampToEdge;
  others[2].rowS.x = 2;
  others[3].rowT.z = 0.5f;
  for (const TextureReference& other : others) {
    std::array<Numbers, 2> numbers{Numbers{use, 2, 1, {1, 2}, "a"}, Numbers{other, 3, 1, {6, 8, 7}, "b"}};
    CHECK_FALSE(putOnOneGrid(numbers));
    CHECK(numbers[0].values == std::vector<double>{1, 2});
    CHECK(numbers[1].at(0) == 8);
    CHECK(numbers[1].at(1) == 8);
    CHECK(numbers[1].use == use);
    CHECK(numbers[1].name != "b");
  }
}

TEST_CASE("A texel has its fractions in 16 bits, which are limited") {
  CHECK(deepTexelOf({0, 0.5, 2}, 1) == 0xffffffff80000000u);
  CHECK(deepTexelOf({1, -1, 0}, 0) == 0xffffu);
}

}  // namespace candela::mitsuba
