// The content of an OBJ file: vertices, and triangles over them.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "host/formats/loading/diagnostic.h"

namespace candela::obj {

inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A corner of a triangle, by its indices in ObjModel. `texCoord` and `normal` may be kNone.
struct Corner {
  std::uint32_t position = 0;
  std::uint32_t texCoord = kNone;
  std::uint32_t normal = kNone;
};

/// Consecutive triangles of one object and one material, whose corners have the same attributes.
struct Run {
  std::size_t firstCorner = 0;
  std::uint32_t object = 0;
  std::uint32_t material = kNone;  ///< into ObjModel::materialNames
  bool hasTexCoords = false;
  bool hasNormals = false;
};

struct NamedPlace {
  std::string name;
  scene::Position position;
};

/// A normal that the file does not state: the mean of the triangles of a smoothing group at a vertex.
class SmoothNormals {
 public:
  /// Returns the index of the normal of a group at a position.
  std::uint32_t find(std::uint32_t position, std::uint32_t group);
  /// Adds the normal of a triangle to its corners, weighted by their angles (Thürmer and Wüthrich, "Computing Vertex
  /// Normals from Polygonal Facets", 1998).
  void add(const std::uint32_t (&normals)[3], const glm::vec3 (&points)[3]);
  std::size_t size() const { return sums_.size(); }
  /// Returns the unit vector of a normal; 0 if its triangles have no area, or cancel each other.
  glm::vec3 at(std::uint32_t normal) const;

 private:
  struct Entry {
    std::uint32_t group;
    std::uint32_t next;  ///< of the same position; kNone: the last
  };
  std::vector<std::uint32_t> first_{};  ///< by position
  std::vector<Entry> entries_{};
  std::vector<glm::dvec3> sums_{};
};

/// Longer names of objects and materials are cut. Bytes that are no text of a terminal are replaced in them.
inline constexpr std::size_t kMaxNameLength = 1024;

struct ObjModel {
  std::vector<glm::vec3> positions{};
  std::vector<glm::vec3> colours{};  ///< linear; empty, or one for each position
  std::vector<glm::vec2> texCoords{};
  std::vector<glm::vec3> normals{};  ///< of any length
  SmoothNormals smoothNormals{};     ///< Corner::normal counts them from kSmooth on
  std::vector<Corner> corners{};     ///< three for each triangle
  std::vector<Run> runs{};
  std::vector<std::string> objectNames{};
  std::vector<NamedPlace> materialNames{};  ///< of `usemtl`, in the order of their first use
  std::vector<NamedPlace> libraries{};      ///< arguments of `mtllib`
  std::size_t faceCount = 0;
  std::map<std::string, std::string> omissions{};  ///< by keyword, what is not rendered

  static constexpr std::uint32_t kSmooth = 1u << 31;
};

}  // namespace candela::obj
