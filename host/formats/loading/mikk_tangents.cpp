// Groups the triangles around each vertex, and averages their tangents by angle.
#include "host/formats/loading/mikk_tangents.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace candela::scene {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr std::uint32_t kNone = 0xffffffffu;

struct Corner {
  glm::vec3 position;
  glm::vec3 normal;
  glm::vec2 st;  ///< t upwards

  /// The bits of all numbers, equal for 0 and -0.
  std::array<std::uint32_t, 8> key() const {
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x + 0.0f); };
    return {bits(position.x), bits(position.y), bits(position.z), bits(normal.x),
            bits(normal.y),   bits(normal.z),   bits(st.x),       bits(st.y)};
  }
};

struct Face {
  dvec3 tangent{0};                                         ///< direction of increasing s, unit length
  bool preserves = false;                                   ///< the texture is not mirrored
  bool joinsAny = true;                                     ///< the texture coordinates have no area
  bool isDegenerate = false;                                ///< two corners have the same position
  std::array<std::uint32_t, 3> vertex{};                    ///< equal for equal corners
  std::array<std::uint32_t, 3> next{kNone, kNone, kNone};   ///< beyond the edge from corner k to corner k + 1
  std::array<std::uint32_t, 3> group{kNone, kNone, kNone};  ///< of the tangent at corner k
};

dvec3 unitOrZero(const dvec3& v) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : dvec3(0);
}

dvec3 flattened(const dvec3& v, const dvec3& normal) { return unitOrZero(v - dot(v, normal) * normal); }

std::vector<Corner> cornersOf(const Mesh& mesh, const TextureReference& reference) {
  const std::vector<glm::vec2>& coords = mesh.texCoords[reference.texCoordSet];
  std::vector<Corner> corners;
  for (std::uint32_t t = 0; t < triangleCount(mesh); ++t) {
    const auto p = attributeOf(mesh, mesh.positions, t);
    const glm::vec3 flat(unitOrZero(cross(dvec3(p[1]) - dvec3(p[0]), dvec3(p[2]) - dvec3(p[0]))));
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::size_t vertex = vertexIndex(mesh, t, k);
      const glm::vec3 uv(coords.empty() ? glm::vec2(0) : coords[vertex], 1);
      const glm::vec3 normal = mesh.normals.empty() ? flat : glm::vec3(unitOrZero(dvec3(mesh.normals[vertex])));
      corners.push_back({p[k], normal, {dot(reference.rowS, uv), 1 - dot(reference.rowT, uv)}});
    }
  }
  return corners;
}

/// Numbers corners so that equal ones have equal numbers.
std::vector<std::uint32_t> weld(const std::vector<Corner>& corners) {
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return corners[a].key() < corners[b].key(); });
  std::vector<std::uint32_t> numbers(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool isFirst = i == 0 || corners[order[i]].key() != corners[order[i - 1]].key();
    numbers[order[i]] = isFirst ? order[i] : numbers[order[i - 1]];
  }
  return numbers;
}

Face faceOf(const Corner* c, const std::uint32_t* vertex) {
  Face face;
  std::copy_n(vertex, 3, face.vertex.begin());
  face.isDegenerate = c[0].position == c[1].position || c[1].position == c[2].position ||
                      c[2].position == c[0].position;
  const dvec2 st1 = dvec2(c[1].st) - dvec2(c[0].st);
  const dvec2 st2 = dvec2(c[2].st) - dvec2(c[0].st);
  const double area = st1.x * st2.y - st1.y * st2.x;
  face.preserves = area > 0;
  if (area == 0) return face;
  const dvec3 edge1 = dvec3(c[1].position) - dvec3(c[0].position);
  const dvec3 edge2 = dvec3(c[2].position) - dvec3(c[0].position);
  face.tangent = (face.preserves ? 1.0 : -1.0) * unitOrZero(st2.y * edge1 - st1.y * edge2);
  face.joinsAny = face.tangent == dvec3(0) || st1.x * edge2 == st2.x * edge1;
  return face;
}

struct Edge {
  std::uint32_t low, high;  ///< vertices
  std::uint32_t face, side;
  bool ascends;  ///< from `low` to `high` in the order of the face
};

/// Links faces that share an edge in opposite directions, in pairs by their order.
void linkNeighbours(std::vector<Face>& faces) {
  std::vector<Edge> edges;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t k = 0; !faces[f].isDegenerate && k < 3; ++k) {
      const std::uint32_t a = faces[f].vertex[k];
      const std::uint32_t b = faces[f].vertex[(k + 1) % 3];
      edges.push_back({std::min(a, b), std::max(a, b), f, k, a < b});
    }
  }
  const auto key = [](const Edge& e) { return std::array{e.low, e.high, e.face, e.side}; };
  std::ranges::sort(edges, {}, key);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    std::uint32_t& mine = faces[edges[i].face].next[edges[i].side];
    for (std::size_t j = i + 1; j < edges.size() && mine == kNone; ++j) {
      if (edges[j].low != edges[i].low || edges[j].high != edges[i].high) break;
      std::uint32_t& other = faces[edges[j].face].next[edges[j].side];
      if (other != kNone || edges[j].ascends == edges[i].ascends) continue;
      mine = edges[j].face;
      other = edges[i].face;
    }
  }
}

std::uint32_t cornerOf(const Face& face, std::uint32_t vertex) {
  return static_cast<std::uint32_t>(std::ranges::find(face.vertex, vertex) - face.vertex.begin());
}

/// A corner of a face, by index.
struct FaceCorner {
  std::uint32_t face, corner;
};

/// Adds a corner to a group, unless its face is mirrored otherwise. Returns whether it was added.
bool join(Face& face, std::uint32_t corner, std::uint32_t group, bool preserves) {
  if (face.group[corner] != kNone) return false;
  const bool isFree = face.joinsAny && face.group == std::array{kNone, kNone, kNone};
  if (isFree) face.preserves = preserves;
  if (face.preserves != preserves) return false;
  face.group[corner] = group;
  return true;
}

/// Returns the corners that share one tangent with the corner at `start`: those of faces that continue each other
/// across edges at its vertex.
std::vector<FaceCorner> gather(std::vector<Face>& faces, FaceCorner start, std::uint32_t group) {
  const bool preserves = faces[start.face].preserves;
  const std::uint32_t vertex = faces[start.face].vertex[start.corner];
  std::vector<FaceCorner> members;
  std::vector<FaceCorner> pending{start};
  while (!pending.empty()) {
    const FaceCorner member = pending.back();
    pending.pop_back();
    if (!join(faces[member.face], member.corner, group, preserves)) continue;
    members.push_back(member);
    for (const std::uint32_t side : {(member.corner + 2) % 3, member.corner}) {
      const std::uint32_t next = faces[member.face].next[side];
      if (next != kNone) pending.push_back({next, cornerOf(faces[next], vertex)});
    }
  }
  return members;
}

/// The mean of the members' tangents, weighted by the angle of each triangle at the vertex.
dvec3 meanTangent(const std::vector<Face>& faces, const std::vector<Corner>& corners,
                  const std::vector<FaceCorner>& members) {
  dvec3 sum(0);
  for (const FaceCorner& member : members) {
    if (faces[member.face].joinsAny) continue;
    const Corner* const c = &corners[std::size_t{3} * member.face];
    const dvec3 normal(c[member.corner].normal);
    const dvec3 p(c[member.corner].position);
    const dvec3 before = flattened(dvec3(c[(member.corner + 2) % 3].position) - p, normal);
    const dvec3 after = flattened(dvec3(c[(member.corner + 1) % 3].position) - p, normal);
    sum += std::acos(std::clamp(dot(before, after), -1.0, 1.0)) * flattened(faces[member.face].tangent, normal);
  }
  return unitOrZero(sum);
}

template <class Value>
void repeatByCorner(std::vector<Value>& attribute, const std::vector<std::uint32_t>& indices) {
  if (attribute.empty()) return;
  std::vector<Value> corners;
  corners.reserve(indices.size());
  for (const std::uint32_t index : indices) corners.push_back(attribute[index]);
  attribute = std::move(corners);
}

}  // namespace

std::vector<glm::vec4> mikkTangents(const Mesh& mesh, const TextureReference& reference) {
  const std::vector<Corner> corners = cornersOf(mesh, reference);
  const std::vector<std::uint32_t> vertices = weld(corners);
  std::vector<Face> faces;
  for (std::size_t i = 0; i < corners.size(); i += 3) faces.push_back(faceOf(&corners[i], &vertices[i]));
  linkNeighbours(faces);
  std::vector<glm::vec4> tangents(corners.size(), glm::vec4(0));
  std::uint32_t group = 0;
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (faces[f].isDegenerate || faces[f].joinsAny || faces[f].group[k] != kNone) continue;
      const std::vector<FaceCorner> members = gather(faces, {f, k}, group++);
      const glm::vec4 mean(meanTangent(faces, corners, members), 0);
      for (const FaceCorner& member : members) tangents[std::size_t{3} * member.face + member.corner] = mean;
    }
  }
  for (std::size_t i = 0; i < tangents.size(); ++i) tangents[i].w = faces[i / 3].preserves ? 1.0f : -1.0f;
  return tangents;
}

void addMikkTangents(Mesh& mesh, const TextureReference& reference) {
  std::vector<glm::vec4> tangents = mikkTangents(mesh, reference);
  const std::vector<std::uint32_t> indices = std::move(mesh.indices);
  mesh.indices.clear();
  repeatByCorner(mesh.positions, indices);
  repeatByCorner(mesh.normals, indices);
  for (std::vector<glm::vec2>& set : mesh.texCoords) repeatByCorner(set, indices);
  repeatByCorner(mesh.colours, indices);
  mesh.tangents = std::move(tangents);
}

}  // namespace candela::scene
