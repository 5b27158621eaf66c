// Collects the objects of the file as JSON, and the data of meshes in one buffer.
#include "host/scene/generate/gltf_document.h"

#include <cmath>
#include <numbers>
#include <set>

#include "host/scene/generate/stored_png.h"

namespace candela::generate {
namespace {

using Json = GltfDocument::Json;

constexpr int kFloat = 5126, kUnsignedInt = 5125;

std::string base64(const std::vector<std::byte>& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t k) {
      return i + k < bytes.size() ? std::to_integer<std::uint32_t>(bytes[i + k]) : 0u;
    };
    const std::uint32_t word = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[word >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

Json list(const glm::dvec3& v) { return Json::array({v.x, v.y, v.z}); }

std::set<std::string> extensionsOf(const Json& materials) {
  std::set<std::string> names;
  for (const Json& material : materials) {
    if (!material.contains("extensions")) continue;
    for (const auto& extension : material["extensions"].items()) names.insert(extension.key());
  }
  return names;
}

}  // namespace

GltfDocument::GltfDocument() {
  root_["asset"] = {{"version", "2.0"}, {"generator", "candela generate"}};
  root_["scene"] = 0;
  root_["scenes"] = Json::array({{{"nodes", Json::array()}}});
}

std::size_t GltfDocument::addAccessor(const void* data, std::size_t bytes, const Json& accessor) {
  const auto* begin = static_cast<const std::byte*>(data);
  root_["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", bytes}});
  binary_.insert(binary_.end(), begin, begin + bytes);
  Json complete = {{"bufferView", root_["bufferViews"].size() - 1}};
  complete.update(accessor);
  root_["accessors"].push_back(complete);
  return root_["accessors"].size() - 1;
}

template <class Vector>
std::size_t GltfDocument::addFloats(const std::vector<Vector>& values, const char* type) {
  return addAccessor(values.data(), values.size() * sizeof(Vector),
                     {{"componentType", kFloat}, {"count", values.size()}, {"type", type}});
}

void GltfDocument::addToScene(Json node) {
  root_["nodes"].push_back(std::move(node));
  root_["scenes"][0]["nodes"].push_back(root_["nodes"].size() - 1);
}

std::size_t GltfDocument::addShape(const TriangleMesh& mesh) {
  glm::vec3 low(mesh.positions.front()), high(low);
  for (const glm::vec3& position : mesh.positions) {
    low = min(low, position);
    high = max(high, position);
  }
  Shape shape;
  shape.attributes["POSITION"] = addFloats(mesh.positions, "VEC3");
  root_["accessors"].back()["min"] = list(low);
  root_["accessors"].back()["max"] = list(high);
  shape.attributes["NORMAL"] = addFloats(mesh.normals, "VEC3");
  if (!mesh.texCoords.empty()) shape.attributes["TEXCOORD_0"] = addFloats(mesh.texCoords, "VEC2");
  if (!mesh.colours.empty()) shape.attributes["COLOR_0"] = addFloats(mesh.colours, "VEC3");
  shape.indices = addAccessor(mesh.indices.data(), mesh.indices.size() * sizeof(mesh.indices[0]),
                              {{"componentType", kUnsignedInt}, {"count", mesh.indices.size()}, {"type", "SCALAR"}});
  shapes_.push_back(shape);
  return shapes_.size() - 1;
}

std::size_t GltfDocument::addMaterial(const Json& material) {
  root_["materials"].push_back(material);
  return root_["materials"].size() - 1;
}

std::size_t GltfDocument::addTexture(std::uint32_t width, std::uint32_t height, const std::vector<std::byte>& rgb) {
  root_["images"].push_back({{"uri", "data:image/png;base64," + base64(storedPng(width, height, rgb))}});
  root_["textures"].push_back({{"source", root_["images"].size() - 1}});
  return root_["textures"].size() - 1;
}

std::size_t GltfDocument::addMesh(std::span<const MeshPart> parts) {
  Json primitives = Json::array();
  for (const MeshPart& part : parts) {
    const Shape& shape = shapes_[part.shape];
    primitives.push_back({{"attributes", shape.attributes}, {"indices", shape.indices}, {"material", part.material}});
  }
  root_["meshes"].push_back({{"primitives", std::move(primitives)}});
  return root_["meshes"].size() - 1;
}

void GltfDocument::addNode(std::size_t shape, std::size_t material, const glm::dvec3& translation) {
  const MeshPart part{shape, material};
  addToScene({{"mesh", addMesh({&part, 1})}, {"translation", list(translation)}});
}

void GltfDocument::addInstances(std::size_t mesh, std::span<const MeshInstance> places) {
  if (places.empty()) return;
  std::vector<glm::vec3> translations, scales;
  std::vector<glm::vec4> rotations;  // quaternions about the y axis
  for (const MeshInstance& place : places) {
    translations.emplace_back(place.translation);
    rotations.emplace_back(0, std::sin(place.turn / 2), 0, std::cos(place.turn / 2));
    scales.emplace_back(place.scale);
  }
  const Json attributes = {{"TRANSLATION", addFloats(translations, "VEC3")},
                           {"ROTATION", addFloats(rotations, "VEC4")},
                           {"SCALE", addFloats(scales, "VEC3")}};
  addToScene({{"mesh", mesh}, {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
  hasInstances_ = true;
}

void GltfDocument::addCamera(const glm::dvec3& from, const glm::dvec3& at, double angle, double aspect) {
  root_["cameras"].push_back(
      {{"type", "perspective"},
       {"perspective", {{"yfov", angle * std::numbers::pi / 180}, {"aspectRatio", aspect}, {"znear", 0.01}}}});
  const glm::dvec3 back = normalize(from - at);
  const glm::dvec3 right = normalize(cross(glm::dvec3(0, 1, 0), back));
  const glm::dvec3 up = cross(back, right);
  addToScene({{"camera", root_["cameras"].size() - 1},
              {"matrix", Json::array({right.x, right.y, right.z, 0, up.x, up.y, up.z, 0, back.x, back.y, back.z, 0,
                                      from.x, from.y, from.z, 1})}});
}

std::string GltfDocument::text() const {
  Json root = root_;
  std::set<std::string> extensions = extensionsOf(root_.at("materials"));
  if (hasInstances_) extensions.insert("EXT_mesh_gpu_instancing");
  if (!extensions.empty()) root["extensionsUsed"] = extensions;
  root["buffers"] = Json::array(
      {{{"byteLength", binary_.size()}, {"uri", "data:application/octet-stream;base64," + base64(binary_)}}});
  return root.dump(1) + "\n";
}

}  // namespace candela::generate
