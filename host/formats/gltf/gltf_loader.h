// The loader of glTF 2.0, as JSON (.gltf) or GLB (.glb): docs/gltf.md.
#pragma once
#include "host/formats/loading/loader.h"

namespace candela::gltf {

scene::Loader gltfLoader();

/// Loader::load of glTF.
scene::LoadedScene loadGltf(const scene::SceneFile& file, const scene::LoadOptions& options);

}  // namespace candela::gltf
