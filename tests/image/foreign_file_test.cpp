// Image files as other programs write them.
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDeepFrameBuffer.h>
#include <OpenEXR/ImfDeepScanLineOutputFile.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfTiledRgbaFile.h>
#include <jpeglib.h>
#include <png.h>

#include <array>
#include <bit>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "host/base/errors.h"
#include "host/base/input_file.h"
#include "host/image/image.h"
#include "tests/base/temporary_folder.h"
#include "tests/image/read_pixels8.h"
#include "tests/image/test_images.h"

using namespace candela;
using namespace candela::image;
namespace fs = std::filesystem;

namespace {

struct PngSpec {
  int bitDepth;
  int colourType;
  std::vector<png_color> palette = {};
  double gamma = 0;  // 0: not stated
  bool isRec2020 = false;
};

/// One row, with samples as the file stores them.
void writePngRow(const fs::path& file, std::uint32_t width, std::vector<std::uint8_t> row, const PngSpec& spec) {
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_init_io(png, stream);
  png_set_IHDR(png, info, width, 1, spec.bitDepth, spec.colourType, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  if (!spec.palette.empty()) png_set_PLTE(png, info, spec.palette.data(), static_cast<int>(spec.palette.size()));
  if (spec.gamma > 0) png_set_gAMA(png, info, spec.gamma);
  if (spec.isRec2020) png_set_cHRM(png, info, 0.3127, 0.329, 0.708, 0.292, 0.17, 0.797, 0.131, 0.046);
  png_write_info(png, info);
  png_write_row(png, row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  std::fclose(stream);
}

std::vector<int> pngPixels(std::uint32_t width, const std::vector<std::uint8_t>& row, const PngSpec& spec) {
  TemporaryFolder folder;
  writePngRow(folder / "a.png", width, row, spec);
  const Pixels8 pixels = readPixels8(folder / "a.png");
  CHECK(pixels.width == width);
  CHECK(pixels.height == 1);
  return {pixels.rgb.begin(), pixels.rgb.end()};
}

void writeGreyJpeg(const fs::path& file, std::uint8_t value, const std::string& profile = "") {
  std::FILE* stream = std::fopen(file.c_str(), "wb");
  jpeg_compress_struct info{};
  jpeg_error_mgr errors{};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  jpeg_stdio_dest(&info, stream);
  info.image_width = 8;
  info.image_height = 8;
  info.input_components = 1;
  info.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&info);
  jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  if (!profile.empty()) {
    jpeg_write_icc_profile(&info, reinterpret_cast<const JOCTET*>(profile.data()),
                           static_cast<unsigned>(profile.size()));
  }
  std::vector<JSAMPLE> row(8, value);
  for (int y = 0; y < 8; ++y) {
    JSAMPROW pointer = row.data();
    jpeg_write_scanlines(&info, &pointer, 1);
  }
  jpeg_finish_compress(&info);
  jpeg_destroy_compress(&info);
  std::fclose(stream);
}

/// Half-float pixels whose data window does not start at the origin.
const Imath::Box2i kDisplayWindow({0, 0}, {99, 99});
const Imath::Box2i kDataWindow({10, -5}, {13, -4});

std::vector<Imf::Rgba> halfPixels() {
  std::vector<Imf::Rgba> pixels;
  for (int y = 0; y < 2; ++y) {
    for (int x = 0; x < 4; ++x) pixels.emplace_back(static_cast<float>(x), static_cast<float>(y), 0.5f, 0.25f);
  }
  return pixels;
}

void writeBlackDwa(const fs::path& file, int side) {
  Imf::Header header(side, side);
  header.compression() = Imf::DWAB_COMPRESSION;
  Imf::RgbaOutputFile output(file.c_str(), header, Imf::WRITE_RGB);
  const std::vector<Imf::Rgba> row(static_cast<std::size_t>(side), Imf::Rgba(0, 0, 0));  // Rgba() is not initialised
  output.setFrameBuffer(row.data(), 1, 0);
  output.writePixels(side);
}

}  // namespace

TEST_CASE("PNG files of every kind become 8-bit RGB") {
  using Pixels = std::vector<int>;
  CHECK(pngPixels(2, {1, 2, 3, 250, 251, 252}, {8, PNG_COLOR_TYPE_RGB}) == Pixels{1, 2, 3, 250, 251, 252});
  CHECK(pngPixels(2, {7, 200}, {8, PNG_COLOR_TYPE_GRAY}) == Pixels{7, 7, 7, 200, 200, 200});
  // One bit a pixel: 10100000.
  CHECK(pngPixels(3, {0xa0}, {1, PNG_COLOR_TYPE_GRAY}) == Pixels{255, 255, 255, 0, 0, 0, 255, 255, 255});
  // Four bits a pixel, n * 17.
  CHECK(pngPixels(2, {0x5f}, {4, PNG_COLOR_TYPE_GRAY}) == Pixels{85, 85, 85, 255, 255, 255});
  // Palette indices of two bits: 2, 0.
  CHECK(pngPixels(2, {0x80}, {2, PNG_COLOR_TYPE_PALETTE, {{1, 2, 3}, {4, 5, 6}, {70, 80, 90}}}) ==
        Pixels{70, 80, 90, 1, 2, 3});
}

TEST_CASE("16-bit PNG files are rounded to 8 bits without a change of gamma") {
  // 0x8080 = 128 * 257 is 128 exactly; 0x0101 is 1; 0x80ff / 257 = 128.49 rounds down; 0x8101 / 257 = 128.502 up.
  CHECK(pngPixels(2, {0x80, 0x80, 0x01, 0x01, 0xff, 0xff, 0x80, 0xff, 0x81, 0x01, 0, 0}, {16, PNG_COLOR_TYPE_RGB}) ==
        std::vector<int>{128, 1, 255, 128, 129, 0});
}

TEST_CASE("images of 16-bit PNG files have 16 bits, and alpha unless all pixels are opaque") {
  TemporaryFolder folder;
  writePngRow(folder / "a.png", 2, {0x80, 0x80, 0x80, 0x81, 0, 0, 0xff, 0xff, 0xff, 0xff, 0, 0, 0xff, 0xff, 0x40, 0x00},
              {16, PNG_COLOR_TYPE_RGBA});
  const Image image = readImage(folder / "a.png");
  const auto linear = [](double signal) { return std::pow((signal / 65535 + 0.055) / 1.055, 2.4); };
  CHECK(image.at(0, 0).x == Approx(linear(0x8080)).epsilon(1e-7));
  CHECK(image.at(0, 0).y == Approx(linear(0x8081)).epsilon(1e-7));
  CHECK(image.at(0, 0).x != image.at(0, 0).y);
  CHECK(image.alpha == std::vector<float>{1, static_cast<float>(0x4000) / 65535});
  CHECK(image.at(1, 0) == glm::vec3(image.alpha[1], 0, image.alpha[1]));
  writePngRow(folder / "b.png", 1, {0x80, 0x80, 0x80, 0x81, 0, 0, 0xff, 0xff}, {16, PNG_COLOR_TYPE_RGBA});
  CHECK(readImage(folder / "b.png").alpha.empty());
}

TEST_CASE("a PNG of 16 bits and gamma 1/1.8 is converted by its gamma") {
  TemporaryFolder folder;
  writePngRow(folder / "a.png", 1, {0x40, 0x01, 0xff, 0xff, 0, 0}, {16, PNG_COLOR_TYPE_RGB, {}, 1 / 1.8});
  CHECK(readImage(folder / "a.png").at(0, 0).x == Approx(std::pow(16385.0 / 65535, 1.8)).epsilon(1e-4));
}

TEST_CASE("transparent PNG pixels are composited over black in linear light") {
  // Half opacity, 128/255 = 0.50196, of white: (1.055 * 0.50196^(1/2.4) - 0.055) * 255 = 187.8.
  CHECK(pngPixels(3, {255, 255, 255, 255, 9, 9, 9, 0, 255, 255, 255, 128}, {8, PNG_COLOR_TYPE_RGBA}) ==
        std::vector<int>{255, 255, 255, 0, 0, 0, 188, 188, 188});
}

TEST_CASE("a PNG of gamma 1 is encoded as sRGB") {
  // Linear 46/255 = 0.18039: sRGB 0.4621 * 255 = 117.8.
  const std::vector<int> pixels = pngPixels(1, {0, 46, 255}, {8, PNG_COLOR_TYPE_RGB, {}, 1.0});
  CHECK(pixels[0] == 0);
  CHECK(pixels[1] == Approx(118).margin(1));
  CHECK(pixels[2] == 255);
}

TEST_CASE("the chromaticities of a PNG are applied") {
  TemporaryFolder folder;
  writePngRow(folder / "a.png", 1, {255, 0, 0}, {8, PNG_COLOR_TYPE_RGB, {}, 1, true});
  const Image image = readImage(folder / "a.png");
  CHECK(image.rgb[0].x == Approx(1.6605).epsilon(1e-3));  // Report ITU-R BT.2407, section 2.2
  CHECK(image.rgb[0].y == Approx(-0.1246).epsilon(1e-2));
}

TEST_CASE("an ICC profile that does not name sRGB is named in a warning") {
  TemporaryFolder folder;
  using namespace std::string_literals;
  const auto warnings = [&](const std::string& profile) {
    writeGreyJpeg(folder / "a.jpg", 99, profile);
    return readImage(folder / "a.jpg").warnings;
  };
  CHECK(warnings("").empty());
  CHECK(warnings("a profile: sRGB IEC61966-2.1").empty());
  CHECK(warnings("\0s\0R\0G\0B"s).empty());
  REQUIRE(warnings("Adobe RGB (1998)").size() == 1);
  CHECK_THAT(warnings("Adobe RGB (1998)")[0], Catch::Contains("ICC profile is not applied"));
}

TEST_CASE("a grey progressive JPEG becomes RGB") {
  TemporaryFolder folder;
  writeGreyJpeg(folder / "a.jpg", 99);
  const Pixels8 pixels = readPixels8(folder / "a.jpg");
  CHECK(pixels.rgb == std::vector<std::uint8_t>(8 * 8 * 3, 99));
}

TEST_CASE("half-float EXR files are read, by lines and by tiles, from their data window") {
  TemporaryFolder folder;
  const std::vector<Imf::Rgba> pixels = halfPixels();
  const Imf::Header header(kDisplayWindow, kDataWindow, 1, {0, 0}, 1, Imf::DECREASING_Y, Imf::PIZ_COMPRESSION);
  {
    Imf::RgbaOutputFile lines((folder / "lines.exr").c_str(), header, Imf::WRITE_RGBA);
    lines.setFrameBuffer(pixels.data() - 10 + 5 * 4, 1, 4);
    lines.writePixels(2);
    Imf::Header tiledHeader(kDisplayWindow, kDataWindow);
    Imf::TiledRgbaOutputFile tiles((folder / "tiles.exr").c_str(), tiledHeader, Imf::WRITE_RGB, 3, 3, Imf::ONE_LEVEL);
    tiles.setFrameBuffer(pixels.data() - 10 + 5 * 4, 1, 4);
    tiles.writeTiles(0, tiles.numXTiles() - 1, 0, tiles.numYTiles() - 1);
  }
  for (const char* name : {"lines.exr", "tiles.exr"}) {
    const Image image = readImage(folder / name);
    REQUIRE(image.width == 4);
    REQUIRE(image.height == 2);
    CHECK(image.at(0, 0) == glm::vec3(0, 0, 0.5f));
    CHECK(image.at(3, 1) == glm::vec3(3, 1, 0.5f));
    CHECK(image.luminanceVariance.empty());
  }
}

TEST_CASE("an EXR file of luminance alone is grey, one with chroma is refused") {
  TemporaryFolder folder;
  const std::vector<Imf::Rgba> pixels = halfPixels();
  {
    Imf::RgbaOutputFile grey((folder / "grey.exr").c_str(), Imf::Header(4, 2), Imf::WRITE_Y);
    grey.setFrameBuffer(pixels.data(), 1, 4);
    grey.writePixels(2);
    Imf::RgbaOutputFile chroma((folder / "chroma.exr").c_str(), Imf::Header(4, 2), Imf::WRITE_YC);
    chroma.setFrameBuffer(pixels.data(), 1, 4);
    chroma.writePixels(2);
  }
  const Image image = readImage(folder / "grey.exr");
  // Pixel (3, 1): 0.2126 * 3 + 0.7152 + 0.0722 * 0.5, in half floats.
  CHECK(image.at(3, 1).x == Approx(1.3891).epsilon(2e-3));
  CHECK(image.at(3, 1).y == image.at(3, 1).x);
  CHECK(image.at(3, 1).z == image.at(3, 1).x);
  CHECK_THROWS_WITH(readImage(folder / "chroma.exr"), Catch::Contains("luminance and chroma"));
}

TEST_CASE("deep EXR files and those of several parts are refused by name") {
  TemporaryFolder folder;
  Imf::Header header(2, 1);
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  header.compression() = Imf::ZIPS_COMPRESSION;
  header.setType(Imf::DEEPSCANLINE);
  {
    std::array<unsigned, 2> counts{1, 1};
    std::array<float, 2> depths{3, 4};
    std::array<char*, 2> samples{reinterpret_cast<char*>(&depths[0]), reinterpret_cast<char*>(&depths[1])};
    Imf::DeepFrameBuffer pixels;
    pixels.insertSampleCountSlice({Imf::UINT, reinterpret_cast<char*>(counts.data()), sizeof(unsigned), 8});
    pixels.insert("Z", {Imf::FLOAT, reinterpret_cast<char*>(samples.data()), sizeof(char*), 16, sizeof(float)});
    Imf::DeepScanLineOutputFile file((folder / "deep.exr").c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(1);
  }
  CHECK_THROWS_WITH(readImage(folder / "deep.exr"),
                    Catch::Contains("deep.exr\": deep EXR files are not read") && Catch::Contains("--flatten"));
  header.setType(Imf::SCANLINEIMAGE);
  std::array<Imf::Header, 2> parts{header, header};
  parts[0].setName("left");
  parts[1].setName("right");
  { const Imf::MultiPartOutputFile file((folder / "parts.exr").c_str(), parts.data(), 2); }
  CHECK_THROWS_WITH(
      readImage(folder / "parts.exr"),
      Catch::Contains("parts.exr\": EXR files of several parts are not read") && Catch::Contains("--subimage"));
}

TEST_CASE("channels of integers are ids, whose bits are preserved, and subsampled channels are named") {
  TemporaryFolder folder;
  const std::vector<float> grey(4, 0.5f);
  const std::vector<std::uint32_t> ids{1, 0x7f800001u, 0xffffffffu, 16777217};
  Imf::Header header(4, 1);
  Imf::FrameBuffer pixels;
  const Imath::Box2i window = header.dataWindow();
  header.channels().insert("id", Imf::Channel(Imf::UINT));
  pixels.insert("id", Imf::Slice::Make(Imf::UINT, ids.data(), window, 4, 16));
  for (const char* name : {"R", "G", "B"}) {
    header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    pixels.insert(name, Imf::Slice::Make(Imf::FLOAT, grey.data(), window, 4, 16));
  }
  header.channels().insert("chroma", Imf::Channel(Imf::FLOAT, 2, 1));
  pixels.insert("chroma", Imf::Slice::Make(Imf::FLOAT, grey.data(), window, 4, 16, 2, 1));
  {
    Imf::OutputFile file((folder / "a.exr").c_str(), header);
    file.setFrameBuffer(pixels);
    file.writePixels(1);
  }
  const Image image = readImage(folder / "a.exr", ImageParts::withLayers);
  REQUIRE(image.channels.size() == 1);
  CHECK(image.channels[0].isId);
  for (std::size_t i = 0; i < ids.size(); ++i)
    CHECK(std::bit_cast<std::uint32_t>(image.channels[0].values[i]) == ids[i]);
  REQUIRE(image.warnings.size() == 1);
  CHECK_THAT(image.warnings[0], Catch::Contains("\"chroma\" is not read"));
}

TEST_CASE("an EXR file with DWA compression is read, and refused if it claims more pixels than its blocks can hold") {
  const TemporaryFolder folder;
  const int side = 2048;
  writeBlackDwa(folder / "a.exr", side);  // the most pixels per byte that an honest file has
  std::string bytes = readInputFile(folder / "a.exr", std::size_t{1} << 20, InputKind::regularFile);
  CHECK(bytes.size() < 64u * 1024);
  CHECK(readImage(folder / "a.exr").rgb.size() == std::size_t{side} * side);
  const std::string name("dataWindow\0box2i\0", 17);
  const std::size_t maximum = bytes.find(name) + name.size() + 4 + 8;  // after the attribute's size and the minimum
  const std::int32_t claimed[] = {65534, 4095};
  bytes.replace(maximum, sizeof claimed, reinterpret_cast<const char*>(claimed), sizeof claimed);
  std::ofstream(folder / "b.exr", std::ios::binary) << bytes;
  CHECK_THROWS_WITH(readImage(folder / "b.exr"), Catch::Contains("truncated"));
}
