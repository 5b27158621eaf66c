// Stores geometries, and the attributes of vertices as arrays of 16-byte records.
#include "host/trace/flatten/geometries.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"

namespace candela::flatten {
namespace {

constexpr std::size_t kMaxArrayRows = std::size_t{1} << 30;  // so that words have 32-bit indices

bool readsSecondSet(const std::optional<scene::TextureReference>& texture) {
  return texture && texture->texCoordSet == 1;
}

// Returns the number of elements of an array of attributes.
std::size_t elementCount(const scene::Mesh& mesh) {
  return isIndexed(mesh) || mesh.indices.empty() ? mesh.positions.size() : mesh.indices.size();
}

std::size_t vertexOfElement(const scene::Mesh& mesh, std::size_t element) {
  return isIndexed(mesh) || mesh.indices.empty() ? element : mesh.indices[element];
}

// Coordinates that a mesh lacks are 0.
glm::vec2 texCoordsOf(const scene::Mesh& mesh, int set, std::size_t vertex) {
  const std::vector<glm::vec2>& coords = mesh.texCoords[static_cast<std::size_t>(set)];
  return coords.empty() ? glm::vec2(0) : coords[vertex];
}

void setHalf(gpu::uvec4& row, std::size_t half, const glm::vec2& value) {
  const auto first = static_cast<glm::length_t>(2 * half);
  row[first] = floatBits(double{value.x});
  row[first + 1] = floatBits(double{value.y});
}

gpu::uvec4 rowOf(const glm::vec4& value) { return row(glm::dvec3(value), double{value.w}); }

// The inverse is verticesOf() in attributes.glsl.
std::array<std::uint32_t, 2> packedCorners(const std::uint32_t* vertices) {
  static_assert(gpu::kCornerBits == 21);
  return {vertices[0] | vertices[1] << 21, vertices[1] >> 11 | vertices[2] << 10};
}

}  // namespace

bool hasSecondTexCoords(const scene::Scene& scene, const scene::Primitive& triangle) {
  const auto reads = [](const scene::Material& material) {
    return std::ranges::any_of(material.textures, readsSecondSet) ||
           (material.opacity && readsSecondSet(material.opacity->texture));
  };
  return !meshOf(scene, triangle).texCoords[1].empty() && anyMaterial(scene, triangle.material, reads);
}

bool isIndexed(const scene::Mesh& mesh) { return 3 * mesh.positions.size() < 2 * mesh.indices.size(); }

std::uint32_t Geometries::attributeFlags(const scene::Primitive& triangle) const {
  const scene::Material& material = scene_->materials[triangle.material];
  const scene::Mesh& mesh = meshOf(*scene_, triangle);
  const bool hasTexture = anyMaterial(*scene_, triangle.material, scene::isTextured) ||
                          (material.opacity && material.opacity->texture);
  const bool isMapped = hasTexture || (keepsTexCoords_ && !mesh.texCoords[0].empty());
  return (isSmooth(*scene_, triangle) ? gpu::kGeometryNormals : 0) | (isMapped ? gpu::kGeometryTexCoords : 0) |
         (hasSecondTexCoords(*scene_, triangle) ? gpu::kGeometrySecondTexCoords : 0) |
         (mesh.colours.empty() ? 0 : gpu::kGeometryColours) |
         (hasTangents(*scene_, triangle) ? gpu::kGeometryTangents : 0) |
         (coloursOfEmission(*scene_, triangle) ? gpu::kGeometryEmissionColours : 0);
}

std::size_t Geometries::rowsOf(const scene::Mesh& mesh, Kind kind) const {
  if (kind == Kind::texCoords) return (elementCount(mesh) + 1) / 2;
  if (kind != Kind::corners) return elementCount(mesh);
  const std::size_t triangles = triangleCount(mesh);
  // Three words begin at a multiple of three.
  return hasLongCorners_ ? (3 * triangles + 2 + 3) / 4 : (triangles + 1) / 2;
}

std::uint32_t Geometries::arrayOf(const scene::Primitive& start, Kind kind) {
  const bool isPlaced = kind == Kind::normals || kind == Kind::tangents;
  const ArrayKey key{start.mesh, kind, isPlaced ? start.placement : scene::Primitive::kUnplaced};
  const auto [entry, isNew] = arrays_.try_emplace(key, static_cast<std::uint32_t>(arrayRows_));
  if (isNew) arrayRows_ += rowsOf(meshOf(*scene_, start), kind);
  if (arrayRows_ > kMaxArrayRows) {
    throw FileError(fmt::format("{}: the attributes of vertices take more than {} MiB", scene_->name,
                                kMaxArrayRows * sizeof(gpu::uvec4) >> 20));
  }
  return entry->second;
}

std::uint32_t Geometries::firstCorners(std::uint32_t firstRow) const {
  return hasLongCorners_ ? (4 * firstRow + 2) / 3 : 2 * firstRow;
}

std::uint32_t Geometries::numberOf(const Record& record) {
  const auto [entry, isNew] = numbers_.try_emplace(record, static_cast<std::uint32_t>(records_.size()));
  if (isNew) records_.push_back(record);
  return entry->second;
}

std::uint32_t Geometries::numberOf(const scene::Primitive& start, std::uint32_t firstIndex) {
  const std::uint32_t flags = attributeFlags(start);
  if (flags == 0) return 0;
  const bool indexed = isIndexed(meshOf(*scene_, start));
  const auto arrayIf = [&](std::uint32_t flag, Kind kind) { return (flags & flag) != 0 ? arrayOf(start, kind) : 0; };
  const bool hasBoth = (flags & gpu::kGeometrySecondTexCoords) != 0;
  const std::uint32_t firstTriangle = start.index - firstIndex;  // of the primitive index 0
  return numberOf({flags | (indexed ? gpu::kGeometryIndexed : 0),
                   indexed ? firstCorners(arrayOf(start, Kind::corners)) + firstTriangle : 3 * firstTriangle,
                   arrayIf(gpu::kGeometryNormals, Kind::normals),
                   arrayIf(gpu::kGeometryTexCoords, hasBoth ? Kind::bothTexCoords : Kind::texCoords), 0, 0,
                   arrayIf(gpu::kGeometryColours, Kind::colours), arrayIf(gpu::kGeometryTangents, Kind::tangents)});
}

std::uint32_t Geometries::ofPrototype(const scene::PrimitiveRun& run) {
  scene::Primitive start = run.start;
  start.placement = scene::Primitive::kUnplaced;
  return numberOf(start, 0);
}

std::uint32_t Geometries::ofLight(std::uint32_t geometry, std::uint32_t primitive, std::uint32_t light) {
  Record record = records_[geometry];
  record[4] = 1;
  record[5] = light - primitive;
  return numberOf(record);
}

std::uint32_t Geometries::ofLightInstance(std::uint32_t geometry, std::uint32_t first, std::uint32_t light) {
  Record record = records_[geometry];
  record[4] = light + 1;
  record[5] = 0u - first;
  return numberOf(record);
}

void Geometries::fillCorners(const scene::Mesh& mesh, gpu::uvec4* rows, std::uint32_t firstRow) const {
  const std::size_t wordCount = hasLongCorners_ ? 3 : 2;  // of a triangle
  std::size_t word = wordCount * firstCorners(firstRow) - 4 * std::size_t{firstRow};
  const auto append = [&](std::uint32_t value) {
    rows[word / 4][static_cast<glm::length_t>(word % 4)] = value;
    ++word;
  };
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    if (hasLongCorners_) {
      for (std::size_t corner = 0; corner < 3; ++corner) append(mesh.indices[i + corner]);
    } else {
      for (const std::uint32_t packed : packedCorners(&mesh.indices[i])) append(packed);
    }
  }
}

void Geometries::fill(const ArrayKey& key, gpu::uvec4* rows, std::uint32_t firstRow) const {
  const auto [meshIndex, kind, placementIndex] = key;
  const scene::Mesh& mesh = scene_->meshes[meshIndex];
  if (kind == Kind::corners) return fillCorners(mesh, rows, firstRow);
  const scene::Placement* const placement = placementIndex != scene::Primitive::kUnplaced
                                                ? &scene_->placements[placementIndex]
                                                : nullptr;
  const std::size_t count = elementCount(mesh);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t vertex = vertexOfElement(mesh, i);
    if (kind == Kind::normals) {
      const glm::vec3& normal = mesh.normals[vertex];
      rows[i] = row(glm::dvec3(placement != nullptr ? placedNormal(*placement, normal) : normal), 0u);
    } else if (kind == Kind::texCoords) {
      setHalf(rows[i / 2], i % 2, texCoordsOf(mesh, 0, vertex));
    } else if (kind == Kind::bothTexCoords) {
      setHalf(rows[i], 0, texCoordsOf(mesh, 0, vertex));
      setHalf(rows[i], 1, texCoordsOf(mesh, 1, vertex));
    } else if (kind == Kind::colours) {
      rows[i] = rowOf(mesh.colours[vertex]);
    } else {
      const glm::vec4& tangent = mesh.tangents[vertex];
      rows[i] = rowOf(placement != nullptr ? placedTangent(*placement, tangent) : tangent);
    }
  }
}

void Geometries::append(FlatScene& flat) const {
  flat.constants.firstGeometryRow = rowCount(flat.rows);
  for (const Record& r : records_) {
    flat.rows.push_back({r[0], r[1], r[2], r[3]});
    flat.rows.push_back({r[4], r[5], r[6], r[7]});
  }
  flat.constants.firstAttributeRow = rowCount(flat.rows);
  flat.rows.resize(flat.rows.size() + arrayRows_, gpu::uvec4(0));
  gpu::uvec4* const attributes = flat.rows.data() + flat.constants.firstAttributeRow;
  for (const auto& [key, firstRow] : arrays_) fill(key, attributes + firstRow, firstRow);
}

}  // namespace candela::flatten
