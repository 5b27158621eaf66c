// Extensions that are required, used, known and unknown.
#include "tests/formats/gltf/gltf_file.h"

namespace candela::gltf {
namespace {

std::string fact(const scene::LoadedScene& loaded, const std::string& label) {
  for (const auto& [name, value] : loaded.facts) {
    if (name == label) return value;
  }
  return "";
}

}  // namespace

TEST_CASE("an unknown required extension is an error with its name, an unknown optional one a warning") {
  GltfFile file = triangleFile();
  file.root["extensionsUsed"] = {"ACME_cloth", "KHR_materials_dispersion", "KHR_materials_variants"};
  const scene::LoadedScene loaded = load(file);
  CHECK(warns(loaded, "ACME_cloth"));
  CHECK(fact(loaded, "extensions") == "ACME_cloth, KHR_materials_dispersion, KHR_materials_variants");
  CHECK(fact(loaded, "partly") == "KHR_materials_variants");
  CHECK(fact(loaded, "unsupported") == "ACME_cloth");
  file.root["extensionsRequired"] = {"KHR_materials_dispersion", "ACME_cloth"};
  CHECK(errorsOf(file.text()) ==
        "test.gltf: /extensionsRequired/1: the file requires the extension \"ACME_cloth\"; it is not supported, and "
        "lenient reads the file without it");
}

TEST_CASE("an extension is named by one warning, and metadata by none") {
  GltfFile file = triangleFile();
  file.root["extensionsUsed"] = {"ACME_cloth", "KHR_xmp_json_ld"};
  file.root["materials"] = {{{"extensions", {{"ACME_cloth", json::object()}}}}};
  file.primitive()["material"] = 0;
  const scene::LoadedScene loaded = load(file);
  CHECK(warns(loaded, "extensions that are not supported are ignored: ACME_cloth"));
  CHECK_FALSE(warns(loaded, "not rendered yet"));
  CHECK_FALSE(warns(loaded, "KHR_xmp"));
}

TEST_CASE("lenient reading ignores required extensions, except those that compress the geometry") {
  GltfFile file = triangleFile();
  file.root["extensionsRequired"] = {"ACME_cloth"};
  CHECK(warns(load(file, {.lenient = true}), "/extensionsRequired/0: the file requires the extension \"ACME_cloth\""));
  file.root["extensionsRequired"] = {"ACME_mesh_compression"};
  CHECK(errorsOf(file.text(), {.lenient = true}) ==
        "test.gltf: /extensionsRequired/0: the file requires the extension \"ACME_mesh_compression\"; it is not "
        "supported");
}

TEST_CASE("only glTF 2 is read") {
  GltfFile file = triangleFile();
  file.root["asset"]["version"] = "1.0";
  CHECK(errorsOf(file.text()) == "test.gltf: /asset/version: glTF \"1.0\"; only version 2 is read");
  file.root["asset"]["version"] = "2.1";
  CHECK(errorsOf(file.text()).empty());
  file.root["asset"]["minVersion"] = "2.1";
  CHECK(errorsOf(file.text()).find("/asset/minVersion: the file needs glTF \"2.1\"") != std::string::npos);
}

}  // namespace candela::gltf
