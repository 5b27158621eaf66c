// The only comment of a scene file with a meaning: the known mean of the image.
#pragma once
#include <optional>
#include <string_view>

#include "host/formats/loading/diagnostic_log.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Returns the first "# exact-mean: r g b [x y width height]" in the text of a scene. If it cannot be read, an error is
/// added to `log`.
std::optional<ExactMean> findExactMean(std::string_view text, DiagnosticLog& log);

}  // namespace candela::scene
