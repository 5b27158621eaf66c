// Names of objects and materials.
#include "host/scene/object_names.h"
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

std::vector<std::string> objectsOf(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.objectStarts.size(); ++i) names.push_back(scene::objectName(scene, i));
  return names;
}

}  // namespace

TEST_CASE("an object has the name of its node, else of its mesh, else the index of the node") {
  GltfFile file = triangleFile();
  file.root["nodes"].push_back({{"mesh", 0}, {"name", "second"}});
  file.root["nodes"].push_back({{"name", "empty"}});
  file.root["scenes"][0]["nodes"] = {2, 0, 1};
  CHECK(objectsOf(sceneOf(file)) == std::vector<std::string>{"node.0", "second"});
  file.root["meshes"][0]["name"] = "mesh";
  const scene::Scene scene = sceneOf(file);
  CHECK(objectsOf(scene) == std::vector<std::string>{"mesh", "second"});
  CHECK(scene.objectStarts == std::vector<std::uint32_t>{0, 1});
  const scene::MatteIds ids(scene);
  CHECK(ids.of(image::MatteKind::object, 0) == image::matteId("mesh"));
  CHECK(ids.of(image::MatteKind::object, 1) == image::matteId("second"));
}

TEST_CASE("a material without a name has its index, and faces without a material have the default") {
  GltfFile file = triangleFile();
  CHECK(scene::materialName(sceneOf(file), 0) == "default");
  file.root["materials"] = {{{"name", "red"}}, json::object()};
  file.root["meshes"][0]["primitives"].push_back(file.primitive());
  file.root["meshes"][0]["primitives"][1]["material"] = 1;
  const scene::Scene scene = sceneOf(file);
  CHECK(scene.materialNames == std::vector<std::string>{"red", "material.1", "default"});
  CHECK(scene::MatteIds(scene).of(image::MatteKind::material, 1) == image::matteId("material.1"));
}

}  // namespace candela::gltf
