// Stores primitives and attributes as 16-byte records.
#include "host/flatten/flatten_primitives.h"

#include <cmath>

#include "host/scene/shape.h"

namespace candela::flatten {
namespace {

// Returns the point of the sphere nearest to the camera. Rays hit a huge sphere near that point, so its coordinates are
// small.
glm::dvec3 sphereAnchor(const glm::dvec3& eye, const glm::dvec3& centre, double radius) {
  const glm::dvec3 towardsCamera = eye - centre;
  const double distance = glm::length(towardsCamera);
  const glm::dvec3 direction = distance > 0 ? towardsCamera / distance : glm::dvec3(1, 0, 0);
  return glm::dvec3(glm::vec3(centre + radius * direction));
}

std::uint32_t kindWord(const scene::Scene& scene, const PrimitiveContext& context, std::uint32_t kindAndFlags) {
  const scene::Primitive& primitive = scene.primitives[context.primitive];
  const std::uint32_t touched = context.touched ? gpu::kFlagTouched : 0;
  const std::uint32_t opaque = scene.materials[primitive.material].opaque ? gpu::kFlagOpaque : 0;
  return kindAndFlags | touched | opaque | primitive.material << gpu::kMaterialShift;
}

void appendShape(const scene::Sphere& sphere, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows,
                 Rows&) {
  const std::uint32_t inside = sphere.radius < 0 ? gpu::kFlagInsideOnly : 0;
  rows.push_back({});
  rows.push_back({0, 0, 0, context.primitive});
  placeSphere(sphere, scene.camera->from, std::span(rows).last<2>());
  rows.push_back({context.light, 0, 0, kindWord(scene, context, gpu::kKindSphere | inside)});
}

void appendNormals(const scene::VertexNormals& normals, std::uint32_t light, Rows& rows) {
  rows.push_back(row(glm::dvec3(normals.n[0]), light));
  rows.push_back(row(glm::dvec3(normals.n[1]), 0u));
  rows.push_back(row(glm::dvec3(normals.n[2]), 0u));
}

// Coordinates that a mesh lacks are 0.
void appendTexCoords(const scene::Mesh& mesh, std::uint32_t triangle, Rows& rows) {
  for (std::uint32_t corner = 0; corner < 3; ++corner) {
    const std::size_t vertex = vertexIndex(mesh, triangle, corner);
    gpu::uvec4 words(0);
    for (int set = 0; set < 2; ++set) {
      const std::vector<glm::vec2>& coords = mesh.texCoords[static_cast<std::size_t>(set)];
      if (coords.empty()) continue;
      words[2 * set] = floatBits(double{coords[vertex].x});
      words[2 * set + 1] = floatBits(double{coords[vertex].y});
    }
    rows.push_back(words);
  }
}

// Appends the values of an attribute at the three vertices.
void appendVectors(const scene::Mesh& mesh, const std::vector<glm::vec4>& attribute, std::uint32_t triangle,
                   Rows& rows) {
  for (const glm::vec4& value : attributeOf(mesh, attribute, triangle)) {
    rows.push_back(row(glm::dvec3(value), double{value.w}));
  }
}

// Returns the flags that name a triangle's attributes.
std::uint32_t attributeFlags(const scene::Scene& scene, const PrimitiveContext& context,
                             const scene::Primitive& triangle) {
  const scene::Material& material = scene.materials[triangle.material];
  const bool hasTexture = isTextured(material) || (material.opacity && material.opacity->texture);
  const bool isMapped = hasTexture || (context.keepsTexCoords && !meshOf(scene, triangle).texCoords[0].empty());
  return (isSmooth(scene, triangle) ? gpu::kFlagSmooth : 0) | (isMapped ? gpu::kFlagTexCoords : 0) |
         (meshOf(scene, triangle).colours.empty() ? 0 : gpu::kFlagColours) |
         (hasTangents(scene, triangle) ? gpu::kFlagTangents : 0) |
         (coloursOfEmission(scene, triangle) ? gpu::kFlagEmissionColours : 0);
}

// Appends the attributes that the flags of a triangle name.
void appendAttributes(const scene::Scene& scene, const PrimitiveContext& context, const scene::Primitive& triangle,
                      std::uint32_t flags, Rows& rows) {
  if (flags & gpu::kFlagSmooth) {
    appendNormals(vertexNormalsOf(scene, triangle), context.light, rows);
  } else {
    rows.push_back({context.light, 0, 0, 0});
  }
  const scene::Mesh& mesh = meshOf(scene, triangle);
  if (flags & gpu::kFlagTexCoords) appendTexCoords(mesh, triangle.index, rows);
  if (flags & gpu::kFlagColours) appendVectors(mesh, mesh.colours, triangle.index, rows);
  if (flags & gpu::kFlagTangents) appendVectors(mesh, mesh.tangents, triangle.index, rows);
}

void appendShape(const scene::Triangle& triangle, const scene::Scene& scene, const PrimitiveContext& context,
                 Rows& rows, Rows& attributes) {
  const scene::Primitive& primitive = scene.primitives[context.primitive];
  const std::uint32_t flags = attributeFlags(scene, context, primitive);
  const std::uint32_t passed = scene.materials[primitive.material].opacity ? gpu::kFlagTransparent : 0;
  const std::uint32_t extra = flags != 0 ? static_cast<std::uint32_t>(attributes.size()) : context.light;
  if (flags != 0) appendAttributes(scene, context, primitive, flags, attributes);
  rows.push_back(row(glm::dvec3(triangle.p[0]), extra));
  rows.push_back(row(glm::dvec3(triangle.p[1]), context.primitive));
  rows.push_back(row(glm::dvec3(triangle.p[2]), kindWord(scene, context, gpu::kKindTriangle | flags | passed)));
}

void appendShape(const scene::Box& box, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows, Rows&) {
  rows.push_back(row(glm::dvec3(box.min), 0u));
  rows.push_back(row(glm::dvec3(box.max), context.primitive));
  rows.push_back({0, 0, 0, kindWord(scene, context, gpu::kKindBox)});
}

void appendShape(const scene::Cone& cone, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows,
                 Rows&) {
  rows.push_back(row(glm::dvec3(cone.base), double{cone.baseRadius}));
  rows.push_back(row(glm::dvec3(cone.apex), context.primitive));
  rows.push_back({floatBits(cone.apexRadius), 0, 0, kindWord(scene, context, gpu::kKindCone)});
}

void appendShape(const scene::Plane& plane, const scene::Scene& scene, const PrimitiveContext& context, Rows& rows,
                 Rows&) {
  const glm::dvec3 point(plane.p[0]);
  const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(plane.p[1]) - point, glm::dvec3(plane.p[2]) - point));
  rows.push_back(row(point, 0u));
  rows.push_back(row(normal, context.primitive));
  rows.push_back({0, 0, 0, kindWord(scene, context, gpu::kKindPlane)});
}

}  // namespace

void placeSphere(const scene::Sphere& sphere, const glm::vec3& eye, std::span<gpu::uvec4, 2> rows) {
  const glm::dvec3 centre(sphere.centre);
  const double radius = std::abs(double{sphere.radius});
  const glm::dvec3 anchor = sphereAnchor(glm::dvec3(eye), centre, radius);
  const glm::dvec3 k = radius > 0 ? (anchor - centre) / radius : glm::dvec3(0);
  rows[0] = row(anchor, radius);
  rows[1] = row(k, rows[1].w);
}

void appendPrimitive(const scene::Scene& scene, const PrimitiveContext& context, Rows& primitives, Rows& attributes) {
  std::visit([&](const auto& shape) { appendShape(shape, scene, context, primitives, attributes); },
             shapeOf(scene, scene.primitives[context.primitive]));
}

}  // namespace candela::flatten
