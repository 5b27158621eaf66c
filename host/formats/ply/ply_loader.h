// The loader of PLY, in ASCII and in both binary encodings.
#pragma once
#include "host/formats/loading/loader.h"

namespace candela::ply {

/// Returns a loader that recognises files whose first line is "ply". docs/mesh-formats.md lists what is rendered.
scene::Loader plyLoader();

}  // namespace candela::ply
