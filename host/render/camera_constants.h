// The camera as the kernel wants it: docs/light-transport.md section 3.
#pragma once
#include "host/render/settings.h"
#include "host/scene/scene.h"
#include "shaders/shared/render_data.h"

namespace candela {

/// Fills the camera's rows of `constants`, computed in double and rounded once. Of `settings`, size and pixel origin
/// count.
void setCamera(gpu::RenderConstants& constants, const Camera& camera, const RenderSettings& settings);

}  // namespace candela
