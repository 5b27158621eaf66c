// Environments from files and by name, and their effect on a scene that is loaded with one.
#include "host/scene/environment/environment.h"

#include <OpenEXR/ImfRgbaFile.h>
#include <OpenEXR/ImfStandardAttributes.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <limits>

#include "host/base/errors.h"
#include "host/formats/load_scene.h"
#include "host/image/image.h"
#include "tests/base/temporary_folder.h"

using namespace candela;
using namespace candela::environment;
using glm::vec3;

namespace {

class MapFile {
 public:
  explicit MapFile(const image::Image& image, const std::string& name = "map.pfm") : file_(folder_ / name) {
    writeImage(file_, image, {});
  }

  const std::filesystem::path& folder() const { return folder_.path(); }
  std::string path() const { return file_.string(); }

 private:
  TemporaryFolder folder_;
  std::filesystem::path file_;
};

image::Image gradient() {
  image::Image image{4, 2, {}, {}, {}, {}, {}};
  for (int i = 0; i < 8; ++i) image.rgb.emplace_back(i, 2 * i, 1);
  return image;
}

scene::LoadedScene loadUnder(const MapFile& map, const std::string& up, double rotation = 0, double scale = 1) {
  const std::filesystem::path file = map.folder() / "scene.nff";
  std::ofstream(file) << "v\nfrom 3 2 1\nat 0 0 0\nup " << up
                      << "\nangle 40\nhither 0\nresolution 8 8\nb 1 2 3\nf 1 1 1 1 0 0 0 1\ns 0 0 0 1\n";
  return formats::loadScene(file, {.environment = {.source = map.path(), .rotation = rotation, .scale = scale}});
}

}  // namespace

TEST_CASE("a map has the pixels of its file, scaled, and negative ones become 0") {
  image::Image image = gradient();
  image.rgb[3] = vec3(-1, 4, -0.5f);
  const MapFile file(image);
  const scene::Environment map = makeEnvironment({.source = file.path(), .rotation = 0, .scale = 2.5}, {0, 1, 0});
  CHECK(map.width == 4);
  CHECK(map.height == 2);
  CHECK(map.texels[6] == vec3(15, 30, 2.5f));
  CHECK(map.texels[3] == vec3(0, 10, 0));
  CHECK(map.name == "map.pfm");
}

TEST_CASE("maps in OpenEXR and Radiance files are read") {
  for (const char* name : {"map.exr", "map.hdr"}) {
    const MapFile file(gradient(), name);
    CHECK(makeEnvironment({.source = file.path()}, {0, 1, 0}).texels[4] == vec3(4, 8, 1));
  }
}

TEST_CASE("a map with a radiance that is not finite is refused, with the place of the pixel") {
  image::Image image = gradient();
  image.rgb[6].y = std::numeric_limits<float>::infinity();
  const MapFile file(image);
  CHECK_THROWS_WITH(makeEnvironment({.source = file.path()}, {0, 1, 0}), Catch::Contains("pixel 2,1 is not finite"));
  const MapFile finite(gradient());
  CHECK_THROWS_AS(makeEnvironment({.source = finite.path(), .rotation = 0, .scale = 1e39}, {0, 1, 0}), FileError);
}

TEST_CASE("a cube map is refused by its attribute, and a map of latitude and longitude is read") {
  for (const auto& [kind, isRead] : {std::pair(Imf::ENVMAP_LATLONG, true), std::pair(Imf::ENVMAP_CUBE, false)}) {
    const TemporaryFolder folder;
    const std::string file = folder.path() / "map.exr";
    Imf::Header header(1, 6);
    Imf::addEnvmap(header, kind);
    const std::vector<Imf::Rgba> pixels(6, Imf::Rgba(1, 2, 3));
    {
      Imf::RgbaOutputFile output(file.c_str(), header, Imf::WRITE_RGB);
      output.setFrameBuffer(pixels.data(), 1, 1);
      output.writePixels(6);
    }
    if (isRead) {
      CHECK(makeEnvironment({.source = file}, {0, 1, 0}).texels == std::vector<vec3>(6, vec3(1, 2, 3)));
    } else {
      CHECK_THROWS_WITH(makeEnvironment({.source = file}, {0, 1, 0}), Catch::Contains("is a cube map (envmap = cube)"));
    }
  }
}

TEST_CASE("lenient reading replaces pixels that are not finite by black, and tells their number") {
  image::Image image = gradient();
  image.rgb[6].y = std::numeric_limits<float>::infinity();
  image.rgb[1].x = std::numeric_limits<float>::quiet_NaN();
  const MapFile file(image);
  const ReadEnvironment read = readEnvironment({.source = file.path()}, {0, 1, 0}, true);
  CHECK(read.environment.texels[6] == vec3(0));
  CHECK(read.environment.texels[1] == vec3(0));
  CHECK(read.environment.texels[5] == gradient().rgb[5]);
  REQUIRE(read.warnings.size() == 1);
  CHECK(read.warnings[0] == "2 of 8 pixels are not finite, and are replaced by black");
}

TEST_CASE("an EXR map covers its display window, and is black outside the data window") {
  image::Image image = gradient();  // 4 x 2
  image.origin = {6, 3};
  image.frame = image::PixelBox{2, 1, 7, 5};  // cuts off the last column of the data window
  const MapFile file(image, "map.exr");
  const scene::Environment map = makeEnvironment({.source = file.path()}, {0, 1, 0});
  REQUIRE(map.width == 7);
  REQUIRE(map.height == 5);
  for (std::uint32_t y = 0; y < 5; ++y) {
    for (std::uint32_t x = 0; x < 7; ++x) {
      const bool isInside = x >= 4 && y >= 2 && y < 4;
      CHECK(map.texels[y * 7 + x] == (isInside ? gradient().at(x - 4, y - 2) : vec3(0)));
    }
  }
  image.origin = {20, 3};
  const MapFile outside(image, "map.exr");
  const ReadEnvironment black = readEnvironment({.source = outside.path()}, {0, 1, 0}, false);
  CHECK(black.environment.texels == std::vector<vec3>(35, vec3(0)));
  CHECK_THAT(black.warnings.at(0), Catch::Contains("outside the display window"));
  image.frame = image::PixelBox{0, 0, 1 << 20, 1 << 20};
  const MapFile huge(image, "map.exr");
  CHECK_THROWS_WITH(makeEnvironment({.source = huge.path()}, {0, 1, 0}), Catch::Contains("at most 33554432 pixels"));
}

TEST_CASE("an environment that does not exist or is no image is refused") {
  CHECK_THROWS_AS(makeEnvironment({.source = "/nowhere/map.hdr"}, {0, 1, 0}), FileError);
  CHECK_THROWS_AS(makeEnvironment({.source = CANDELA_SOURCE_DIR "/README.md"}, {0, 1, 0}), FileError);
}

TEST_CASE("an environment is white on request") {
  const scene::Environment white = makeEnvironment({.source = "white", .rotation = 0, .scale = 3}, {0, 0, 1});
  for (const vec3& texel : white.texels) REQUIRE(texel == vec3(3));
}

TEST_CASE("the axis closest to the view's up vector points up in NFF") {
  const MapFile file(gradient());
  CHECK(loadUnder(file, "0.1 1 0.2").scene.environment->axes[1] == vec3(0, 1, 0));
  CHECK(loadUnder(file, "0 0.1 -1").scene.environment->axes[1] == vec3(0, 0, -1));
  CHECK(loadUnder(file, "1 1 1").scene.environment->axes[1] == vec3(0, 1, 0));
  CHECK(loadUnder(file, "-1 0 1").scene.environment->axes[1] == vec3(0, 0, 1));
}

TEST_CASE("the hash of a scene covers pixels, scale and rotation of its environment, and not the name of the file") {
  const MapFile file(gradient());
  const MapFile renamed(gradient(), "other.pfm");
  image::Image changed = gradient();
  changed.rgb[7].z = 1.0000001f;
  const MapFile different(changed);
  const std::uint64_t hash = loadUnder(file, "0 1 0").scene.hash;
  CHECK(loadUnder(renamed, "0 1 0").scene.hash == hash);
  CHECK(loadUnder(different, "0 1 0").scene.hash != hash);
  CHECK(loadUnder(file, "0 1 0", 10).scene.hash != hash);
  CHECK(loadUnder(file, "0 1 0", 0, 2).scene.hash != hash);
}
