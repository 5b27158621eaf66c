// The surface of an MTL material: docs/mesh-formats.md, "Materials of OBJ".
#pragma once
#include "host/formats/obj/mtl_file.h"
#include "host/formats/obj/mtl_textures.h"
#include "host/scene/material.h"

namespace candela::obj {

/// The rules of docs/mesh-formats.md. Colours above 1 are limited to 1, apart from emission. `hasColours`: vertices
/// have colours, so that the diffuse colour is white where the material states none.
scene::Material fromMtl(const MtlMaterial& material, const MtlReferences& textures, bool hasColours);

}  // namespace candela::obj
