// Meshes of OBJ and PLY files, as Mitsuba reads them.
#pragma once
#include <filesystem>
#include <optional>

#include "host/formats/mitsuba/document.h"
#include "host/formats/mitsuba/textures.h"
#include "host/scene/mesh.h"

namespace candela::mitsuba {

struct MeshFileOptions {
  bool hasFaceNormals = false;               ///< normals are left out
  bool flipsTexCoords = false;               ///< v becomes 1 - v
  std::optional<MeshAttribute> attribute{};  ///< of a PLY, that Mesh::colours get; without it, they are undefined
};

/// Gives a mesh with indices what the options state: normals of smooth vertices if it has none, weighted by angles.
void complete(scene::Mesh& mesh, const MeshFileOptions& options);

/// Reads the triangles of a file whose content is `bytes`: of an OBJ without its materials, groups and smoothing
/// groups. The result is one mesh with indices. A file without normals gets those of its vertices, weighted by angles,
/// unless MeshFileOptions::hasFaceNormals. Errors are added to the report; throws PlacedError after them, or for a file
/// without faces, at `place`, SceneError, and OutOfMemoryError.
scene::Mesh readObjMesh(const std::filesystem::path& path, std::string_view bytes, const MeshFileOptions& options,
                        const Place& place, Report& report);
/// Colours of faces give each triangle vertices of its own.
scene::Mesh readPlyMesh(const std::filesystem::path& path, std::string_view bytes, const MeshFileOptions& options,
                        const Place& place, Report& report);

}  // namespace candela::mitsuba
