// The loader of NFF and P3F, in all their dialects.
#pragma once
#include "host/scene/loader.h"

namespace candela::scene {

/// Returns a loader that recognises texts whose first word is a keyword. WorldToolKit's format of the same name is
/// recognised too, and refused with a message that says so.
Loader nffLoader();

/// Implements Loader::load for NFF and P3F.
LoadedScene loadNff(const SceneFile& file, const LoadOptions& options);

}  // namespace candela::scene
