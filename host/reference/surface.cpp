// Normals, geometric and interpolated.
#include "host/reference/surface.h"

#include "host/reference/geometry.h"

namespace candela::reference {
namespace {

dvec3 outwardNormalAt(const scene::Scene& scene, const Ray& ray, const Hit& hit) {
  const scene::Primitive& primitive = scene.primitives[hit.primitive];
  switch (primitive.kind) {
    case scene::PrimitiveKind::sphere:
      return SphereShape(scene.spheres[primitive.index]).normal(ray.at(hit.distance));
    case scene::PrimitiveKind::triangle:
      return normalize(TriangleShape(triangleOf(scene, primitive)).areaNormal());
    case scene::PrimitiveKind::box:
      return BoxShape(scene.boxes[primitive.index]).normal(ray, ray.leaving == hit.primitive);
    case scene::PrimitiveKind::cone:
      return ConeShape(scene.cones[primitive.index]).normal(ray.at(hit.distance));
    case scene::PrimitiveKind::plane:
      break;
  }
  return PlaneShape(scene.planes[primitive.index]).unitNormal;
}

// The mean of a patch's vertex normals, of any length; 0 for primitives without.
dvec3 interpolatedNormal(const scene::Scene& scene, const Ray& ray, const scene::Primitive& primitive) {
  if (!isSmooth(scene, primitive)) return dvec3(0);
  const scene::VertexNormals normals = vertexNormalsOf(scene, primitive);
  const glm::vec3(&n)[3] = normals.n;
  const dvec2 b = TriangleShape(triangleOf(scene, primitive)).barycentrics(ray);
  return (1 - b.x - b.y) * dvec3(n[0]) + b.x * dvec3(n[1]) + b.y * dvec3(n[2]);
}

}  // namespace

Surface surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit) {
  const scene::Primitive& primitive = scene.primitives[hit.primitive];
  Surface surface;
  surface.position = ray.at(hit.distance);
  surface.outwardNormal = outwardNormalAt(scene, ray, hit);
  surface.fromOutside = dot(ray.direction, surface.outwardNormal) < 0;
  surface.facingNormal = surface.fromOutside ? surface.outwardNormal : -surface.outwardNormal;
  surface.shadingNormal = surface.facingNormal;
  surface.primitive = hit.primitive;
  surface.material = primitive.material;

  dvec3 n = interpolatedNormal(scene, ray, primitive);
  if (n == dvec3(0)) return surface;
  n = normalize(n);
  if (dot(n, surface.facingNormal) < 0) n = -n;
  if (dot(n, ray.direction) < 0) surface.shadingNormal = n;
  return surface;
}

}  // namespace candela::reference
