// `mesh`: shared vertices and triangles by index.
#include <vector>

#include "host/formats/loading/scene_builder.h"
#include "host/formats/nff/parser.h"
#include "host/formats/nff/statements.h"

namespace candela::scene {
namespace {

constexpr std::int64_t kMaxItems = 0xffffffff;

/// Reads an index. Indices are 1-based; negative indices count from the end, so that -1 is the last vertex. 0 is an
/// error.
std::uint32_t readIndex(Parser& parser, std::size_t vertexCount) {
  const auto count = static_cast<std::int64_t>(vertexCount);
  const std::int64_t index = parser.in.wholeNumber("a vertex index", -count, count);
  if (index == 0) {
    StatementReader::fail(parser.in.lastNumber(), "vertex index 0: indices count from 1, or from -1 backwards");
  }
  return static_cast<std::uint32_t>(index > 0 ? index - 1 : index + count);
}

}  // namespace

void parseMesh(Parser& parser) {
  std::vector<glm::vec3> vertices(parser.itemCount("the number of vertices", 1, kMaxItems, 3));
  const std::size_t faceCount = parser.itemCount("the number of triangles", 0, kMaxItems, 3);
  for (glm::vec3& vertex : vertices) vertex = parser.in.vector("a vertex");
  const std::uint32_t material = parser.currentMaterial();
  std::vector<std::uint32_t> indices(3 * faceCount);
  for (std::uint32_t& index : indices) index = readIndex(parser, vertices.size());
  addIndexedTriangles(parser.scene, vertices, indices, material);
}

}  // namespace candela::scene
