// Computes geometric and interpolated normals.
#include "host/trace/reference/surface.h"

#include <array>
#include <cmath>
#include <optional>

#include "host/trace/reference/coincidence.h"
#include "host/trace/reference/geometry.h"

namespace candela::reference {
namespace {

// The outward normal where a ray hits a shape.
struct OutwardNormal {
  const Ray& ray;
  double distance;
  bool startsHere;

  dvec3 operator()(const SphereShape& sphere) const { return sphere.normal(ray.at(distance)); }
  dvec3 operator()(const TriangleShape& triangle) const { return normalize(triangle.areaNormal()); }
  dvec3 operator()(const BoxShape& box) const { return box.normal(ray, distance, startsHere); }
  dvec3 operator()(const ConeShape& cone) const { return cone.normal(ray.at(distance)); }
  dvec3 operator()(const PlaneShape& plane) const { return plane.unitNormal; }
};

bool hasAttributes(const scene::Mesh& mesh) {
  return !mesh.normals.empty() || !mesh.texCoords[0].empty() || !mesh.texCoords[1].empty() || !mesh.tangents.empty() ||
         !mesh.colours.empty();
}

// Returns the barycentric coordinates at which the ray hits a triangle of a mesh that has more than positions; nothing
// for other primitives.
std::optional<dvec2> barycentricsOf(const scene::Scene& scene, const Ray& ray, const scene::Primitive& primitive) {
  if (primitive.kind != scene::PrimitiveKind::triangle || !hasAttributes(meshOf(scene, primitive))) return std::nullopt;
  return TriangleShape(triangleOf(scene, primitive)).barycentrics(ray);
}

// Returns the weighted mean of the vertex normals, not normalised; 0 for triangles without normals.
dvec3 interpolatedNormal(const scene::Scene& scene, const scene::Primitive& triangle, const dvec2& b) {
  if (!isSmooth(scene, triangle)) return dvec3(0);
  const scene::VertexNormals normals = vertexNormalsOf(scene, triangle);
  return interpolate<dvec3>(std::to_array(normals.n), b);
}

}  // namespace

Surface surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit) {
  const scene::Primitive& primitive = scene.primitives[hit.primitive];
  Surface surface;
  surface.position = ray.at(hit.distance);
  surface.outwardNormal = std::visit(OutwardNormal{ray, hit.distance, ray.originPrimitive == hit.primitive},
                                     preparedShape(scene, primitive));
  surface.fromOutside = dot(ray.direction, surface.outwardNormal) < 0;
  surface.facingNormal = surface.fromOutside ? surface.outwardNormal : -surface.outwardNormal;
  surface.shadingNormal = surface.facingNormal;
  surface.smoothNormal = surface.outwardNormal;
  surface.primitive = hit.primitive;
  surface.material = primitive.material;
  if (isAtOnce(hit.distance)) {
    surface.contact = ray.crosses == (ray.contact != Contact::back) ? Contact::beyond : Contact::back;
  }

  const std::optional<dvec2> b = barycentricsOf(scene, ray, primitive);
  if (!b) return surface;
  const dvec3 mean = interpolatedNormal(scene, primitive, *b);
  constexpr double kMinCosine = 0x1p-16;  // so that rounding does not decide on which side a normal is
  const double height = dot(mean, surface.outwardNormal);
  if (std::abs(height) > kMinCosine * length(mean)) {
    surface.smoothNormal = normalize(height < 0 ? -mean : mean);
    const dvec3 facing = surface.fromOutside ? surface.smoothNormal : -surface.smoothNormal;
    if (dot(facing, ray.direction) < 0) surface.shadingNormal = facing;
  }
  surface.attributes = attributesAt(scene, primitive, *b, surface.smoothNormal);
  return surface;
}

}  // namespace candela::reference
