// Builds a scene from nodes.
#include "host/formats/gltf/scene_assembly.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/formats/gltf/extensions.h"
#include "host/formats/gltf/geometry.h"
#include "host/formats/gltf/material_mapping.h"
#include "host/formats/gltf/nodes.h"
#include "host/formats/gltf/transform.h"
#include "host/formats/gltf/value.h"
#include "host/formats/loading/diagnostic_log.h"
#include "host/formats/loading/mikk_tangents.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/loading/shrink_images.h"
#include "host/scene/bounds.h"
#include "host/scene/scene.h"
#include "host/scene/texture.h"

namespace candela::gltf {
namespace {

using scene::PunctualLight;

constexpr double kAngleTolerance = 1e-6;  // radians
constexpr double kMinAngle = 1e-6;        // of the outer cone, in radians; single precision renders no narrower one

PunctualLight::Kind kindOf(const Value& type) {
  if (type.text() == "point") return PunctualLight::Kind::point;
  if (type.text() == "spot") return PunctualLight::Kind::spot;
  if (type.text() != "directional") type.fail(scene::quote(type.text()) + " is not point, spot or directional");
  return PunctualLight::Kind::directional;
}

/// Returns 1 - cos of an angle, without cancellation.
float versine(double angle) {
  const double sine = std::sin(angle / 2);
  return static_cast<float>(2 * sine * sine);
}

/// Files store pi/2 in single precision, which exceeds pi/2, and equal angles for a cone with a hard edge.
void readCone(const Value& light, PunctualLight& result, scene::DiagnosticLog& log) {
  constexpr double kMax = std::numbers::pi / 2;
  const Value spot = light.require("spot");
  const double inner = spot.numberOr("innerConeAngle", 0);
  const double outer = spot.numberOr("outerConeAngle", std::numbers::pi / 4);
  if (!(inner >= 0 && outer >= kMinAngle && outer <= kMax + kAngleTolerance)) {
    spot.fail("the angles of the cones are not inner >= 0 and 1e-6 <= outer <= pi/2");
  }
  if (inner >= outer) {
    log.warn("cone", {}, spot.pointer() + ": the inner cone is not inside the outer one, so that its edge is hard");
  }
  result.versineInner = versine(std::min(inner, outer));
  result.versineOuter = versine(std::min(outer, kMax));
  if (result.versineInner >= result.versineOuter) result.versineInner = std::nextafter(result.versineOuter, 0.0f);
}

/// A light of the extension at a node. Candela and lux are taken as W/sr and W/m^2, without the factor 683; `range` is
/// ignored. Warns of cones with a hard edge. Throws JsonError.
PunctualLight punctualLight(const Value& light, const glm::dmat4& world, scene::DiagnosticLog& log) {
  PunctualLight result;
  result.kind = kindOf(light.require("type"));
  const auto colour = light.vectorOr("color", glm::dvec3(1));
  const double intensity = light.numberOr("intensity", 1);
  if (glm::any(glm::lessThan(colour, glm::dvec3(0))) || intensity < 0) light.fail("a colour or intensity is negative");
  result.intensity = glm::vec3(intensity * colour);
  result.position = glm::vec3(glm::dvec3(world[3]));
  const glm::dvec3 axis(world[2]);
  const double length = glm::length(axis);
  if (length > 0 && std::isfinite(length)) result.direction = glm::vec3(-axis / length);
  if (result.kind == PunctualLight::Kind::spot) readCone(light, result, log);
  return result;
}

/// For each joint, from the coordinates of the mesh at rest to those of the scene: its node's world transform times its
/// inverse bind matrix. Throws JsonError.
std::vector<glm::dmat4> jointMatrices(const Value& skin, const NodeTree& nodes, std::size_t nodeCount,
                                      Accessors& accessors) {
  const Value joints = skin.require("joints");
  const std::optional<Value> bind = skin.find("inverseBindMatrices");
  const std::vector<glm::mat4> inverses = bind ? accessors.read<glm::mat4>(*bind) : std::vector<glm::mat4>{};
  if (bind && inverses.size() < joints.size()) {
    bind->fail(fmt::format("{} matrices for {} joints", inverses.size(), joints.size()));
  }
  std::vector<glm::dmat4> matrices;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const glm::dmat4& world = nodes.world(joints[i].indexInto("nodes", nodeCount));
    matrices.push_back(bind ? world * glm::dmat4(inverses[i]) : world);
  }
  return matrices;
}

template <class Element>
void repeat(std::vector<Element>& attribute, std::size_t vertex) {
  if (attribute.empty()) return;
  const Element value = attribute[vertex];
  attribute.push_back(value);
}

/// Appends a copy of a vertex, apart from its tangent.
void repeatVertex(Geometry& geometry, std::size_t vertex) {
  scene::Mesh& mesh = geometry.mesh;
  repeat(mesh.positions, vertex);
  repeat(mesh.normals, vertex);
  repeat(mesh.colours, vertex);
  for (auto& set : mesh.texCoords) repeat(set, vertex);
  for (auto& set : geometry.influences.joints) repeat(set, vertex);
  for (auto& set : geometry.influences.weights) repeat(set, vertex);
}

/// Gives the mesh the tangents of scene::mikkTangents() for a texture. A vertex whose triangles have different tangents
/// becomes several vertices.
void addTangents(Geometry& geometry, const scene::TextureReference& texture) {
  scene::Mesh& mesh = geometry.mesh;
  const std::vector<glm::vec4> corners = scene::mikkTangents(mesh, texture);
  mesh.tangents.assign(mesh.positions.size(), glm::vec4(0));  // w is 0 until a triangle sets the tangent
  std::vector<std::uint32_t> nextCopy(mesh.positions.size(), 0);
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    std::uint32_t vertex = mesh.indices[i];
    while (mesh.tangents[vertex].w != 0 && mesh.tangents[vertex] != corners[i] && nextCopy[vertex] != 0) {
      vertex = nextCopy[vertex];
    }
    if (mesh.tangents[vertex].w != 0 && mesh.tangents[vertex] != corners[i]) {
      nextCopy[vertex] = static_cast<std::uint32_t>(mesh.positions.size());
      repeatVertex(geometry, vertex);
      vertex = nextCopy[vertex];
      nextCopy.push_back(0);
      mesh.tangents.emplace_back(0);
    }
    mesh.tangents[vertex] = corners[i];
    mesh.indices[i] = vertex;
  }
}

constexpr std::size_t kMaxTriangles = scene::PrimitiveList::kMaxSize;

std::uint64_t bytesOf(const scene::Mesh& mesh) {
  return sizeof(scene::Mesh) + mesh.positions.size() * sizeof(glm::vec3) + mesh.normals.size() * sizeof(glm::vec3) +
         (mesh.texCoords[0].size() + mesh.texCoords[1].size()) * sizeof(glm::vec2) +
         (mesh.tangents.size() + mesh.colours.size()) * sizeof(glm::vec4) + mesh.indices.size() * sizeof(std::uint32_t);
}

// Throws JsonError if a vertex could be placed beyond the range of binary32. `reach`: largest magnitudes of
// coordinates.
void requireFinite(const glm::dvec3& reach, const scene::Placement& placement, const Value& source) {
  for (const glm::vec4& row : placement.points) {
    if (glm::dot(glm::abs(glm::dvec4(row)), glm::dvec4(reach, 1)) < double{std::numeric_limits<float>::max()}) continue;
    source.fail("a vertex is placed beyond the range of single precision");
  }
}

float minAlphaOf(const scene::TextureImage& image) {
  std::uint32_t minAlpha = 255;
  std::uint64_t minDeepAlpha = 65535;
  for (const std::uint32_t texel : image.texels) minAlpha = std::min(minAlpha, texel >> 24);
  for (const std::uint64_t texel : image.deepTexels) minDeepAlpha = std::min(minDeepAlpha, texel >> 48);
  return std::min(static_cast<float>(minAlpha) / 255, static_cast<float>(minDeepAlpha) / 65535);
}

// A name that is not a string is ignored: other readers report it.
std::string nameOf(const Value& value, const std::string& absent) {
  const auto name = value.json().is_object() ? value.json().find("name") : value.json().end();
  if (name == value.json().end() || !name->is_string() || name->get_ref<const std::string&>().empty()) return absent;
  return name->get<std::string>();
}

template <class Vector>
Vector elementOr(const std::vector<Vector>& values, std::size_t i, const Vector& absent) {
  return values.empty() ? absent : values[i];
}

/// The number that all attributes of EXT_mesh_gpu_instancing have, those of applications ("_ID") included.
std::size_t instanceCount(const Value& attributes, Accessors& accessors) {
  if (!attributes.json().is_object()) attributes.fail("expected an object");
  std::optional<std::size_t> count;
  for (const auto& [name, reference] : attributes.json().items()) {
    const std::size_t own = accessors.count(attributes.require(name));
    if (count && own != *count) attributes.fail(fmt::format("attributes of {} and {} instances", *count, own));
    count = own;
  }
  return count.value_or(0);
}

}  // namespace

SceneAssembly::SceneAssembly(const Value& root, const NodeTree& nodes, const Pose& pose, Accessors& accessors,
                             Buffers& buffers, bool lenient, DecodedImages* decoded, scene::DiagnosticLog& log)
    : root_(root),
      nodes_(nodes),
      pose_(pose),
      accessors_(accessors),
      buffers_(buffers),
      log_(log),
      textures_(root, buffers, lenient, decoded, log) {}

template <class Action>
void SceneAssembly::attempt(const Action& action) {
  if (log_.isFull()) return;
  try {
    action();
  } catch (const JsonError& error) {
    log_.error({}, error.what());
  }
}

void SceneAssembly::addMaterials() {
  const std::optional<Value> list = root_.find("materials");
  for (std::size_t i = 0; list && i < list->size(); ++i) {
    scene_.materials.emplace_back();
    scene_.materialNames.push_back(nameOf((*list)[i], fmt::format("material.{}", i)));
    attempt([&] {
      const GltfMaterial material = readMaterial((*list)[i], [&](const Value& info) { return textures_.read(info); });
      scene_.materials.back() = fromGltf(material);
      unread_.insert(material.unread.begin(), material.unread.end());
      hasOcclusion_ = hasOcclusion_ || material.hasOcclusion;
    });
  }
  scene_.images = textures_.takeImages();
  const std::vector<std::string> shrunk = scene::shrinkImages(scene_.images);
  if (!shrunk.empty()) log_.warn("images", {}, fmt::format("{}", fmt::join(shrunk, "; ")));
  counts_["material"] = scene_.materials.size();
  counts_["image"] = scene_.images.size();
}

void SceneAssembly::addNodes() {
  countUses();
  for (const std::size_t index : nodes_.visible()) {
    attempt([&] { addNode(index); });
  }
}

void SceneAssembly::addNode(std::size_t index) {
  const Value node = root_.require("nodes")[index];
  ++counts_["node"];
  if (node.find("camera")) ++counts_["camera"];
  const std::size_t first = scene_.primitives.size();
  if (nodes_.isHidden(index)) return;
  if (node.find("mesh")) addMesh(node, index);
  addObject(node, index, first);
  if (extensionOf(node, "KHR_lights_punctual")) addLight(node, index);
}

Value SceneAssembly::meshOf(const Value& node) const {
  return root_.require("meshes")[node.require("mesh").indexInto("meshes", root_.sizeOf("meshes"))];
}

void SceneAssembly::addObject(const Value& node, std::size_t index, std::size_t first) {
  if (scene_.primitives.size() == first) return;
  const std::string meshName = nameOf(meshOf(node), fmt::format("node.{}", index));
  scene_.objectStarts.push_back(static_cast<std::uint32_t>(first));
  scene_.objectNames.push_back(nameOf(node, meshName));
}

void SceneAssembly::addMesh(const Value& node, std::size_t index) {
  const Value mesh = meshOf(node);
  const Value primitives = mesh.require("primitives");
  ++counts_["mesh"];
  for (std::size_t i = 0; i < primitives.size(); ++i) {
    attempt([&] { addPrimitive(node, index, mesh, primitives[i]); });
  }
}

std::vector<double> SceneAssembly::morphWeights(const Value& node, std::size_t index, const Value& mesh) const {
  const auto posed = pose_.find(index);
  if (posed != pose_.end() && !posed->second.weights.empty()) return posed->second.weights;
  const std::optional<Value> own = node.find("weights");
  const std::optional<Value> list = own ? own : mesh.find("weights");
  std::vector<double> weights;
  for (std::size_t i = 0; list && i < list->size(); ++i) weights.push_back((*list)[i].number());
  return weights;
}

std::uint32_t SceneAssembly::materialOf(const Value& primitive) {
  if (const std::optional<Value> material = primitive.find("material")) {
    return static_cast<std::uint32_t>(material->indexInto("materials", root_.sizeOf("materials")));
  }
  if (defaultMaterial_ == 0) {
    defaultMaterial_ = scene_.materials.size() + 1;
    scene_.materials.push_back(fromGltf({}));
    scene_.materialNames.emplace_back("default");
  }
  return static_cast<std::uint32_t>(defaultMaterial_ - 1);
}

std::optional<scene::Mesh> SceneAssembly::readMesh(const Value& primitive, std::span<const double> weights,
                                                   std::uint32_t material, Influences* influences) {
  std::optional<Geometry> geometry = readGeometry(primitive, {weights, influences != nullptr, byteCount_}, accessors_,
                                                  buffers_);
  if (!geometry) {
    log_.warn("positions", {}, primitive.pointer() + ": a primitive without positions is not rendered");
    return std::nullopt;
  }
  for (const std::string& pointer : geometry->surplusTargets) {
    log_.warn("targets", {}, pointer + " is left out: the primitive has no such attribute that the target could move");
  }
  const auto& tangentTexture = tangentTextureOf(scene_.materials[material]);
  if (tangentTexture && geometry->mesh.tangents.empty()) addTangents(*geometry, *tangentTexture);
  if (influences) *influences = std::move(geometry->influences);
  return std::move(geometry->mesh);
}

void SceneAssembly::addPrimitive(const Value& node, std::size_t index, const Value& mesh, const Value& primitive) {
  if (topologyOf(primitive) == Topology::pointsOrLines) {
    log_.warn("points", {}, primitive.pointer() + ": points and lines are not rendered");
    return;
  }
  const std::optional<Value> skin = node.find("skin");
  const std::vector<double> weights = morphWeights(node, index, mesh);
  if (!skin) {
    SharedMesh& shared = shared_[keyOf(primitive, weights)];
    if (shared.uses > 1) {
      addInstances(node, index, primitive, weights, shared);
      return;
    }
  }
  const std::uint32_t material = materialOf(primitive);
  Influences influences;
  std::optional<scene::Mesh> own = readMesh(primitive, weights, material, skin ? &influences : nullptr);
  if (!own) return;
  ++counts_["primitive"];
  noteAlpha(minAlphaOf(*own), material);
  if (skin && !influences.joints.empty()) {
    const Value joints = root_.require("skins")[skin->indexInto("skins", root_.sizeOf("skins"))];
    placeSkinned(*own, influences, jointMatrices(joints, nodes_, root_.sizeOf("nodes"), accessors_), primitive);
    requireRoom(primitive, scene::triangleCount(*own), bytesOf(*own));
    scene::addMesh(scene_, std::move(*own), material);
    return;
  }
  const std::vector<glm::dmat4> instances = instancesOf(node);
  if (!instances.empty()) addPlaced(std::move(*own), nodes_.world(index) * instances.front(), material, node);
}

void SceneAssembly::addPlaced(scene::Mesh mesh, const glm::dmat4& map, std::uint32_t material, const Value& source) {
  requireRoom(source, scene::triangleCount(mesh), bytesOf(mesh));
  place(mesh, map, source);
  scene::addMesh(scene_, std::move(mesh), material);
}

void SceneAssembly::addInstances(const Value& node, std::size_t index, const Value& primitive,
                                 std::span<const double> weights, SharedMesh& shared) {
  const std::uint32_t material = materialOf(primitive);
  if (!std::exchange(shared.isRead, true)) {
    std::optional<scene::Mesh> mesh = readMesh(primitive, weights, material);
    if (mesh) {
      place(*mesh, glm::dmat4(1), primitive);
      shared.minAlpha = minAlphaOf(*mesh);
      shared.reach = reachOf(*mesh);
      shared.mesh = storeShared(primitive, std::move(*mesh));
    }
  }
  if (!shared.mesh) return;
  ++counts_["primitive"];
  noteAlpha(shared.minAlpha, material);
  for (const glm::dmat4& instance : instancesOf(node)) {
    const glm::dmat4 map = nodes_.world(index) * instance;
    const std::optional<scene::Placement> placement = scene::placementOf(map);
    if (!placement) {
      addPlaced(scene_.meshes[*shared.mesh], map, material, node);
      continue;
    }
    const bool isMirrored = scene::mirrors(map);
    if (isMirrored && !shared.mirrored) {
      shared.mirrored = storeShared(primitive, mirroredMesh(scene_.meshes[*shared.mesh]));
    }
    const std::uint32_t mesh = isMirrored ? *shared.mirrored : *shared.mesh;
    requireRoom(node, scene::triangleCount(scene_.meshes[mesh]),
                sizeof(scene::Placement) + sizeof(scene::PrimitiveRun));
    requireFinite(shared.reach, *placement, node);
    scene::addInstance(scene_, mesh, *placement, material);
  }
}

std::uint32_t SceneAssembly::storeShared(const Value& source, scene::Mesh mesh) {
  requireRoom(source, 0, bytesOf(mesh));
  return scene::storeMesh(scene_, std::move(mesh));
}

std::string SceneAssembly::keyOf(const Value& primitive, std::span<const double> weights) const {
  const std::optional<Value> material = primitive.find("material");
  std::optional<scene::TextureReference> tangentTexture;
  if (material) {
    tangentTexture = tangentTextureOf(scene_.materials[material->indexInto("materials", root_.sizeOf("materials"))]);
  }
  return geometryKey(primitive, weights, tangentTexture);
}

void SceneAssembly::countUses() {
  for (const std::size_t index : nodes_.visible()) {
    try {
      const Value node = root_.require("nodes")[index];
      if (nodes_.isHidden(index) || node.find("skin") || !node.find("mesh")) continue;
      const std::optional<Value> extension = extensionOf(node, "EXT_mesh_gpu_instancing");
      const std::size_t uses = extension ? instanceCount(extension->require("attributes"), accessors_) : 1;
      const Value mesh = meshOf(node);
      const Value primitives = mesh.require("primitives");
      const std::vector<double> weights = morphWeights(node, index, mesh);
      for (std::size_t i = 0; i < primitives.size(); ++i) shared_[keyOf(primitives[i], weights)].uses += uses;
    } catch (const JsonError&) {  // addNode() reports it
      continue;
    }
  }
}

void SceneAssembly::noteAlpha(float minAlpha, std::uint32_t material) {
  const auto [known, isNew] = minAlpha_.emplace(material, minAlpha);
  known->second = std::min(known->second, minAlpha);
}

void SceneAssembly::dropUselessOpacity() {
  for (std::size_t i = 0; i < scene_.materials.size(); ++i) {
    std::optional<scene::Opacity>& opacity = scene_.materials[i].opacity;
    if (!opacity) continue;
    const auto vertices = minAlpha_.find(static_cast<std::uint32_t>(i));
    float minAlpha = opacity->factor * (vertices == minAlpha_.end() ? 1 : vertices->second);
    if (opacity->texture) minAlpha *= minAlphaOf(scene_.images[opacity->texture->image]);
    if (minAlpha >= opacity->cutoff.value_or(1)) opacity.reset();
  }
}

void SceneAssembly::requireRoom(const Value& source, std::uint64_t triangles, std::uint64_t bytes) {
  if (triangles > kMaxTriangles - triangleCount_) {
    source.fail(fmt::format("the scene has more than {} triangles", kMaxTriangles));
  }
  if (bytes > memoryBudget() - byteCount_) {
    throw OutOfMemoryError(fmt::format("{}: the scene needs more than the {} MiB of memory that it may have",
                                       source.pointer(), memoryBudget() >> 20));
  }
  triangleCount_ += triangles;
  byteCount_ += bytes;
}

std::vector<glm::dmat4> SceneAssembly::instancesOf(const Value& node) {
  const std::optional<Value> extension = extensionOf(node, "EXT_mesh_gpu_instancing");
  if (!extension) return {glm::dmat4(1)};
  const Value attributes = extension->require("attributes");
  std::vector<glm::vec3> translations;
  std::vector<glm::vec4> rotations;
  std::vector<glm::vec3> scales;
  if (const auto reference = attributes.find("TRANSLATION")) translations = accessors_.read<glm::vec3>(*reference);
  if (const auto reference = attributes.find("ROTATION")) rotations = accessors_.read<glm::vec4>(*reference);
  if (const auto reference = attributes.find("SCALE")) scales = accessors_.read<glm::vec3>(*reference);
  const std::size_t count = instanceCount(attributes, accessors_);
  requireMemory(fmt::format("{}: with these instances, the scene", attributes.pointer()),
                byteCount_ + count * sizeof(glm::dmat4), "use a machine with more memory");
  std::vector<glm::dmat4> instances;
  for (std::size_t i = 0; i < count; ++i) {
    const glm::dvec4 q(elementOr(rotations, i, glm::vec4(0, 0, 0, 1)));
    instances.push_back(compose(glm::dvec3(elementOr(translations, i, glm::vec3(0))), glm::dquat(q.w, q.x, q.y, q.z),
                                glm::dvec3(elementOr(scales, i, glm::vec3(1)))));
  }
  counts_["instance"] += count;
  return instances;
}

void SceneAssembly::addLight(const Value& node, std::size_t index) {
  const std::optional<Value> extension = extensionOf(root_, "KHR_lights_punctual");
  if (!extension) root_.fail("nodes have lights of KHR_lights_punctual, but the file does not");
  const Value reference = extensionOf(node, "KHR_lights_punctual")->require("light");
  const Value light = extension->require("lights")[reference.indexInto("lights", extension->sizeOf("lights"))];
  if (light.find("range"))
    log_.warn("range", {}, light.pointer() + "/range is ignored: light is not cut off at a distance");
  scene_.punctualLights.push_back(punctualLight(light, nodes_.world(index), log_));
  ++counts_["light"];
}

void SceneAssembly::reportOmissions() {
  const std::optional<Value> used = root_.find("extensionsUsed");
  for (std::size_t i = 0; used && i < used->size(); ++i) {  // checkAsset() has warned of these
    if (supportOf((*used)[i].text()) == Support::none) unread_.erase((*used)[i].text());
  }
  if (unread_.empty()) return;
  log_.warn("unread", {}, fmt::format("not rendered yet: {}", fmt::join(unread_, ", ")));
}

std::optional<scene::Bounds> SceneAssembly::bounds() const { return scene::boundsOf(scene_); }

}  // namespace candela::gltf
