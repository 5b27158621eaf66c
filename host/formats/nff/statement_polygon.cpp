// `p` and `pp`: polygons and patches, split into triangles.
#include <vector>

#include "host/formats/loading/polygon.h"
#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

std::size_t readCount(Parser& parser, std::size_t numbersPerVertex) {
  return parser.itemCount("the number of vertices", 3, kMaxPolygonVertices, numbersPerVertex);
}

glm::vec3 readNormal(Parser& parser) {
  const Position position = parser.in.here();
  const glm::dvec3 normal = parser.in.vector("a vertex normal");
  const double length = glm::length(normal);
  if (length == 0) parser.log.error(position, "a vertex normal has length 0");
  return length == 0 ? glm::vec3(0, 0, 1) : glm::vec3(normal / length);
}

}  // namespace

void parsePolygon(Parser& parser) {
  std::vector<glm::vec3> vertices(readCount(parser, 3));
  for (glm::vec3& vertex : vertices) vertex = parser.in.vector("a vertex");
  const std::uint32_t material = parser.currentMaterial();
  for (const auto& [a, b, c] : triangulateWithWarnings(vertices, parser.keyword, parser.log).triangles) {
    addTriangle(parser.scene, {{vertices[a], vertices[b], vertices[c]}}, material);
  }
}

void parsePatch(Parser& parser) {
  const std::size_t count = readCount(parser, 6);
  std::vector<glm::vec3> vertices(count), normals(count);
  for (std::size_t i = 0; i < count; ++i) {
    vertices[i] = parser.in.vector("a vertex");
    normals[i] = readNormal(parser);
  }
  const std::uint32_t material = parser.currentMaterial();
  for (const auto& [a, b, c] : triangulateWithWarnings(vertices, parser.keyword, parser.log).triangles) {
    const Triangle triangle{{vertices[a], vertices[b], vertices[c]}};
    addTriangle(parser.scene, triangle, {{normals[a], normals[b], normals[c]}}, material);
  }
}

}  // namespace candela::scene
