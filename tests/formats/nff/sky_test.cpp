// Sky boxes: six images from permitted folders, or the background.
#include <catch2/catch.hpp>

#include "host/image/image.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

namespace fs = std::filesystem;

const fs::path kScenes = fs::path(CANDELA_SOURCE_DIR) / "scenes";

LoadedScene loadIn(const fs::path& folder, const std::string& text, const LoadOptions& options = {}) {
  return parseScene(text, "test", folder, options);
}

std::string errorIn(const fs::path& folder, const std::string& text) {
  try {
    loadIn(folder, text);
  } catch (const SceneError& error) {
    return toString(error.diagnostics.at(0));
  }
  return {};
}

}  // namespace

TEST_CASE("a sky box's six faces are read in order") {
  const LoadedScene loaded = loadIn(kScenes, "env sky # a comment\n");
  REQUIRE(loaded.scene.sky);
  for (const SkyFace& face : loaded.scene.sky->faces) {
    CHECK(face.width == 64);
    CHECK(face.height == 64);
    CHECK(face.rgb.size() == 64 * 64 * 3);
  }
  const auto& faces = loaded.scene.sky->faces;
  const auto middle = [&](int face) { return faces[face].rgb[3 * (64 * 32 + 32) + 2]; };
  CHECK(middle(2) > middle(3));         // the zenith is bluer than the water
  CHECK(faces[4].rgb != faces[5].rgb);  // the sun is in front
  CHECK(loaded.warnings.size() == 1);   // no objects
}

TEST_CASE("the sky's pixels are part of the hash") {
  CHECK(loadIn(kScenes, "env sky\n").scene.hash != loadIn("/nonexistent", "env sky\n").scene.hash);
}

TEST_CASE("a sky in a folder that does not exist gives one warning and the background") {
  const LoadedScene loaded = loadIn(kScenes, "b 1 0 0\nenv nowhere\nenv nowhere\n");
  CHECK_FALSE(loaded.scene.sky);
  CHECK(warningWith(loaded, "there is no folder \"nowhere\"").line == 2);
}

TEST_CASE("a sky outside the scene's folder is refused unless permitted") {
  const fs::path tests = kScenes.parent_path() / "tests";
  for (const std::string& name : {std::string("../scenes/sky"), (kScenes / "sky").string(), std::string("..")}) {
    CAPTURE(name);
    CHECK(contains(errorIn(tests, "env " + name + "\n"), "test:1:5: "));
    CHECK(contains(errorIn(tests, "env " + name + "\n"), "is outside the scene's folder"));
  }
  const LoadOptions permitting{.allowedPaths = {kScenes}};
  CHECK(loadIn(tests, "env ../scenes/sky\n", permitting).scene.sky);
  CHECK(loadIn(tests, "env " + (kScenes / "sky").string() + "\n", permitting).scene.sky);
  CHECK(loadIn(kScenes, "env " + (kScenes / "sky").string() + "\n").scene.sky);  // absolute, but inside
  CHECK(loadIn(kScenes, "env ./sky/../sky/\n").scene.sky);
}

TEST_CASE("a link out of the scene's folder is refused, to a folder and to a face") {
  const TemporaryFolder folder;
  fs::create_directory_symlink(kScenes / "sky", folder.path() / "sky");
  CHECK(contains(errorIn(folder.path(), "env sky\n"), "is outside the scene's folder"));
  fs::create_directory(folder.path() / "faces");
  for (const char* face : {"right", "left", "top", "bottom", "front", "back"}) {
    const std::string file = std::string(face) + ".png";
    fs::create_symlink(kScenes / "sky" / file, folder.path() / "faces" / file);
  }
  CHECK(contains(errorIn(folder.path(), "env faces\n"), "is outside the scene's folder"));
}

TEST_CASE("a missing or broken face is an error that names it, and lenient reading skips the sky") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "sky");
  CHECK(contains(errorIn(folder.path(), "env sky\n"), "has no right.jpg or right.png"));
  std::ofstream(folder.path() / "sky" / "right.png") << "not an image";
  CHECK(contains(errorIn(folder.path(), "env sky\n"), "right.png"));
  CHECK_FALSE(loadIn(folder.path(), "env sky\n", {.lenient = true}).scene.sky);
}

TEST_CASE("faces of a sky may be of any format that is read, and values above 1 are clipped with a warning") {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "sky");
  image::Image face{1, 1, {glm::vec3(0.5f)}, {}, {}, {}, {}};
  for (const char* name : {"right.exr", "left.hdr", "top.pfm", "bottom.png", "front.exr"}) {
    writeImage(folder.path() / "sky" / name, face, {});
  }
  face.rgb[0] = glm::vec3(4, 0.5f, 0);
  writeImage(folder.path() / "sky" / "back.exr", face, {});
  const LoadedScene loaded = loadIn(folder.path(), "env sky\n");
  REQUIRE(loaded.scene.sky);
  for (int i = 0; i < 5; ++i) CHECK(loaded.scene.sky->faces[i].rgb == std::vector<std::uint8_t>{188, 188, 188});
  CHECK(loaded.scene.sky->faces[5].rgb == std::vector<std::uint8_t>{255, 188, 0});
  CHECK_THAT(warningWith(loaded, "values above 1").message, Catch::Contains("back.exr"));
}

TEST_CASE("a control character in a sky's name is refused") {
  CHECK(contains(errorIn(kScenes, std::string("env sky\0/etc\n", 13)), "control character"));
}

}  // namespace candela::scene
