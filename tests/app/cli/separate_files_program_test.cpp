// No output of a command replaces another one, or a file that the command reads.
#include <catch2/catch.hpp>
#include <filesystem>

#include "host/image/image.h"
#include "tests/app/cli/film_runs.h"

namespace candela {
namespace {

using Catch::Contains;
using Words = std::vector<std::string>;

// Requires that the command ends with exit code 1 and this message before it writes anything.
void requireRefused(const TemporaryFolder& folder, const Words& words, const std::string& message) {
  const std::size_t before = folder.fileCount();
  const ProgramResult result = runCandela(words);
  INFO(Catch::StringMaker<Words>::convert(words));
  CHECK(result.exitCode == 1);
  CHECK_THAT(result.err, Contains(message));
  CHECK(folder.fileCount() == before);
}

Words withOptions(const std::string& scene, const Words& options) {
  Words words{scene, "--device", "cpu", "--size", "8x8", "--spp", "1", "-q"};
  words.insert(words.end(), options.begin(), options.end());
  return words;
}

// A textured triangle with a buffer b.bin and an image tex.png.
std::string writeModel(const TemporaryFolder& folder) {
  const float values[] = {-1, -1, 0, 1, -1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
  folder.write("b.bin", std::string(reinterpret_cast<const char*>(values), sizeof values));
  image::Image texel;
  texel.width = texel.height = 1;
  texel.rgb = {glm::vec3(0.5f)};
  writeImage(folder.path("tex.png"), texel, {});
  return folder.write("s.gltf", R"({"asset": {"version": "2.0"}, "scene": 0,
    "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}], "images": [{"uri": "tex.png"}],
    "buffers": [{"uri": "b.bin", "byteLength": 60}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}]})");
}

}  // namespace

TEST_CASE("two outputs of a command are never the same file, whether it exists or not") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("f.exr");
  const auto refuse = [&](const Words& options, const std::string& message) {
    requireRefused(folder, withOptions(scene, options), message);
  };
  refuse({"--checkpoint", film, "-o", film}, "f.exr: -o and --checkpoint would both write this file");
  refuse({"--checkpoint", film, "--json", film + ".json"}, "--json and the report of --checkpoint would both");
  std::filesystem::create_directory(folder.path("b"));
  refuse({"-o", folder.path("q.png"), "--json", folder.path("b/../q.png")}, "--json and -o would both");
  folder.write("q.png", "an old picture");
  std::filesystem::create_symlink("q.png", folder.path("link"));
  refuse({"-o", folder.path("q.png"), "--json", folder.path("link")}, "--json and -o would both");
}

TEST_CASE("outputs that are separate, stdout or devices are written") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string film = folder.path("f.exr");
  CHECK(runCandela(withOptions(scene, {"--checkpoint", film, "-o", folder.path("p.exr"), "--json", "-"})).exitCode ==
        0);
  CHECK(runCandela(withOptions(scene, {"--checkpoint", film, "--resume", film, "--json", "/dev/null"})).exitCode == 0);
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  folder.write("balls", "a file whose name is a kind of scene, which is no input");
  CHECK(runCandela({"generate", "balls", "-o", "balls", "-q"}).exitCode == 0);
  std::filesystem::current_path(before);
}

TEST_CASE("no output replaces a file that the scene reads") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string env = folder.path("env.hdr");
  REQUIRE(runCandela(withOptions(scene, {"-o", env})).exitCode == 0);
  requireRefused(folder, withOptions(scene, {"--env", env, "-o", env}), "env.hdr: this file is read by the command");
  const std::string model = writeModel(folder);
  for (const std::string file : {"b.bin", "tex.png"}) {
    const std::string path = folder.path(file);
    const std::string before = readText(path);
    requireRefused(folder, withOptions(model, {"--json", path}), file + ": this file is read by the command");
    requireRefused(folder, {"check", model, "--json", path}, file + ": this file is read by the command");
    requireRefused(folder, {"boxes", model, "-o", path}, file + ": this file is read by the command");
    CHECK(readText(path) == before);
  }
  CHECK(runCandela({"check", scene, "--env", "white", "--json", folder.path("white")}).exitCode == 0);
}

TEST_CASE("no output replaces an image of a scene's sky") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("sky"));
  const std::string plain = folder.write("a.p3f", smallScene());
  for (const std::string face : {"right", "left", "top", "bottom", "front", "back"}) {
    REQUIRE(runCandela(withOptions(plain, {"-o", folder.path("sky/" + face + ".png")})).exitCode == 0);
  }
  const std::string scene = folder.write("b.p3f", smallScene("env sky\n"));
  requireRefused(folder, withOptions(scene, {"-o", folder.path("sky/top.png")}), "top.png: this file is read");
}

TEST_CASE("a merge never replaces one of its films, nor its report") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const std::string a = folder.path("a.exr");
  const std::string b = folder.path("b.exr");
  const std::string bytes = kReference.film(scene, a, {"--samples", "0:4"});
  kReference.film(scene, b, {"--samples", "4:12"});
  requireRefused(folder, {"merge", a, b, "-o", a},
                 "a.exr: this file is read by the command, and -o would overwrite it");
  requireRefused(folder, {"merge", a, b, "-o", folder.path("c.exr"), "--json", a + ".json"}, "--json would overwrite");
  requireRefused(folder, {"film", a, "--json", a + ".json"}, "--json would overwrite");
  CHECK(readText(a) == bytes);
}

}  // namespace candela
