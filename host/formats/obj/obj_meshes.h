// The meshes of an OBJ file.
#pragma once
#include <span>

#include "host/formats/obj/obj_model.h"
#include "host/scene/scene.h"

namespace candela::obj {

/// Adds the triangles of a model to a scene in their order, and names its objects. There is a mesh for each material
/// and each set of attributes. `materials`: the index in Scene::materials of each of ObjModel::materialNames. Triangles
/// without a material have the last material of the scene. Throws FileError for too many meshes.
void addMeshes(const ObjModel& model, std::span<const std::uint32_t> materials, scene::Scene& scene);

}  // namespace candela::obj
