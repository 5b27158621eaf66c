// Lists the vertices of each position.
#include "host/formats/obj/corner_table.h"

namespace candela::obj {

void CornerTable::beginMesh() {
  ++mesh_;
  vertices_.clear();
  next_.clear();
}

std::uint32_t CornerTable::vertexOf(const Corner& corner) {
  constexpr int kMaxSteps = 64;
  Head& head = heads_[corner.position];
  if (head.mesh != mesh_) head = {mesh_, kNone};
  std::uint32_t vertex = head.first;
  for (int step = 0; vertex != kNone && step < kMaxSteps; ++step) {
    if (vertices_[vertex].texCoord == corner.texCoord && vertices_[vertex].normal == corner.normal) return vertex;
    vertex = next_[vertex];
  }
  vertices_.push_back(corner);
  next_.push_back(head.first);
  return head.first = static_cast<std::uint32_t>(vertices_.size() - 1);
}

}  // namespace candela::obj
