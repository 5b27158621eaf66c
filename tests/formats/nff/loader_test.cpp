// The choice of a loader: by content, then by extension, else an error that names the formats.
#include "host/formats/loading/loader.h"

#include "host/base/hash.h"
#include "host/formats/load_scene.h"
#include "host/formats/nff/nff_loader.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

std::unique_ptr<SceneReader> openNothing(const SceneFile&, const LoadOptions&, bool) { return {}; }

/// A binary format with a signature, and a text format that recognises nothing.
const std::vector<Loader> kLoaders{
    {"Signed", {".sig", ".bin"}, [](std::string_view bytes) { return bytes.starts_with("SIG:"); }, openNothing},
    {"Plain", {".txt"}, [](std::string_view) { return false; }, openNothing}};

std::string chosen(std::string_view bytes, const std::string& name) {
  return std::string(chooseLoader(kLoaders, {bytes, name, "."}).name);
}

/// Returns the message of the only error that loadScene reports for a file with this text.
Diagnostic errorOfFile(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / name, text);
  try {
    formats::loadScene(folder / name);
  } catch (const SceneError& error) {
    REQUIRE(error.diagnostics.size() == 1);
    return error.diagnostics.front();
  }
  FAIL("the file is read");
  return {};
}

Scene sceneOfFile(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  writeText(folder / name, text);
  return formats::loadScene(folder / name).scene;
}

}  // namespace

TEST_CASE("the hash of a large file is that of its bytes, as that of a small one") {
  for (const std::size_t length : {std::size_t{10}, std::size_t{3} << 20}) {
    const std::string text = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 1\nresolution 8 6\n#" +
                             std::string(length, '.') + "\ns 0 0 0 1\n";
    INFO(length);
    CHECK(sceneOfFile("a.nff", text).hash == fnv1aOfText(text));
  }
}

TEST_CASE("the content of a file takes precedence over its extension") {
  CHECK(chosen("SIG:\1", "scene.txt") == "Signed");
  CHECK(chosen("SIG:", "scene") == "Signed");
  CHECK(chosen("SIG", "scene.txt") == "Plain");
}

TEST_CASE("the extension, in any case, decides if the content does not") {
  CHECK(chosen("", "scene.sig") == "Signed");
  CHECK(chosen("", "a.txt/scene.bin") == "Signed");
  CHECK(chosen("", "scene.bin.TXT") == "Plain");
}

TEST_CASE("an unknown format is refused, with the formats that can be read") {
  for (const char* name : {"scene.obj", "scene", "folder.sig/scene", ".sig", "scene.sig.gz"}) {
    CAPTURE(name);
    CHECK_THROWS_WITH(chosen("solid", name),
                      Catch::Contains("unknown scene format") && Catch::Contains("Signed (.sig, .bin), Plain (.txt)"));
  }
}

TEST_CASE("NFF is recognised under any name, and read by its extension if it is not recognised") {
  CHECK(sceneOfFile("scene.obj", "# a ball\ns 0 0 0 1\n").spheres.size() == 1);
  CHECK(sceneOfFile("scene",
                    "\xef\xbb\xbf"
                    "f 1 1 1 1 0 1 0 1\ns 0 0 0 1\n")
            .spheres.size() == 1);
  CHECK(sceneOfFile("empty.NFF", "# nothing\n").primitives.empty());
  CHECK(errorOfFile("empty.NFF", "").message == "the file is empty");
  CHECK(errorOfFile("windows.nff", "\xff\xfe#").message == "the file is text in UTF-16; save it in UTF-8");
  CHECK(contains(errorOfFile("scene.p3f", "spehre 0 0 0 1\n").message, "unknown keyword"));
}

TEST_CASE("a file that is no scene is refused as a whole") {
  for (const char* text : {"solid cube\n", "\x89PNG\r\n", "[\"asset\"]"}) {
    CAPTURE(text);
    const Diagnostic error = errorOfFile("scene.stl", text);
    CHECK(contains(error.message, "unknown scene format"));
    CHECK(contains(error.message,
                   "glTF 2.0 (.gltf, .glb), PLY (.ply), Mitsuba (.xml), OBJ (.obj), NFF or P3F (.nff, .p3f)"));
    CHECK(contains(error.file, "scene.stl"));
    CHECK(error.line == 0);
  }
}

TEST_CASE("WorldToolKit's NFF is refused by name under any extension") {
  for (const char* name : {"scene.nff", "scene.wtk"}) {
    CHECK(contains(errorOfFile(name, "// a model\nnff version 2.1\n").message, "WorldToolKit"));
  }
}

TEST_CASE("options of glTF cause a warning for NFF and P3F, which are read nevertheless") {
  const std::string text = "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 40\nhither 0\nresolution 8 8\ns 0 0 0 1\n";
  LoadOptions named;
  named.camera = "left";
  LoadOptions timed;
  timed.time = 1;
  for (const LoadOptions& options : {named, timed}) {
    const LoadedScene loaded = parseScene(text, "test", ".", options);
    warningWith(loaded, "camera and time have no effect: the format has one view and no animation");
    CHECK(loaded.scene.camera->from == glm::vec3(0, 0, 5));
  }
  CHECK_FALSE(
      std::ranges::any_of(load(text).warnings, [](const Diagnostic& d) { return contains(d.message, "time have"); }));
}

}  // namespace candela::scene
