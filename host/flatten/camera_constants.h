// The camera as the kernel wants it: docs/light-transport.md section 3.
#pragma once
#include "host/render/settings.h"
#include "host/scene/scene.h"
#include "shaders/shared/render_data.h"

namespace candela::flatten {

/// Fills the camera's rows of `constants`, computed in double and rounded once. Of `settings`, size and pixel origin
/// count.
void setCamera(gpu::RenderConstants& constants, const scene::Camera& camera, const render::RenderSettings& settings);

}  // namespace candela::flatten
