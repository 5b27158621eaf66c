// Meshes of Mitsuba's own binary format, versions 3 and 4.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "host/formats/mitsuba/mesh_files.h"

namespace candela::mitsuba {

/// Reads one of the meshes of a file whose content is `bytes`. A mesh without normals gets those of its vertices,
/// unless MeshFileOptions::hasFaceNormals. Throws FileError for a wrong file or index, and OutOfMemoryError before
/// memory is allocated if the mesh needs more than the budget.
scene::Mesh readSerializedMesh(const std::filesystem::path& path, std::string_view bytes, std::int64_t index,
                               const MeshFileOptions& options);

}  // namespace candela::mitsuba
