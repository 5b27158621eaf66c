// The surface of a glTF material: docs/gltf.md, "Materials".
#pragma once
#include "host/formats/gltf/gltf_material.h"
#include "host/scene/material.h"

namespace candela::gltf {

/// The rules of docs/gltf.md. An unlit material emits its base colour and has no surface.
scene::Material fromGltf(const GltfMaterial& material);

}  // namespace candela::gltf
