// Image files preserve what their formats can store.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/base/errors.h"
#include "host/image/image.h"
#include "host/image/texels.h"
#include "tests/base/temporary_folder.h"
#include "tests/image/read_pixels8.h"
#include "tests/image/test_images.h"

using namespace candela;
using namespace candela::image;

TEST_CASE("an image of a film has its means, variances and counts") {
  Film film(2, 1);
  film.addSample(0, 0, {1, 2, 4}, 0);
  film.addSample(0, 0, {3, 2, 0}, 1);
  const Image image = toImage(film);
  CHECK(image.width == 2);
  CHECK(image.height == 1);
  CHECK(image.at(0, 0) == glm::vec3(2, 2, 2));
  CHECK(image.at(1, 0) == glm::vec3(0));
  // Luminances 1.9318 and 2.0682: half their squared difference.
  CHECK(image.luminanceVariance[0] == Approx(0.1364 * 0.1364 / 2).epsilon(1e-6));
  CHECK(image.sampleCounts == std::vector<std::uint32_t>{2, 0});
  CHECK(image.metadata.empty());
  CHECK(image.badSampleCounts.empty());
}

TEST_CASE("an image of a film with bad samples has their number per pixel") {
  Film film(2, 1);
  film.addSample(0, 0, {1, 2, 4}, 0);
  film.addSample(1, 0, {-1, 0, 0}, 0);
  film.addSample(1, 0, {0, 1e9, 0}, 1);
  const Image image = toImage(film);
  CHECK(image.badSampleCounts == std::vector<std::uint32_t>{0, 2});
  CHECK(badSampleCount(image) == 2);
  CHECK(image.metadata.at("candela.badSamples") == "2");
}

TEST_CASE("EXR files preserve every bit of an image") {
  TemporaryFolder folder;
  const Image image = testImage(37, 21);
  writeImage(folder / "a.exr", image, {});
  const Image back = readImage(folder / "a.exr");
  CHECK(back.width == 37);
  CHECK(back.height == 21);
  CHECK(back.rgb == image.rgb);
  CHECK(back.luminanceVariance == image.luminanceVariance);
  CHECK(back.sampleCounts == image.sampleCounts);
  CHECK(back.badSampleCounts == image.badSampleCounts);
  CHECK(back.metadata == image.metadata);
}

TEST_CASE("an image states the precision of its file, and whether a display transform made it") {
  TemporaryFolder folder;
  for (const auto& [name, bits, isDisplayReferred] :
       {std::tuple{"a.exr", 24u, false}, {"a.pfm", 24u, false}, {"a.hdr", 8u, false}, {"a.png", 24u, true}}) {
    writeImage(folder / name, testImage(3, 2), {});
    const Image back = readImage(folder / name);
    CHECK(back.significandBits == bits);
    CHECK(back.isDisplayReferred == isDisplayReferred);
  }
}

TEST_CASE("EXR files without variance and counts are read without them") {
  TemporaryFolder folder;
  Image image = testImage(3, 2);
  image.luminanceVariance.clear();
  image.sampleCounts.clear();
  image.metadata.clear();
  writeImage(folder / "a.exr", image, {});
  const Image back = readImage(folder / "a.exr");
  CHECK(back.rgb == image.rgb);
  CHECK(back.luminanceVariance.empty());
  CHECK(back.sampleCounts.empty());
  CHECK(back.metadata.empty());
}

TEST_CASE("EXR files preserve the channels of layers and the windows") {
  TemporaryFolder folder;
  Image image = testImage(3, 2);
  image.channels = {{"N.X", {1, 2, 3, 4, 5, 6}}, {"Z", {1e10f, 1, 2, 3, 4, 5}}, {"sqrt.R", {1, 1, 1, 1, 1, 1}}};
  image.origin = {-2, 5};
  image.frame = PixelBox{0, 0, 40, 30};
  writeImage(folder / "a.exr", image, {});
  CHECK(readImage(folder / "a.exr").channels.empty());
  const Image back = readImage(folder / "a.exr", ImageParts::withLayers);
  REQUIRE(back.channels.size() == 2);  // the third is a statistic
  CHECK(back.channels[0].name == "N.X");
  CHECK(back.channels[0].values == image.channels[0].values);
  CHECK(back.channels[1].values == image.channels[1].values);
  CHECK(windowOf(back) == PixelBox{-2, 5, 3, 2});
  CHECK(frameOf(back) == PixelBox{0, 0, 40, 30});
  image.origin.x = std::int64_t{1} << 40;
  CHECK_THROWS_WITH(writeImage(folder / "b.exr", image, {}), Catch::Contains("too far from the origin"));
}

TEST_CASE("the first and third channels of Cryptomatte files are ids") {
  TemporaryFolder folder;
  Image image = testImage(1, 1);
  image.metadata = {{"cryptomatte/1234567/name", "Objects"}};
  for (const char* name : {"Objects00.r", "Objects00.g", "Objects00.b", "Objects00.a", "Objects.r", "Objects01.Red"}) {
    image.channels.push_back({name, {0.5f}});
  }
  writeImage(folder / "a.exr", image, {});
  for (const Channel& channel : readImage(folder / "a.exr", ImageParts::withLayers).channels) {
    CAPTURE(channel.name);
    CHECK(channel.isId ==
          (channel.name == "Objects00.r" || channel.name == "Objects00.b" || channel.name == "Objects01.Red"));
  }
}

TEST_CASE("EXR metadata cannot overwrite attributes of the format") {
  TemporaryFolder folder;
  Image image = testImage(1, 1);
  for (const char* name : {"channels", "compression", "type"}) {
    image.metadata = {{name, "x"}};
    CHECK_THROWS_WITH(writeImage(folder / "a.exr", image, {}), Catch::Contains(name));
  }
  CHECK(!std::filesystem::exists(folder / "a.exr"));
}

TEST_CASE("PFM files preserve every bit of the colours") {
  TemporaryFolder folder;
  const Image image = testImage(5, 3);
  writeImage(folder / "a.pfm", image, {});
  CHECK(readText(folder / "a.pfm").substr(0, 12) == "PF\n5 3\n-1.0\n");
  CHECK(std::filesystem::file_size(folder / "a.pfm") == 12 + 5 * 3 * 12);
  CHECK(readImage(folder / "a.pfm").rgb == image.rgb);
}

TEST_CASE("PFM files are read in both byte orders, in colour and grey, bottom row first") {
  TemporaryFolder folder;
  using namespace std::string_literals;
  // 1.0f is 3f800000, 2.0f is 40000000.
  writeText(folder / "big.pfm", "Pf\n1 2\n1.0\n\x3f\x80\0\0\x40\0\0\0"s);
  const Image big = readImage(folder / "big.pfm");
  CHECK(big.at(0, 0) == glm::vec3(2));
  CHECK(big.at(0, 1) == glm::vec3(1));
  writeText(folder / "little.pfm", "PF 1 1 -5\n\0\0\x80\x3f\0\0\0\x40\0\0\0\0"s);
  CHECK(readImage(folder / "little.pfm").at(0, 0) == glm::vec3(5, 10, 0));  // multiplied by the scale
}

TEST_CASE("HDR files preserve colours to half a step of the largest channel") {
  TemporaryFolder folder;
  for (const std::uint32_t width : {1u, 7u, 8u, 200u}) {  // below 8 pixels rows are not compressed
    const Image image = testImage(width, 3);
    writeImage(folder / "a.hdr", image, {});
    const Image back = readImage(folder / "a.hdr");
    REQUIRE(back.rgb.size() == image.rgb.size());
    for (std::size_t i = 0; i < image.rgb.size(); ++i) {
      const glm::vec3 difference = image.rgb[i] - back.rgb[i];
      const float largest = std::max({image.rgb[i].x, image.rgb[i].y, image.rgb[i].z});
      for (int c = 0; c < 3; ++c) {
        // The step is at most 1/128 of the largest channel, whose mantissa is 128 to 255.
        CHECK(std::abs(difference[c]) <= largest / 256 * 1.000001f);
      }
    }
  }
}

TEST_CASE("a ramp of 10^5 values has no bias in an HDR file") {
  TemporaryFolder folder;
  Image image;
  image.width = 1000;
  image.height = 100;
  double sum = 0;
  for (int i = 0; i < 100000; ++i) {
    const float value = 0.05f + 0.00009f * static_cast<float>(i);
    image.rgb.emplace_back(value, 0.3f * value, 0);
    sum += value;
  }
  writeImage(folder / "a.hdr", image, {});
  const Image back = readImage(folder / "a.hdr");
  double red = 0, green = 0;
  for (std::size_t i = 0; i < image.rgb.size(); ++i) {
    int exponent = 0;
    std::frexp(std::max(image.rgb[i].x, back.rgb[i].x), &exponent);  // a value may be rounded up to the next exponent
    const float step = std::ldexp(1.0f, exponent - 8);
    CHECK(std::abs(back.rgb[i].x - image.rgb[i].x) <= step / 2);
    CHECK(std::abs(back.rgb[i].y - image.rgb[i].y) <= step / 2);
    red += back.rgb[i].x;
    green += back.rgb[i].y;
  }
  CHECK(std::abs(red / sum - 1) < 2e-4);
  CHECK(std::abs(green / (0.3 * sum) - 1) < 2e-4);
}

TEST_CASE("HDR mantissas that are rounded up to 256 take the next exponent") {
  TemporaryFolder folder;
  Image image{1, 1, {glm::vec3(0.999f, 0.501f, 0.1234f)}, {}, {}, {}, {}};
  writeImage(folder / "a.hdr", image, {});
  CHECK(readImage(folder / "a.hdr").rgb[0] == glm::vec3(1, 64 / 128.0f, 16 / 128.0f));
}

TEST_CASE("HDR files store extreme values without wrapping") {
  TemporaryFolder folder;
  Image image{8, 1, std::vector<glm::vec3>(8, glm::vec3(1)), {}, {}, {}, {}};
  image.rgb[0] = glm::vec3(-1, std::nanf(""), 0);
  image.rgb[1] = glm::vec3(INFINITY, 1, 0);
  image.rgb[2] = glm::vec3(3e38f, 3e38f, 0);
  writeImage(folder / "a.hdr", image, {});
  const Image back = readImage(folder / "a.hdr");
  CHECK(back.rgb[0] == glm::vec3(0));
  CHECK(back.rgb[1].x > 1.5e38f);
  CHECK(back.rgb[2].y > 1.5e38f);
  CHECK(back.rgb[3] == glm::vec3(1));
}

TEST_CASE("HDR files of the old kind are read, and divided by their exposures") {
  TemporaryFolder folder;
  using namespace std::string_literals;
  const std::string pixel = "\x80\x40\x20\x81"s;  // mantissas 128 64 32, exponent 2^(129-136): 1, 1/2, 1/4
  writeText(folder / "old.hdr", "#?RGBE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE= 2\nEXPOSURE=0.5\n\n-Y 1 +X 300\n" + pixel +
                                    "\1\1\1\x2a"s + "\1\1\1\1"s + "\x80\x80\x80\x80"s);
  const Image image = readImage(folder / "old.hdr");  // 1 + 42 + 1 * 256 pixels, then one of value 1/2
  REQUIRE(image.rgb.size() == 300);
  CHECK(image.rgb[0] == glm::vec3(1, 0.5f, 0.25f));
  CHECK(image.rgb[298] == glm::vec3(1, 0.5f, 0.25f));
  CHECK(image.rgb[299] == glm::vec3(0.5f));

  writeText(folder / "exposed.hdr", "#?RADIANCE\nEXPOSURE=4\n\n-Y 1 +X 1\n" + pixel);
  CHECK(readImage(folder / "exposed.hdr").rgb[0] == glm::vec3(0.25f, 0.125f, 0.0625f));
}

TEST_CASE("HDR files are read in all eight directions") {
  TemporaryFolder folder;
  // The picture has the columns 1 2 3 above 4 5 6, as mantissas of red at an exponent of 2^0.
  const std::vector<std::pair<std::string, std::string>> directions{
      {"-Y 2 +X 3", "123456"}, {"-Y 2 -X 3", "321654"}, {"+Y 2 +X 3", "456123"}, {"+Y 2 -X 3", "654321"},
      {"+X 3 -Y 2", "142536"}, {"+X 3 +Y 2", "415263"}, {"-X 3 -Y 2", "362514"}, {"-X 3 +Y 2", "635241"}};
  for (const auto& [size, digits] : directions) {
    CAPTURE(size);
    std::string pixels;
    for (const char digit : digits) pixels += {static_cast<char>(digit - '0'), 0, 0, static_cast<char>(136)};
    writeText(folder / "a.hdr", "#?RADIANCE\n\n" + size + "\n" + pixels);
    const Image image = readImage(folder / "a.hdr");
    REQUIRE(image.width == 3);
    REQUIRE(image.height == 2);
    for (std::uint32_t i = 0; i < 6; ++i) CHECK(image.rgb[i] == glm::vec3(static_cast<float>(i + 1), 0, 0));
  }
}

TEST_CASE("HDR files are divided by COLORCORR, and what is not applied is named") {
  TemporaryFolder folder;
  const auto read = [&](const std::string& header) {
    writeText(folder / "a.hdr", "#?RADIANCE\n" + header + "\n\n-Y 1 +X 1\n\x80\x40\x20\x81");
    return readImage(folder / "a.hdr");
  };
  CHECK(read("COLORCORR= 2 4 0.5\nEXPOSURE=2\nGAMMA=1").rgb[0] == glm::vec3(0.25f, 0.0625f, 0.25f));
  CHECK(read("GAMMA=1").warnings.empty());
  for (const char* header : {"EXPOSURE=0", "EXPOSURE=-1", "EXPOSURE=nan", "COLORCORR=1 1", "COLORCORR=1 0 1",
                             "GAMMA=2.2", "PRIMARIES=0.6 0.3"}) {
    CAPTURE(header);
    const Image image = read(header);
    CHECK(image.rgb[0] == glm::vec3(1, 0.5f, 0.25f));
    REQUIRE(image.warnings.size() == 1);
    CHECK_THAT(image.warnings[0], Catch::StartsWith(std::string(header)) && Catch::Contains("is ignored"));
  }
}

TEST_CASE("PNG pixels are the display transform of the values in EXR") {
  TemporaryFolder folder;
  const Image image = testImage(64, 32);
  writeImage(folder / "a.exr", image, {});
  const Image linear = readImage(folder / "a.exr");
  for (const ToneMap toneMap :
       {ToneMap::none, ToneMap::srgb, ToneMap::aces, ToneMap::acesHill, ToneMap::agx, ToneMap::neutral}) {
    const DisplayTransform transform{toneMap, 1.5f};
    writeImage(folder / "a.png", image, transform);
    const Pixels8 stored = readPixels8(folder / "a.png");
    REQUIRE(stored.width == 64);
    REQUIRE(stored.height == 32);
    bool equal = true;
    for (std::size_t i = 0; i < linear.rgb.size(); ++i) {
      const glm::u8vec3 expected = toDisplay(linear.rgb[i], transform);
      for (std::size_t c = 0; c < 3; ++c) {
        equal = equal && stored.rgb[3 * i + c] == expected[static_cast<glm::length_t>(c)];
      }
    }
    CHECK(equal);
  }
}

TEST_CASE("alpha is straight in PNG files and premultiplied in EXR files, and other formats show it over black") {
  TemporaryFolder folder;
  Film film(3, 1);
  for (std::uint32_t i = 0; i < 4; ++i) {
    film.addSample(0, 0, i < 1 ? glm::dvec3(0.5, 0.25, 1) : glm::dvec3(0), i);
    film.addSample(1, 0, {0.125, 0.5, 1}, i);
    film.addSample(2, 0, glm::dvec3(0), i);
    if (i < 1) film.addHit(0, 0);
    film.addHit(1, 0);
  }
  Image image = toImage(film);
  CHECK(image.alpha.empty());
  addAlpha(image, film);
  REQUIRE(image.alpha == std::vector<float>{0.25f, 1, 0});

  writeImage(folder / "a.exr", image, {});
  const Image back = readImage(folder / "a.exr");
  CHECK(back.alpha == image.alpha);
  CHECK(back.at(0, 0) == glm::vec3(0.125f, 0.0625f, 0.25f));

  writeImage(folder / "a.png", image, {});
  const std::string bytes = readText(folder / "a.png");
  const Texels texels = decodeTexels(std::as_bytes(std::span(bytes)));
  const auto expected = [](const glm::vec3& colour, std::uint32_t alpha) {
    const glm::u8vec3 shown = toDisplay(colour, {});
    return shown.x | shown.y << 8 | shown.z << 16 | alpha << 24;
  };
  CHECK(texels.rgba == std::vector<std::uint32_t>{expected({0.5f, 0.25f, 1}, 64), expected({0.125f, 0.5f, 1}, 255), 0});

  writeImage(folder / "a.jpg", image, {});
  writeImage(folder / "a.pfm", image, {});
  CHECK(readImage(folder / "a.pfm").rgb == image.rgb);
  image.alpha.clear();
  writeImage(folder / "black.jpg", image, {});
  CHECK(readText(folder / "a.jpg") == readText(folder / "black.jpg"));
}

TEST_CASE("PNG files preserve every 8-bit value") {
  TemporaryFolder folder;
  const Pixels8 pixels = testPixels();
  writeImage(folder / "a.png", toImage(pixels), {});
  CHECK(readPixels8(folder / "a.png").rgb == pixels.rgb);
  CHECK(readImage(folder / "a.png").rgb == toImage(pixels).rgb);
}

TEST_CASE("JPEG files preserve colours approximately") {
  TemporaryFolder folder;
  Pixels8 pixels{24, 16, {}};
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 24; ++x) {
      for (const int value : {10 * x, 15 * y, 128}) pixels.rgb.push_back(static_cast<std::uint8_t>(value));
    }
  }
  for (const char* name : {"a.jpg", "a.JPEG"}) {
    writeImage(folder / name, toImage(pixels), {});
    const Pixels8 back = readPixels8(folder / name);
    REQUIRE(back.width == 24);
    REQUIRE(back.height == 16);
    for (std::size_t i = 0; i < pixels.rgb.size(); ++i) CHECK(std::abs(int{back.rgb[i]} - pixels.rgb[i]) <= 6);
  }
}

TEST_CASE("equal images give equal bytes in every format") {
  TemporaryFolder folder;
  const Image image = testImage(33, 40);
  for (const std::string extension : {".png", ".jpg", ".hdr", ".pfm", ".exr"}) {
    writeImage(folder / ("a" + extension), image, {});
    writeImage(folder / ("b" + extension), image, {});
    CHECK(readText(folder / ("a" + extension)) == readText(folder / ("b" + extension)));
  }
}

TEST_CASE("image formats are chosen by extension for writing and by content for reading") {
  checkImageFormat("a.png");
  checkImageFormat("folder.x/A.ExR");
  CHECK_THROWS_AS(checkImageFormat("a.bmp"), UsageError);
  CHECK_THROWS_AS(checkImageFormat("png"), UsageError);
  CHECK_THROWS_AS(writeImage("a.tiff", testImage(1, 1), {}), UsageError);

  TemporaryFolder folder;
  writeImage(folder / "a.png", toImage(testPixels()), {});
  std::filesystem::rename(folder / "a.png", folder / "a.jpg");
  CHECK(readPixels8(folder / "a.jpg").rgb == testPixels().rgb);
}

TEST_CASE("images without pixels and folders that do not exist are refused") {
  TemporaryFolder folder;
  for (const std::string extension : {".png", ".jpg", ".hdr", ".pfm", ".exr"}) {
    CHECK_THROWS_AS(writeImage(folder / ("a" + extension), Image(), {}), FileError);
    CHECK_THROWS_AS(writeImage(folder / ("none/a" + extension), testImage(2, 2), {}), FileError);
  }
  CHECK(std::filesystem::is_empty(folder.path()));
}

TEST_CASE("errors of image files name the file") {
  TemporaryFolder folder;
  CHECK_THROWS_WITH(readImage(folder / "none.exr"),
                    Catch::Contains("none.exr") && Catch::Contains("No such file or directory"));
  CHECK_THROWS_AS(readImage(folder.path()), FileError);
  writeText(folder / "text.png", "hello");
  CHECK_THROWS_WITH(readPixels8(folder / "text.png"), Catch::Contains("text.png"));
  CHECK_THROWS_WITH(readImage(folder / "text.png"), Catch::Contains("not a PNG, JPEG, WebP, HDR, PFM or EXR file"));
}
