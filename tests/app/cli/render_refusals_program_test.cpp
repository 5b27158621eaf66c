// Renders that `candela render` refuses: outputs, scenes and settings that are wrong.
#include <catch2/catch.hpp>
#include <filesystem>

#include "tests/app/cli/run_program.h"

namespace candela {

// A triangle, with the accessors of a file without buffer: all of its vertices are at the origin.
constexpr const char* kGltf = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
"accessors": [{"componentType": 5126, "count": 3, "type": "VEC3"}]})";

TEST_CASE("the Whitted integrator refuses glTF, and nothing is written") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.gltf", kGltf);
  const std::vector<std::string> render{scene, "-o", folder.path("a.png"), "--device", "cpu", "--size", "4x4"};
  std::vector<std::string> whitted = render;
  whitted.insert(whitted.end(), {"--integrator", "whitted"});
  const ProgramResult refused = runCandela(whitted);
  CHECK(refused.exitCode == 1);
  CHECK(contains(refused.err, "a.gltf: the materials have no coefficients for Whitted ray tracing"));
  CHECK(contains(refused.err, "use --integrator path"));
  CHECK(folder.fileCount() == 1);
  CHECK(runCandela(render).exitCode == 0);
}

TEST_CASE("an output that cannot be written is refused before any work, and no file is left") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  struct Case {
    std::vector<std::string> outputs;
    int exitCode;
    const char* message;
  };
  const std::vector<Case> cases{
      {{"-o", folder.path("missing/a.png")}, 2, "there is no folder"},
      {{"-o", folder.path("a.png"), "-o", folder.path("missing/b.exr")}, 2, "there is no folder"},
      {{"-o", folder.path("a.tga")}, 1, ".png"},
      {{"-o", folder.path("noextension")}, 1, ".png"},
      {{"-o", folder.path("")}, 2, "is a folder"},
      {{"-o", folder.path("a.png"), "--json", folder.path("missing/a.json")}, 2, "there is no folder"},
      {{"-o", "/proc/a.png"}, 2, "cannot write \"/proc/a.png\""},
      {{"--json", "/proc/a.json"}, 2, "cannot write \"/proc/a.json\""},
      {{"--checkpoint", "/proc/a.exr"}, 2, "cannot write \"/proc/a.exr\""}};
  for (const Case& each : cases) {
    std::vector<std::string> words{scene, "--device", "cpu", "--spp", "100000000"};
    words.insert(words.end(), each.outputs.begin(), each.outputs.end());
    const ProgramResult result = runCandela(words);
    INFO(words.back() << ": " << result.err);
    if (words.back() == folder.path("")) {
      CHECK((result.exitCode == 1 || result.exitCode == 2));
    } else {
      CHECK(result.exitCode == each.exitCode);
      CHECK(contains(result.err, each.message));
    }
    CHECK(contains(result.err, "candela: "));
    CHECK(folder.fileCount() == 1);
  }
}

TEST_CASE("an invalid scene gives no image, but a message for every invalid line") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("broken.p3f", smallScene("spehre 0 0 0 1\ns 0 0\n"));
  const ProgramResult result = runCandela({scene, "-o", folder.path("a.png"), "--device", "cpu"});
  CHECK(result.exitCode == 2);
  CHECK(contains(result.err, "broken.p3f:18:1: "));
  CHECK(contains(result.err, "broken.p3f:19:"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("an empty file is refused without warnings about the scene") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("empty.p3f", "");
  const ProgramResult result = runCandela({scene, "-o", folder.path("a.png"), "--device", "cpu"});
  CHECK(result.exitCode == 2);
  CHECK(result.err == "candela: " + scene + ": the file is empty\n");
  CHECK(contains(runCandela({"check", scene}).err, "the file is empty"));
}

TEST_CASE("a missing scene exits with the code of a file error") {
  const ProgramResult result = runCandela({"/nowhere/scene.p3f", "-o", "a.png", "--device", "cpu"});
  CHECK(result.exitCode == 2);
  CHECK(contains(result.err, "/nowhere/scene.p3f"));
}

TEST_CASE("images beyond the stated limits of size are refused") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const auto run = [&](const std::string& size) {
    return runCandela({scene, "-o", folder.path("a.png"), "--device", "cpu", "--size", size});
  };
  const ProgramResult side = run("70000x1");
  CHECK(side.exitCode == 1);
  CHECK(contains(side.err, "65535"));
  const ProgramResult area = run("65535x65535");
  CHECK(area.exitCode == 2);
  CHECK(contains(area.err, "268435456 pixels"));
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("the wavefront is refused for integrators that trace no paths") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  for (const char* integrator : {"whitted", "ao"}) {
    const ProgramResult result = runCandela(
        {scene, "-o", folder.path("a.png"), "--device", "cpu", "--integrator", integrator, "--kernel", "wavefront"});
    CHECK(result.exitCode == 1);
    CHECK(contains(result.err, "the wavefront kernels trace paths alone"));
  }
  CHECK(folder.fileCount() == 1);
}

}  // namespace candela
