// Tangents of meshes that state none, as MikkTSpace computes them (Mikkelsen, "Simulation of Wrinkled Surfaces
// Revisited", 2008, section 4), which tools that bake normal maps assume.
#pragma once
#include <vector>

#include "host/scene/mesh.h"
#include "host/scene/texture.h"

namespace candela::scene {

/// Returns the tangent of each corner of each triangle, three for each, as Mesh::tangents has them: unit vectors along
/// which s of `reference` increases, perpendicular to the vertex normal. The bitangent points to the top of the image.
/// If a mesh has no normals, those of the triangles are used. Triangles without area, and those whose texture
/// coordinates have none and that no other triangle continues, have tangents of length 0.
std::vector<glm::vec4> mikkTangents(const Mesh& mesh, const TextureReference& reference);

/// Gives a mesh with indices the tangents of mikkTangents(), and thereby a vertex to each corner, and no indices.
void addMikkTangents(Mesh& mesh, const TextureReference& reference);

}  // namespace candela::scene
