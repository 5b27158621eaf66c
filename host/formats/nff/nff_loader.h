// The loader of NFF and P3F, in all their dialects.
#pragma once
#include <filesystem>
#include <string>

#include "host/formats/loading/loader.h"

namespace candela::scene {

/// Returns a loader that recognises texts whose first word is a keyword. WorldToolKit's format of the same name is
/// recognised too, and refused with a message that says so.
Loader nffLoader();

/// Reads NFF or P3F from memory. `name` is used in messages; `env` paths are relative to `folder`.
LoadedScene parseScene(const std::string& text, const std::string& name, const std::filesystem::path& folder,
                       const LoadOptions& options = {});

}  // namespace candela::scene
