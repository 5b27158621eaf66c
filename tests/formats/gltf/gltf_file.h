// glTF files made in code, and ways to read them.
#pragma once
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/gltf/gltf_loader.h"

namespace candela::gltf {

using nlohmann::json;

inline constexpr int kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123, kUnsignedInt = 5125,
                     kFloat = 5126;

/// A file under construction: `root` is its JSON, `binary` the bytes of buffer 0.
struct GltfFile {
  json root{{"asset", {{"version", "2.0"}}}};
  std::string binary;

  /// Appends bytes as a buffer view, and returns its index.
  template <class Element>
  std::size_t view(const std::vector<Element>& elements) {
    const std::size_t offset = binary.size();
    binary.append(reinterpret_cast<const char*>(elements.data()), elements.size() * sizeof(Element));
    root["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", elements.size() * sizeof(Element)}});
    return root["bufferViews"].size() - 1;
  }
  /// Appends an accessor over a new view.
  template <class Element>
  std::size_t accessor(const std::vector<Element>& elements, int componentType, const char* type, std::size_t count) {
    const std::size_t index = view(elements);
    root["accessors"].push_back(
        {{"bufferView", index}, {"componentType", componentType}, {"count", count}, {"type", type}});
    return root["accessors"].size() - 1;
  }
  std::size_t positions(const std::vector<float>& xyz) { return accessor(xyz, kFloat, "VEC3", xyz.size() / 3); }
  std::size_t vectors(const std::vector<float>& numbers, const char* type, std::size_t components) {
    return accessor(numbers, kFloat, type, numbers.size() / components);
  }
  /// Appends a node with a mesh of one primitive, and puts it into the scene. Returns the node.
  json& addMesh(const json& primitive) {
    root["meshes"].push_back({{"primitives", json::array({primitive})}});
    return addNode({{"mesh", root["meshes"].size() - 1}});
  }
  json& addNode(const json& node) {
    root["nodes"].push_back(node);
    root["scenes"][0]["nodes"].push_back(root["nodes"].size() - 1);
    return root["nodes"].back();
  }
  /// The first primitive.
  json& primitive() { return root["meshes"][0]["primitives"][0]; }

  /// Returns JSON with a data URI.
  std::string text() const;
  /// Returns a GLB file.
  std::string glb() const;
};

/// One triangle (0 0 0) (1 0 0) (0 1 0) at a node.
GltfFile triangleFile();

/// A GLB container of these chunks (type, content).
std::string glbOf(const std::vector<std::pair<std::uint32_t, std::string>>& chunks);

inline scene::LoadedScene loadText(const std::string& bytes, const scene::LoadOptions& options = {},
                                   const std::filesystem::path& folder = ".") {
  return gltfLoader().open({bytes, "test.gltf", folder}, options, false)->at(options.time);
}
inline scene::LoadedScene load(const GltfFile& file, const scene::LoadOptions& options = {}) {
  return loadText(file.text(), options);
}
inline scene::Scene sceneOf(const GltfFile& file, const scene::LoadOptions& options = {}) {
  return load(file, options).scene;
}

/// The errors of a file, one line each; empty if it is read.
std::string errorsOf(const std::string& bytes, const scene::LoadOptions& options = {});

/// Returns whether some warning contains `part`.
bool warns(const scene::LoadedScene& loaded, std::string_view part);

}  // namespace candela::gltf
