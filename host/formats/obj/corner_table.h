// Vertices of a mesh from the corners of an OBJ file, which have an index for each attribute.
#pragma once
#include <vector>

#include "host/formats/obj/obj_model.h"

namespace candela::obj {

/// Finds equal corners of one mesh after the other.
class CornerTable {
 public:
  explicit CornerTable(std::size_t positionCount) : heads_(positionCount) {}

  /// Forgets the corners of the last mesh.
  void beginMesh();
  /// Returns the index of the vertex of a corner. Corners that are found equal have one vertex; a position with very
  /// many different corners has some of them several times, so that the time stays linear.
  std::uint32_t vertexOf(const Corner& corner);
  /// The corners of the vertices, by index.
  const std::vector<Corner>& vertices() const { return vertices_; }

 private:
  struct Head {
    std::uint32_t mesh = 0;
    std::uint32_t first = kNone;  ///< vertex, valid in its mesh
  };
  std::vector<Head> heads_;  ///< by position
  std::vector<Corner> vertices_{};
  std::vector<std::uint32_t> next_{};  ///< of a vertex, another one with the same position
  std::uint32_t mesh_ = 0;
};

}  // namespace candela::obj
