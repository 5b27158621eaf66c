// The loader of OBJ, with its material files (MTL).
#pragma once
#include "host/formats/loading/loader.h"

namespace candela::obj {

/// Returns a loader that recognises files by their first statement, where NFF has no such statement.
/// docs/mesh-formats.md lists what is rendered.
scene::Loader objLoader();

}  // namespace candela::obj
