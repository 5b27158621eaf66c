// The loader of glTF 2.0, as JSON (.gltf) or GLB (.glb): docs/gltf.md.
#pragma once
#include "host/formats/loading/loader.h"

namespace candela::gltf {

scene::Loader gltfLoader();

}  // namespace candela::gltf
