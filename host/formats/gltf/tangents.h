// Tangents for meshes whose material needs them and whose file lacks them.
#pragma once
#include "host/formats/gltf/geometry.h"
#include "host/scene/texture.h"

namespace candela::gltf {

/// Gives the mesh the tangents of scene::mikkTangents() for a texture. A vertex whose triangles have different tangents
/// becomes several vertices.
void addTangents(Geometry& geometry, const scene::TextureReference& texture);

}  // namespace candela::gltf
