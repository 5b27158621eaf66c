// GLB and JSON files, and the choice of the loader.
#include "host/formats/gltf/container.h"

#include "host/formats/load_scene.h"
#include "tests/base/temporary_folder.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {

TEST_CASE("GLB and JSON give the same scene") {
  const GltfFile file = triangleFile();
  const scene::Scene fromText = sceneOf(file);
  const scene::Scene fromBinary = loadText(file.glb()).scene;
  REQUIRE(fromText.primitives.size() == 1);
  CHECK(fromBinary.meshes.at(0).positions == fromText.meshes.at(0).positions);
  CHECK(fromText.meshes[0].positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(fromBinary.hash != fromText.hash);
}

TEST_CASE("bytes after the stated length and unknown chunks are ignored") {
  const GltfFile file = triangleFile();
  CHECK(loadText(file.glb() + "trailing").scene.primitives.size() == 1);
  const std::string text = R"({"asset":{"version":"2.0"}} )";
  CHECK(errorsOf(glbOf({{0x4e4f534a, text}, {0x12345678, "what"}})).empty());
}

TEST_CASE("glTF is recognised by its content, under any name") {
  const TemporaryFolder folder;
  const auto loadAs = [&](const std::string& name, const std::string& bytes) {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return formats::loadScene(folder / name).scene.primitives.size();
  };
  CHECK(loadAs("scene.p3f", triangleFile().glb()) == 1);
  CHECK(loadAs("scene", "\xef\xbb\xbf \n" + triangleFile().text()) == 1);
  CHECK_THROWS_WITH(loadAs("empty.gltf", ""), Catch::Contains("the file is empty"));
}

TEST_CASE("errors of JSON have a line and a column") {
  CHECK(errorsOf("{\"asset\":\n  {\"version\" \"2.0\"}}").find("test.gltf:2:18: not valid JSON: syntax error") == 0);
  CHECK(errorsOf("{\"a\": \"\xff\"}").find("test.gltf:1:8: not valid JSON") == 0);
  CHECK(errorsOf(std::string(300, '[')).find("test.gltf:1:257: JSON is nested more than 256 levels deep") == 0);
}

TEST_CASE("a scene's hash covers its buffers and the options") {
  const TemporaryFolder folder;
  GltfFile file = triangleFile();
  file.root["buffers"] = {{{"byteLength", file.binary.size()}, {"uri", "data.bin"}}};
  const auto hashWith = [&](const std::string& binary, const scene::LoadOptions& options) {
    std::ofstream(folder / "data.bin", std::ios::binary) << binary;
    return loadText(file.text(), options, folder.path()).scene.hash;
  };
  const std::uint64_t hash = hashWith(file.binary, {});
  CHECK(hashWith(file.binary, {}) == hash);
  CHECK(hashWith(std::string(file.binary.size(), '\0'), {}) != hash);
  CHECK(hashWith(file.binary, {.time = 1}) != hash);
  CHECK(hashWith(file.binary, {.camera = "none"}) != hash);
}

}  // namespace candela::gltf
