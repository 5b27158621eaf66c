// Skins: the matrices by which joints move vertices.
#pragma once
#include <vector>

#include "host/formats/gltf/nodes.h"

namespace candela::gltf {

/// For each joint, from the coordinates of the mesh at rest to those of the scene: its node's world transform times its
/// inverse bind matrix. Throws JsonError.
std::vector<glm::dmat4> jointMatrices(const Value& skin, const NodeTree& nodes, std::size_t nodeCount,
                                      Accessors& accessors);

}  // namespace candela::gltf
