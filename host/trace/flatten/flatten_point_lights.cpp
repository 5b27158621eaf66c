// Stores point lights as 16-byte records.
#include "host/trace/flatten/flatten_sections.h"

namespace candela::flatten {
namespace {

struct Edges {
  glm::dvec3 tangent;
  glm::dvec3 bitangent;
};

// Returns the frame of docs/light-transport.md section 2 around the unit vector n.
Edges edgesAround(const glm::dvec3& n) {
  const double s = n.z > -0.62 ? 1.0 : -1.0;
  const double a = -1 / (s + n.z);
  const double b = n.x * n.y * a;
  return {{1 + s * n.x * n.x * a, s * b, -s * n.x}, {b, s + n.y * n.y * a, -n.y}};
}

glm::dvec3 facingOf(const scene::PointLight& light, const scene::Camera& camera) {
  const glm::dvec3 towards = glm::dvec3(camera.at) - glm::dvec3(light.position);
  return towards == glm::dvec3(0) ? glm::dvec3(0, 0, 1) : glm::normalize(towards);
}

}  // namespace

Rows pointLightRows(std::span<const scene::PointLight> lights, const scene::Camera& camera, double size) {
  Rows rows;
  for (const scene::PointLight& light : lights) {
    const Edges edges = edgesAround(facingOf(light, camera));
    rows.push_back(row(glm::dvec3(light.colour), 0.0));
    rows.push_back(row(glm::dvec3(light.position), 0.0));
    rows.push_back(row(size * edges.tangent, 0.0));
    rows.push_back(row(size * edges.bitangent, 0.0));
  }
  return rows;
}

void appendPointLights(const scene::Scene& scene, double lightSize, FlatScene& flat) {
  const Rows lights = pointLightRows(scene.pointLights, *scene.camera, lightSize);
  flat.constants.firstLightRow = rowCount(flat.rows);
  flat.constants.lightCount = static_cast<std::uint32_t>(scene.pointLights.size());
  flat.rows.insert(flat.rows.end(), lights.begin(), lights.end());
}

}  // namespace candela::flatten
