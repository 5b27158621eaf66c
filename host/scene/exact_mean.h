// The one comment that means something: what the image's mean is known to be.
#pragma once
#include <optional>
#include <string_view>

#include "host/scene/diagnostic_log.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// The first "# exact-mean: r g b [x y width height]" of a scene's text. One that cannot be read is an error in `log`.
std::optional<ExactMean> findExactMean(std::string_view text, DiagnosticLog& log);

}  // namespace candela::scene
