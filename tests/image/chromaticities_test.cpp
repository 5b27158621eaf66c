// Colours of other primaries are converted to Rec. 709.
#include "host/image/chromaticities.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "tests/base/temporary_folder.h"

using namespace candela;
using namespace candela::image;

namespace {

constexpr Chromaticities kRec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
constexpr Chromaticities kAcesAp1{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, {0.32168, 0.33767}};

void checkColumns(const Chromaticities& space, const glm::dmat3& expected) {
  const std::optional<glm::dmat3> matrix = toRec709(space);
  REQUIRE(matrix);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) CHECK((*matrix)[column][row] == Approx(expected[column][row]).margin(6e-4));
  }
}

/// Writes an EXR file of one pixel with these channels, of the values 1, 2, 3 ... in their order.
void writeChannels(const std::filesystem::path& file, const std::vector<std::string>& names,
                   const Chromaticities* space = nullptr) {
  std::vector<float> values;
  for (std::size_t i = 0; i < names.size(); ++i) values.push_back(static_cast<float>(i + 1));
  Imf::Header header(1, 1);
  Imf::FrameBuffer pixels;
  for (std::size_t i = 0; i < names.size(); ++i) {
    header.channels().insert(names[i], Imf::Channel(Imf::FLOAT));
    pixels.insert(names[i], Imf::Slice::Make(Imf::FLOAT, &values[i], header.dataWindow(), 4, 4));
  }
  if (space) {
    const auto point = [](const glm::dvec2& xy) {
      return Imath::V2f(static_cast<float>(xy.x), static_cast<float>(xy.y));
    };
    Imf::addChromaticities(header, {point(space->red), point(space->green), point(space->blue), point(space->white)});
  }
  Imf::OutputFile output(file.c_str(), header);
  output.setFrameBuffer(pixels);
  output.writePixels(1);
}

Image readChannels(const std::vector<std::string>& names, const Chromaticities* space = nullptr) {
  TemporaryFolder folder;
  writeChannels(folder / "a.exr", names, space);
  return readImage(folder / "a.exr", ImageParts::withLayers);
}

}  // namespace

TEST_CASE("the matrices of Rec. 2020 and of ACES are the published ones") {
  // Report ITU-R BT.2407, section 2.2.
  checkColumns(kRec2020, {{1.6605, -0.1246, -0.0182}, {-0.5876, 1.1329, -0.1006}, {-0.0728, -0.0083, 1.1187}});
  // AP1 to Rec. 709 with Bradford adaptation from D60, as in the ACES output transforms.
  checkColumns(kAcesAp1, {{1.7050, -0.1303, -0.0240}, {-0.6218, 1.1408, -0.1290}, {-0.0833, -0.0105, 1.1530}});
}

TEST_CASE("white stays white, whatever its chromaticity") {
  for (const glm::dvec2& white : {glm::dvec2(0.3127, 0.3290), glm::dvec2(1 / 3.0), glm::dvec2(0.4476, 0.4074)}) {
    Chromaticities space = kRec2020;
    space.white = white;
    const glm::dvec3 converted = toRec709(space).value() * glm::dvec3(1);
    for (int c = 0; c < 3; ++c) CHECK(converted[c] == Approx(1).epsilon(1e-12));
  }
}

TEST_CASE("chromaticities of an EXR file are applied, except those of Rec. 709") {
  const Image rec2020 = readChannels({"R", "G", "B"}, &kRec2020);
  CHECK(rec2020.rgb[0].x == Approx(1.6605 - 2 * 0.5876 - 3 * 0.0728).margin(1e-3));
  CHECK(rec2020.rgb[0].z == Approx(-0.0182 - 2 * 0.1006 + 3 * 1.1187).margin(1e-3));
  CHECK(rec2020.warnings.empty());
  constexpr Chromaticities kRec709;
  CHECK(readChannels({"R", "G", "B"}, &kRec709).rgb[0] == glm::vec3(1, 2, 3));
}

TEST_CASE("chromaticities that are no colour space are named, and ignored") {
  for (const Chromaticities& space : {Chromaticities{{0, 0}, {0, 0}, {0, 0}, {0, 0}},
                                      Chromaticities{{0.1, 0.1}, {0.2, 0.2}, {0.3, 0.3}, {0.3127, 0.3290}},
                                      Chromaticities{{NAN, 0.3}, {0.3, 0.6}, {0.15, 0.06}, {0.3127, 0.3290}}}) {
    CHECK(!toRec709(space));
    const Image image = readChannels({"R", "G", "B"}, &space);
    CHECK(image.rgb[0] == glm::vec3(1, 2, 3));
    REQUIRE(image.warnings.size() == 1);
    CHECK_THAT(image.warnings[0], Catch::Contains("chromaticities are ignored"));
  }
}

TEST_CASE("the only layer and the only channel of an EXR file are read, with a warning") {
  const Image layer = readChannels({"View.R", "View.G", "View.B", "View.A", "Depth.Z"});
  CHECK(layer.rgb[0] == glm::vec3(1, 2, 3));
  CHECK(layer.alpha == std::vector<float>{4});
  REQUIRE(layer.channels.size() == 1);
  CHECK(layer.channels[0].name == "Depth.Z");
  CHECK_THAT(layer.warnings.at(0), Catch::Contains("layer \"View\""));

  const Image grey = readChannels({"height"});
  CHECK(grey.rgb[0] == glm::vec3(1));
  CHECK_THAT(grey.warnings.at(0), Catch::Contains("\"height\" is read as grey"));
  const Image luminance = readChannels({"Y", "Z"});
  CHECK(luminance.rgb[0] == glm::vec3(1));
  CHECK(luminance.warnings.empty());
  REQUIRE(luminance.channels.size() == 1);
}

TEST_CASE("EXR files whose picture is not evident are refused by the name of what they have") {
  CHECK_THROWS_WITH(readChannels({"a.R", "a.G", "a.B", "b.R", "b.G", "b.B"}),
                    Catch::Contains("several layers") && Catch::Contains("--ch a.R,a.G,a.B"));
  CHECK_THROWS_WITH(readChannels({"Y", "RY", "BY"}), Catch::Contains("luminance and chroma"));
  CHECK_THROWS_WITH(readChannels({"R", "G"}), Catch::Contains("it has G, R"));
  CHECK_THROWS_AS(readChannels({"X", "Z"}), FileError);
}
