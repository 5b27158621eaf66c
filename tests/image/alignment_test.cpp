// Pictures are compared where their pixels are.
#include "host/image/alignment.h"

#include <catch2/catch.hpp>

using namespace candela::image;

namespace {

/// Pixels whose red channel is 100 x + y at their place in the plane of the picture, in a frame of 8 x 6 pixels.
Image pictureAt(std::int64_t x, std::int64_t y, std::uint32_t width, std::uint32_t height) {
  Image image;
  image.width = width;
  image.height = height;
  image.origin = {x, y};
  image.frame = PixelBox{0, 0, 8, 6};
  for (std::uint32_t row = 0; row < height; ++row) {
    for (std::uint32_t column = 0; column < width; ++column) {
      const auto red = static_cast<float>(100 * (x + column) + y + row);
      image.rgb.emplace_back(red, 0, 0);
      image.alpha.push_back(red / 1000);
      image.sampleCounts.push_back(static_cast<std::uint32_t>(red));
    }
  }
  image.channels = {{"Z", image.alpha}};
  return image;
}

}  // namespace

TEST_CASE("a crop and its picture are cut to the window of the crop, whichever comes first") {
  for (const bool cropIsFirst : {true, false}) {
    Image crop = pictureAt(2, 1, 3, 4), whole = pictureAt(0, 0, 8, 6);
    Image& a = cropIsFirst ? crop : whole;
    Image& b = cropIsFirst ? whole : crop;
    REQUIRE(whyApart(a, b).empty());
    cutToCommonWindow(a, b);
    for (const Image* image : {&a, &b}) {
      const Image expected = pictureAt(2, 1, 3, 4);
      CHECK(windowOf(*image) == PixelBox{2, 1, 3, 4});
      CHECK(frameOf(*image) == PixelBox{0, 0, 8, 6});
      CHECK(image->rgb == expected.rgb);
      CHECK(image->alpha == expected.alpha);
      CHECK(image->sampleCounts == expected.sampleCounts);
      CHECK(image->channels.at(0).values == expected.channels.at(0).values);
    }
  }
}

TEST_CASE("pixels outside the frame are compared, too") {
  Image a = pictureAt(-2, -1, 12, 9), b = pictureAt(-2, -1, 2, 2);
  REQUIRE(whyApart(a, b).empty());
  cutToCommonWindow(a, b);
  CHECK(a.rgb == b.rgb);
}

TEST_CASE("windows that do not contain each other, and other frames, are apart") {
  const Image a = pictureAt(0, 0, 4, 4);
  CHECK(whyApart(a, pictureAt(4, 2, 4, 4)) ==
        "A has the window 0,0,4,4 of the frame and B the window 4,2,4,4, neither of which contains the other");
  CHECK(!whyApart(a, pictureAt(1, 0, 4, 4)).empty());
  Image other = pictureAt(0, 0, 4, 4);
  other.frame = PixelBox{1, 0, 8, 6};
  CHECK(whyApart(a, other) == "A has the frame 0,0,8,6 and B the frame 1,0,8,6");
  other.frame.reset();  // the frame of files without windows is their size
  CHECK(whyApart(a, other) == "A has the size 8x6 and B the size 4x4");
}
