// `candela check`, `candela devices`, and the behaviour without a device.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/cli/run_program.h"

namespace candela {
namespace {

using nlohmann::json;

// The surroundings of a machine without any Vulkan driver.
const Surroundings kNoDriver{{"VK_DRIVER_FILES=/nonexistent", "VK_ICD_FILENAMES=/nonexistent"}, "", {}};

// Scenes in glTF of squares at heights, one node for each. Without a name, the node has that of its mesh.
std::string squaresInGltf(const std::vector<std::pair<std::string, float>>& squares) {
  // The corners of a square of side 1 and its triangles.
  json file = json::parse(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": []}], "nodes": [],
    "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,)"
                          R"(AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAACAPwAAgD8AAAAAAAAAAAAAgD8AAAAAAAABAAIAAAACAAMA"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "meshes": [{"name": "Square", "primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}]})");
  for (const auto& [name, height] : squares) {
    file["scenes"][0]["nodes"].push_back(file["nodes"].size());
    file["nodes"].push_back({{"mesh", 0}, {"translation", {0, 0, height}}});
    if (!name.empty()) file["nodes"].back()["name"] = name;
  }
  return file.dump();
}

}  // namespace

TEST_CASE("check describes the content of a scene") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const ProgramResult text = runCandela({"check", scene});
  CHECK(text.exitCode == 0);
  CHECK(contains(text.out, "spheres 2"));
  const ProgramResult result = runCandela({"check", scene, "--json", "-"});
  const json entry = json::parse(result.out)["files"][0];
  CHECK(entry["valid"] == true);
  CHECK(entry["file"] == scene);
  CHECK(entry["errors"].empty());
  CHECK(entry["report"]["primitives"]["spheres"] == 2);
}

TEST_CASE("check warns of emitters that are too weak to be sampled by their power") {
  const TemporaryFolder folder;
  const std::string strong = "f 1 1 1 0 0 2 0 1 1e8 1e8 1e8\ns 0 0 5 10\n",
                    weak = "f 1 1 1 0 0 2 0 1 1 1 1\ns 0 0 -1 0.1\n";
  const ProgramResult both = runCandela({"check", folder.write("both.p3f", strong + weak)});
  CHECK(both.exitCode == 0);
  CHECK(contains(both.out, "--lights power, the default for this scene, never samples 1 emitter, whose share"));
  const ProgramResult one = runCandela({"check", folder.write("one.p3f", strong)});
  CHECK_FALSE(contains(one.out, "never samples"));
}

TEST_CASE("check counts and names surfaces of NFF and P3F that coincide or overlap in one plane") {
  const TemporaryFolder folder;
  const std::string material = "f 1 1 1 1 0 0 0 1\n";
  const std::string doubled = folder.write(
      "a.nff", material + "p 3 0 0 0 1 0 0 0 1 0\np 3 1 0 0 0 1 0 0 0 0\ns 5 5 5 1\ns 5 5 5 1\n");
  const ProgramResult nff = runCandela({"check", doubled});
  CHECK(nff.exitCode == 0);
  CHECK(contains(nff.out, "  coincident  4 primitives in 2 pairs of objects\n"));
  CHECK(contains(nff.out,
                 "  coincident  1 triangle of object triangle.1 coincides with 1 triangle of object triangle.0\n"));
  CHECK(contains(nff.out, "  coincident  1 sphere of object sphere.3 coincides with 1 sphere of object sphere.2\n"));
  const std::string plane = folder.write("a.p3f",
                                         material + "pl 0 0 0 1 0 0 0 1 0\nbox 1 1 0 2 2 2\nbox 1 1 3 2 2 4\n");
  const ProgramResult p3f = runCandela({"check", plane});
  CHECK(contains(p3f.out, "  coincident  1 box of object box.1 overlaps 1 plane of object plane.0 in one plane\n"));
  const ProgramResult apart = runCandela({"check", folder.write("apart.nff", material + "p 3 0 0 0 1 0 0 0 1 0\n")});
  CHECK(apart.exitCode == 0);
  CHECK_FALSE(contains(apart.out, "coincident"));
}

TEST_CASE("check names the nodes of glTF whose surfaces coincide, and JSON has their numbers") {
  const TemporaryFolder folder;
  const std::string file = folder.write("a.gltf", squaresInGltf({{"Floor", 0}, {"Lid", 1}, {"Floor.001", 0}, {"", 1}}));
  const ProgramResult text = runCandela({"check", file});
  CHECK(text.exitCode == 0);
  CHECK(contains(text.out, "  coincident  8 primitives in 2 pairs of objects\n"));
  CHECK(
      contains(text.out, "  coincident  2 triangles of object Floor.001 coincide with 2 triangles of object Floor\n"));
  CHECK(contains(text.out, "  coincident  2 triangles of object Square coincide with 2 triangles of object Lid\n"));
  const ProgramResult result = runCandela({"check", file, "--json", "-"});
  const json report = json::parse(result.out)["files"][0]["report"];
  CHECK(report["coincidentPrimitives"] == 8);
  REQUIRE(report["coincident"].size() == 2);
  CHECK(report["coincident"][0] ==
        json::parse(R"({"objects": ["Floor", "Floor.001"], "oneObject": false, "copies": 2, "overlaps": 0})"));
  const ProgramResult apart = runCandela(
      {"check", folder.write("b.gltf", squaresInGltf({{"A", 0}, {"B", 1}})), "--json", "-"});
  const json none = json::parse(apart.out)["files"][0]["report"];
  CHECK(none["coincidentPrimitives"] == 0);
  CHECK(none["coincident"] == json::array());
}

TEST_CASE("check reads every file, lists all errors, and exits with 2") {
  const TemporaryFolder folder;
  const std::string broken = folder.write("broken.p3f", smallScene("spehre 0 0 0 1\ns 0 0 x 1\n"));
  const std::string whole = folder.write("whole.p3f", smallScene());
  const ProgramResult result = runCandela({"check", broken, folder.path("missing.p3f"), whole, "--json", "-"});
  CHECK(result.exitCode == 2);
  CHECK(contains(result.err, "broken.p3f:18:1: "));
  CHECK(contains(result.err, "broken.p3f:19:7: "));
  const json files = json::parse(result.out)["files"];
  REQUIRE(files.size() == 3);
  CHECK(files[0]["valid"] == false);
  REQUIRE(files[0]["errors"].size() == 2);
  CHECK(files[0]["errors"][0]["line"] == 18);
  CHECK(files[0]["errors"][1]["column"] == 7);
  CHECK(files[1]["valid"] == false);
  CHECK(files[2]["valid"] == true);
}

TEST_CASE("the option --lenient accepts files that are otherwise refused, with a warning") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene("wibble 1 2 3\n"));
  CHECK(runCandela({"check", scene, "-q"}).exitCode == 2);
  const ProgramResult lenient = runCandela({"check", scene, "--lenient"});
  CHECK(lenient.exitCode == 0);
  CHECK(contains(lenient.out, "wibble"));
}

TEST_CASE("a report that cannot be written is an error") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  const Surroundings fullDisk{{}, "/dev/full", {}};
  CHECK(runCandela({"check", scene}, fullDisk).exitCode == 2);
  CHECK(runCandela({"--help"}, fullDisk).exitCode == 2);
}

TEST_CASE("the program without a Vulkan driver exits with 4 and names the packages to install") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  for (const auto& words :
       {std::vector<std::string>{"devices"}, {scene, "-o", folder.path("a.png")}, {"compare", scene}}) {
    const ProgramResult result = runCandela(words, kNoDriver);
    INFO(words.front() << ": " << result.err);
    CHECK(result.exitCode == 4);
    CHECK(contains(result.err, "mesa-vulkan-drivers"));
  }
  CHECK(folder.fileCount() == 1);
}

TEST_CASE("the reference tracer needs no Vulkan driver") {
  const TemporaryFolder folder;
  const std::string scene = folder.write("a.p3f", smallScene());
  CHECK(runCandela({scene, "-o", folder.path("a.png"), "--spp", "1", "--device", "cpu"}, kNoDriver).exitCode == 0);
}

}  // namespace candela
