// `mesh`: shared vertices and triangles by index.
#include <fmt/format.h>

#include <vector>

#include "host/scene/parser.h"
#include "host/scene/scene_builder.h"
#include "host/scene/statements.h"

namespace candela {
namespace {

/// A count of things of three numbers each, checked against what the rest of the file can hold.
std::size_t readCount(Parser& parser, std::string_view what, std::int64_t min) {
  constexpr std::int64_t kMost = 0xffffffff;
  const auto count = static_cast<std::size_t>(parser.in.wholeNumber(what, min, kMost));
  if (count <= (parser.tokens.bytesLeft() + 1) / 6) return count;
  StatementReader::fail(parser.in.lastNumber(),
                        fmt::format("{} {} does not fit into the rest of the file", what, count));
}

/// 1-based; 0 and below count from the end, so that -1 is the last vertex and 0 is none.
std::size_t readIndex(Parser& parser, std::size_t vertexCount) {
  const auto count = static_cast<std::int64_t>(vertexCount);
  const std::int64_t index = parser.in.wholeNumber("a vertex index", -count, count);
  if (index == 0) {
    StatementReader::fail(parser.in.lastNumber(), "vertex index 0: the first vertex is 1, the last one also -1");
  }
  return static_cast<std::size_t>(index > 0 ? index - 1 : index + count);
}

}  // namespace

void parseMesh(Parser& parser) {
  std::vector<glm::vec3> vertices(readCount(parser, "the number of vertices", 1));
  const std::size_t faceCount = readCount(parser, "the number of triangles", 0);
  for (glm::vec3& vertex : vertices) vertex = parser.in.vector("a vertex");
  const std::uint32_t material = parser.currentMaterial();
  for (std::size_t i = 0; i < faceCount; ++i) {
    Triangle triangle;
    for (glm::vec3& corner : triangle.p) corner = vertices[readIndex(parser, vertices.size())];
    addTriangle(parser.scene, triangle, material);
  }
}

}  // namespace candela
