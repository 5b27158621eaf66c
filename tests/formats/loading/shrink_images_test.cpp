// Images that are beyond the limit are halved, the largest first.
#include "host/formats/loading/shrink_images.h"

#include <catch2/catch.hpp>

using namespace candela::scene;

TEST_CASE("the largest images are halved until all fit, and are named") {
  std::vector<TextureImage> images{{"small", 2, 1, {1, 2}}, {"large", 4, 3, std::vector<std::uint32_t>(12, 7)}};
  CHECK(shrinkImages(images, 14).empty());
  CHECK(shrinkImages(images, 13) ==
        std::vector<std::string>{"the image \"large\" is scaled down from 4 x 3 to 2 x 1 pixels"});
  CHECK(images[0].texels == std::vector<std::uint32_t>{1, 2});
  CHECK(images[1].texels == std::vector<std::uint32_t>{7, 7});
}

TEST_CASE("a texel of a smaller image is the mean of four, in each channel") {
  std::vector<TextureImage> images{{"", 2, 2, {0x00ff0001u, 0x00000002u, 0xff000003u, 0x0000ff04u}}};
  CHECK(shrinkImages(images, 1).size() == 1);
  CHECK(images[0].texels == std::vector<std::uint32_t>{0x40404003u});  // 2.5 and 63.75 are rounded up
}

TEST_CASE("images shrink to one texel each and no further") {
  std::vector<TextureImage> images{{"a", 5, 1, {1, 2, 3, 4, 5}}, {"b", 1, 4, {1, 2, 3, 4}}};
  CHECK(shrinkImages(images, 0).size() == 2);
  CHECK(images[0].texels.size() == 1);
  CHECK(images[1].texels.size() == 1);
}

TEST_CASE("images of 16 bits per channel count twice, and keep their bits") {
  std::vector<TextureImage> images{{"a", 2, 2, {}, {0x0001'0003'ffff'0000, 0x0002'0003'ffff'0000, 0, 0}},
                                   {"b", 3, 2, {1, 2, 3, 4, 5, 6}}};
  CHECK(shrinkImages(images, 14).empty());
  CHECK(shrinkImages(images, 13).size() == 1);
  CHECK(images[0].deepTexels == std::vector<std::uint64_t>{0x0001'0002'8000'0000});
  CHECK(images[0].texels.empty());
  CHECK(images[1].texels.size() == 6);
}
