// Computes joint matrices.
#include "host/formats/gltf/skin.h"

#include <fmt/format.h>

namespace candela::gltf {

std::vector<glm::dmat4> jointMatrices(const Value& skin, const NodeTree& nodes, std::size_t nodeCount,
                                      Accessors& accessors) {
  const Value joints = skin.require("joints");
  const std::optional<Value> bind = skin.find("inverseBindMatrices");
  const std::vector<glm::mat4> inverses = bind ? accessors.read<glm::mat4>(*bind) : std::vector<glm::mat4>{};
  if (bind && inverses.size() < joints.size()) {
    bind->fail(fmt::format("{} matrices for {} joints", inverses.size(), joints.size()));
  }
  std::vector<glm::dmat4> matrices;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const glm::dmat4& world = nodes.world(joints[i].indexInto("nodes", nodeCount));
    matrices.push_back(bind ? world * glm::dmat4(inverses[i]) : world);
  }
  return matrices;
}

}  // namespace candela::gltf
