// Converts shapes.
#include "host/formats/mitsuba/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "host/base/errors.h"
#include "host/base/hash.h"
#include "host/base/memory_budget.h"
#include "host/base/quote.h"
#include "host/formats/loading/mikk_tangents.h"
#include "host/formats/loading/read_file.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/mitsuba/built_in_meshes.h"
#include "host/formats/mitsuba/emitters.h"
#include "host/formats/mitsuba/names.h"
#include "host/formats/mitsuba/place_mesh.h"
#include "host/formats/mitsuba/serialized_mesh.h"
#include "host/formats/mitsuba/transform.h"
#include "host/image/film.h"
#include "host/scene/placement.h"

namespace candela::mitsuba {
namespace {

using scene::quote;

constexpr std::uint64_t kMaxShapes = 16'000'000;  // that are shown, instances counted one by one
constexpr std::size_t kMaxIdLength = 1024;

constexpr std::array<std::string_view, 8> kOtherShapes{"bsplinecurve",   "linearcurve", "sdfgrid",     "ellipsoids",
                                                       "ellipsoidsmesh", "hair",        "heightfield", "deformable"};
constexpr std::array<std::string_view, 11> kRenderedShapes{
    "obj", "serialized", "ply", "sphere", "rectangle", "cube", "cylinder", "disk", "shapegroup", "instance", "merge"};

std::string nameOf(const MeshAttribute& attribute) {
  return (attribute.isOfFaces ? "face_" : "vertex_") + attribute.name;
}

std::uint64_t bytesOf(const scene::Mesh& mesh) {
  return sizeof(scene::Mesh) + (mesh.positions.size() + mesh.normals.size()) * sizeof(glm::vec3) +
         mesh.texCoords[0].size() * sizeof(glm::vec2) +
         (mesh.tangents.size() + mesh.colours.size()) * sizeof(glm::vec4) + mesh.indices.size() * sizeof(std::uint32_t);
}

}  // namespace

void Shapes::add(const Object& shape) {
  if (shape.type == "shapegroup") return;
  if (shape.type == "merge") {
    for (const Object* const child : shape.nested("shape")) addLeaf(*child, glm::dmat4(1), false);
    shape.reportUnused(report_);
    return;
  }
  if (shape.type != "instance") {
    addLeaf(shape, glm::dmat4(1), false);
    return;
  }
  const Object* const group = shape.onlyNested("shape");
  if (!group || group->type != "shapegroup")
    throw PlacedError{shape.place, "an instance refers to a shape \"shapegroup\""};
  const glm::dmat4 map = shape.transform("to_world");
  for (const Object* const child : group->nested("shape")) addLeaf(*child, map, true);
  group->reportUnused(report_);
  shape.reportUnused(report_);
}

void Shapes::addLeaf(const Object& shape, const glm::dmat4& map, bool isInstance) {
  if (++shapeCount_ > kMaxShapes)
    throw PlacedError{shape.place, fmt::format("the scene shows more than {} shapes", kMaxShapes)};
  if (std::ranges::count(kOtherShapes, shape.type) > 0) {
    report_.deviate(shape.place, fmt::format("{} is not rendered", shape.description()), "leaves it out");
    return;
  }
  if (std::ranges::count(kRenderedShapes, shape.type) == 0) {
    throw PlacedError{shape.place,
                      fmt::format("unknown shape {}{}", quote(shape.type), suggestionFor(shape.type, kRenderedShapes))};
  }
  if (shape.type == "shapegroup" || shape.type == "instance" || shape.type == "merge") {
    throw PlacedError{shape.place, fmt::format("a group does not contain {}", shape.description())};
  }
  const Look look = lookOf(shape, isInstance);
  const glm::dmat4 whole = map * ownMap(shape);
  if (!look.isInvisible) beginObject(shape);
  const bool isRound = !look.isInvisible && addRound(shape, whole, look);
  if (!isRound) {
    StoredMesh* const stored = meshOf(shape, look);
    if (stored && !look.isInvisible) {
      if (isInstance) {
        addInstance(*stored, whole, shape, look);
      } else {
        addPlaced(stored->mesh, whole, shape, look);
      }
    }
  }
  shape.ignore({"silhouette_sampling_weight", "optimize_mesh_memory"}, report_);
  shape.reportUnused(report_);
}

void Shapes::beginObject(const Object& shape) {
  const auto first = static_cast<std::uint32_t>(scene_.primitives.size());
  const std::string name = shape.id.empty() ? fmt::format("{}.{}", shape.type, shapeCount_ - 1)
                                            : shape.id.substr(0, kMaxIdLength);
  if (!scene_.objectStarts.empty() && scene_.objectStarts.back() == first) {  // the last shape was left out
    scene_.objectNames.back() = name;
    return;
  }
  scene_.objectStarts.push_back(first);
  scene_.objectNames.push_back(name);
}

Shapes::Look Shapes::lookOf(const Object& shape, bool isInstance) {
  const Object* const bsdf = shape.onlyNested("bsdf");
  const Object* const emitter = shape.onlyNested("emitter");
  if (emitter && isInstance) throw PlacedError{emitter->place, "an instance does not emit light"};
  for (const Object* const medium : shape.nested("medium")) {
    report_.deviate(medium->place, "participating media are not rendered", "leaves them out");
  }
  for (const char* const unused : {"sensor", "texture"}) {
    for (const Object* const child : shape.nested(unused)) {
      child->useAll();
      report_.ignore(fmt::format("{} of {}", child->description(), shape.description()));
    }
  }
  const auto known = materials_.find({bsdf, emitter});
  if (known != materials_.end()) return known->second;
  Look look;
  look.material = addMaterial(bsdf, emitter, shape, look);
  return materials_[{bsdf, emitter}] = look;
}

std::uint32_t Shapes::addMaterial(const Object* bsdf, const Object* emitter, const Object& shape, Look& look) {
  Bsdf surface;
  if (bsdf) {
    surface = bsdfs_.read(*bsdf);
  } else if (!emitter) {
    surface.material.diffuse = scene::DiffuseLobe{.colour = glm::vec3(0.5f)};
  }
  look.isInvisible = surface.isInvisible;
  Texture emission{glm::dvec3(0)};
  if (emitter) {
    if (surface.isInvisible) throw PlacedError{emitter->place, "a surface with the BSDF \"null\" does not emit light"};
    emission = areaEmission(*emitter, textures_, report_);
    look.emits = emission.factor != glm::dvec3(0);
  }
  forEachBsdf(surface, [&](const Bsdf& each) {
    if (each.attribute && look.attribute && each.attribute != look.attribute) {
      report_.deviate(bsdf->place, "a second attribute of the mesh is not rendered", "takes the first one");
    } else if (each.attribute) {
      look.attribute = each.attribute;
    }
  });
  const Object* const named = bsdf && !bsdf->id.empty() ? bsdf : &shape;
  const std::string name = named->id.empty() ? fmt::format("material.{}", materialCount_) : named->id;
  ++materialCount_;
  const std::uint32_t index = storeMaterial(surface, emission, name.substr(0, kMaxIdLength));
  const auto needsTriangles = [](const scene::Material& material) {
    return isTextured(material) || material.opacity || tangentTextureOf(material).has_value();
  };
  look.needsTriangles = anyMaterial(scene_, index, needsTriangles);
  look.transmits = anyMaterial(scene_, index, scene::transmits);
  return index;
}

/// Stores the material of a BSDF, and those between which it is a choice. The backs of one-sided BSDFs are black; those
/// of emitters are covered by other surfaces.
std::uint32_t Shapes::storeMaterial(const Bsdf& bsdf, const Texture& emission, const std::string& name) {
  const auto store = [&](scene::Material material) {
    material.emission = glm::vec3(emission.factor);
    material.textures[static_cast<std::size_t>(scene::TextureSlot::emission)] = emission.reference;
    scene_.materials.push_back(std::move(material));
    scene_.materialNames.push_back(name);
    return static_cast<std::uint32_t>(scene_.materials.size() - 1);
  };
  scene::Material material = bsdf.material;
  if (!bsdf.choices.empty()) {
    const std::uint32_t first = storeMaterial(bsdf.choices[0], emission, name + ".first");
    const std::uint32_t second = storeMaterial(bsdf.choices[1], emission, name + ".second");
    material.choice = scene::MaterialChoice{first, second, bsdf.weight};
    return store(std::move(material));
  }
  const bool isBlack = kindOf(material) == scene::MaterialKind::black;
  if (bsdf.isTwoSided || isBlack || emission.factor != glm::dvec3(0)) return store(std::move(material));
  scene::Material sides;
  sides.opacity = std::exchange(material.opacity, std::nullopt);
  sides.choice = scene::MaterialChoice{store(std::move(material)), blackMaterial()};
  return store(std::move(sides));
}

glm::dmat4 Shapes::ownMap(const Object& shape) const {
  glm::dmat4 map = shape.transform("to_world");
  if (shape.type == "sphere") {
    const glm::dvec3 centre = shape.vector("center", glm::dvec3(0));
    const double radius = shape.number("radius", 1);
    if (!(radius > 0)) throw PlacedError{shape.place, "the radius of a sphere is positive"};
    glm::dmat4 unit(radius);
    unit[3] = glm::dvec4(centre, 1);
    return map * unit;
  }
  if (shape.type != "cylinder") return map;
  const glm::dvec3 p0 = shape.vector("p0", glm::dvec3(0)), p1 = shape.vector("p1", glm::dvec3(0, 0, 1));
  const double radius = shape.number("radius", 1);
  if (p0 == p1 || !(radius > 0)) throw PlacedError{shape.place, "the radius and the length of a cylinder are positive"};
  const glm::dvec3 axis = glm::normalize(p1 - p0), side = perpendicularTo(axis);
  glm::dmat4 unit;
  unit[0] = glm::dvec4(radius * side, 0);
  unit[1] = glm::dvec4(radius * glm::cross(axis, side), 0);
  unit[2] = glm::dvec4(p1 - p0, 0);
  unit[3] = glm::dvec4(p0, 1);
  return map * unit;
}

/// Adds a sphere or a cylinder that its transform leaves one. Returns false for all other shapes.
bool Shapes::addRound(const Object& shape, const glm::dmat4& map, const Look& look) {
  const bool isSphere = shape.type == "sphere";
  if ((!isSphere && shape.type != "cylinder") || look.needsTriangles) return false;
  const bool isFlipped = shape.flag("flip_normals", false);
  if (isSphere) {
    if (!isSimilarity(map)) return false;
    addSphere(shape, map, isFlipped, look);
    return true;
  }
  glm::dmat4 equal = map;  // with an axis of the length of the radius
  const double length = glm::length(glm::dvec3(map[2]));
  equal[2] = glm::dvec4(glm::dvec3(map[2]) * (glm::length(glm::dvec3(map[0])) / length), 0);
  if (!(length > 0) || !isSimilarity(equal)) return false;
  addCylinder(shape, map, isFlipped, look);
  return true;
}

void Shapes::addSphere(const Object& shape, const glm::dmat4& map, bool isFlipped, const Look& look) {
  const auto radius = static_cast<float>(glm::length(glm::dvec3(map[0])));
  const glm::vec3 centre(placed(map, glm::dvec3(0)));
  if (!(radius > 0) || !(glm::length(glm::dvec3(centre)) < 1e30))
    throw PlacedError{shape.place, "the sphere is placed beyond the range of single precision"};
  if (isFlipped && look.transmits)
    throw PlacedError{shape.place, "a sphere whose material transmits light has no \"flip_normals\""};
  requireRoom(shape, 1, sizeof(scene::Sphere));
  scene::addSphere(scene_, {centre, isFlipped ? -radius : radius}, look.material);
}

void Shapes::addCylinder(const Object& shape, const glm::dmat4& map, bool isFlipped, const Look& look) {
  const auto radius = static_cast<float>(glm::length(glm::dvec3(map[0])));
  const glm::vec3 base(placed(map, glm::dvec3(0))), apex(placed(map, {0, 0, 1}));
  const double reach = std::max({glm::length(glm::dvec3(base)), glm::length(glm::dvec3(apex)), double{radius}});
  if (!(radius > 0) || base == apex || !(reach < 1e30))
    throw PlacedError{shape.place, "the cylinder is placed beyond the range of single precision"};
  requireRoom(shape, 2, 2 * sizeof(scene::Cone));
  scene::addCone(scene_, {base, radius, apex, radius}, look.material);
  if (!look.emits || look.transmits) return;
  const auto inner = static_cast<float>(radius + (isFlipped ? 1 : -1) * std::ldexp(reach, -16));
  if (inner > 0) scene::addCone(scene_, {base, inner, apex, inner}, blackMaterial());
}

std::uint32_t Shapes::blackMaterial() {
  if (!black_) {
    black_ = static_cast<std::uint32_t>(scene_.materials.size());
    scene::Material black;
    black.opaque = false;  // --one-sided shows both sides
    scene_.materials.push_back(black);
    scene_.materialNames.emplace_back("black back");
  }
  return *black_;
}

/// Returns the mesh of a shape with the attributes that its material needs; null if its file cannot be read.
Shapes::StoredMesh* Shapes::meshOf(const Object& shape, const Look& look) {
  const bool hasFaceNormals = shape.flag("face_normals", false);
  const bool isFile = shape.type == "obj" || shape.type == "ply" || shape.type == "serialized";
  const bool flipsTexCoords = isFile && shape.flag("flip_tex_coords", shape.type == "obj");
  const bool isFlipped = shape.flag("flip_normals", false);
  std::filesystem::path path;
  if (isFile) {
    if (!shape.has("filename"))
      throw PlacedError{shape.place, fmt::format("{} has no \"filename\"", shape.description())};
    path = findFile(shape.text("filename", ""), *shape.place.document, description_, file_.folder);
    shape.ignore({"vertex_merging"}, report_);
  }
  if (look.isInvisible) return nullptr;
  const auto& tangentTexture = tangentTextureOf(scene_, look.material);
  std::string key = fmt::format("{} {} {} {} ", shape.type, hasFaceNormals, flipsTexCoords, isFlipped);
  if (look.attribute)
    key += fmt::format("{} {} {} ", nameOf(*look.attribute), look.attribute->name.size(), look.attribute->isAlpha);
  if (tangentTexture) {
    const auto& [s, t] = std::pair(tangentTexture->rowS, tangentTexture->rowT);
    key += fmt::format("{} {} {} {} {} {} ", s.x, s.y, s.z, t.x, t.y, t.z);
  }
  if (shape.type == "serialized") key += fmt::format("{} ", shape.integer("shape_index", 0));
  key += path.string();
  const auto known = meshes_.find(key);
  if (known != meshes_.end()) return known->second ? &*known->second : nullptr;
  std::optional<StoredMesh>& stored = meshes_[key];
  scene::Mesh mesh;
  try {
    if (isFile) {
      mesh = readFile(shape, path, {hasFaceNormals, flipsTexCoords, look.attribute});
    } else {
      mesh = shape.type == "rectangle" ? rectangleMesh()
             : shape.type == "cube"    ? cubeMesh()
             : shape.type == "disk"    ? diskMesh()
             : shape.type == "sphere"  ? sphereMesh()
                                       : cylinderMesh();
      if (hasFaceNormals) mesh.normals.clear();
    }
  } catch (const scene::SceneError& error) {
    report_.add(error);
    return nullptr;
  } catch (const FileError& error) {
    report_.deviate(shape.place, error.what(), "leaves the shape out");
    return nullptr;
  }
  if (look.attribute && mesh.colours.empty()) {
    report_.deviate(shape.place,
                    fmt::format("{} has no attribute {} of one or three channels, to which its BSDF refers",
                                shape.description(), quote(nameOf(*look.attribute))),
                    "renders white instead");
  }
  if (isFlipped) flip(mesh);
  finish(mesh, look);
  byteCount_ += bytesOf(mesh);
  requireMemory(file_.name + ": the scene", byteCount_, "use a machine with more memory");
  const double reach = reachOf(mesh);
  stored = StoredMesh{std::move(mesh), reach};
  return &*stored;
}

scene::Mesh Shapes::readFile(const Object& shape, const std::filesystem::path& path, const MeshFileOptions& options) {
  guard_.require(path);
  const std::string bytes = scene::readFile(path);
  hashes_.push_back(fnv1aOfText(bytes));
  if (shape.type == "serialized") return readSerializedMesh(path, bytes, shape.integer("shape_index", 0), options);
  return shape.type == "obj" ? readObjMesh(path, bytes, options, shape.place, report_)
                             : readPlyMesh(path, bytes, options, shape.place, report_);
}

/// Leaves out the attributes that the material does not use, and adds tangents.
void Shapes::finish(scene::Mesh& mesh, const Look& look) const {
  if (!look.attribute) mesh.colours.clear();
  for (glm::vec4& colour : mesh.colours) {
    const bool isAlpha = look.attribute->isAlpha;
    colour = isAlpha ? glm::vec4(glm::vec3(1), static_cast<float>(image::luminance(glm::dvec3(colour))))
                     : glm::vec4(glm::vec3(colour), 1);
  }
  const auto& tangentTexture = tangentTextureOf(scene_, look.material);
  if (!tangentTexture || mesh.texCoords[0].empty()) return;
  scene::addMikkTangents(mesh, *tangentTexture);
  for (glm::vec4& tangent : mesh.tangents) tangent.w = 1;  // Mitsuba's second tangent is cross(normal, tangent)
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) mesh.indices.push_back(i);
}

void Shapes::addPlaced(scene::Mesh mesh, const glm::dmat4& map, const Object& shape, const Look& look) {
  requireRoom(shape, scene::triangleCount(mesh), bytesOf(mesh));
  if (!place(mesh, map)) throw PlacedError{shape.place, "a vertex is placed beyond the range of single precision"};
  if (look.emits && !look.transmits) addBacking(mesh, shape, look);
  scene::addMesh(scene_, std::move(mesh), look.material);
}

/// Mitsuba's emitters shine from their fronts alone. A black surface close behind one hides its back.
void Shapes::addBacking(const scene::Mesh& mesh, const Object& shape, const Look& look) {
  if (isClosed(mesh) && !scene_.materials[look.material].opacity) return;
  scene::Mesh backing = backingOf(mesh, std::ldexp(reachOf(mesh), -16));
  requireRoom(shape, scene::triangleCount(backing), bytesOf(backing));
  scene::addMesh(scene_, std::move(backing), blackMaterial());
}

void Shapes::addInstance(StoredMesh& stored, const glm::dmat4& map, const Object& shape, const Look& look) {
  const std::optional<scene::Placement> placement = scene::placementOf(map);
  if (!placement) {
    addPlaced(stored.mesh, map, shape, look);
    return;
  }
  const bool isMirrored = scene::mirrors(map);
  std::optional<std::uint32_t>& index = isMirrored ? stored.mirrored : stored.shared;
  if (!index) {
    scene::Mesh mesh = stored.mesh;
    if (isMirrored) {
      for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
      for (glm::vec4& tangent : mesh.tangents) tangent.w = -tangent.w;
    }
    requireRoom(shape, 0, bytesOf(mesh));
    index = scene::storeMesh(scene_, std::move(mesh));
  }
  for (const glm::vec4& row : placement->points) {
    const double farthest = stored.reach *
                                (std::abs(double{row.x}) + std::abs(double{row.y}) + std::abs(double{row.z})) +
                            std::abs(double{row.w});
    if (!(farthest < double{std::numeric_limits<float>::max()}))
      throw PlacedError{shape.place, "a vertex is placed beyond the range of single precision"};
  }
  requireRoom(shape, scene::triangleCount(stored.mesh), sizeof(scene::Placement) + sizeof(scene::PrimitiveRun));
  scene::addInstance(scene_, *index, *placement, look.material);
}

void Shapes::requireRoom(const Object& shape, std::uint64_t triangles, std::uint64_t bytes) {
  constexpr std::uint64_t kMaxTriangles = scene::PrimitiveList::kMaxSize;
  triangleCount_ += triangles;
  byteCount_ += bytes;
  if (triangleCount_ > kMaxTriangles) {
    throw PlacedError{shape.place, fmt::format("the scene has more than {} triangles", kMaxTriangles)};
  }
  requireMemory(file_.name + ": the scene", byteCount_, "use a machine with more memory");
}

std::uint64_t Shapes::hashFiles(std::uint64_t hash) const {
  for (const std::uint64_t file : hashes_) hash = fnv1aOfText(fmt::format("mesh {:x}", file), hash);
  return hash;
}

}  // namespace candela::mitsuba
