// The camera in a kernel's constants: docs/light-transport.md section 3.
#pragma once
#include "host/render/settings.h"
#include "host/scene/scene.h"
#include "shaders/shared/render_data.h"

namespace candela::flatten {

/// Sets everything in `constants` that depends on the camera: its vectors, the lens, and the maximum length of `ao`
/// rays. All values are computed in double precision and rounded once.
void setCamera(gpu::RenderConstants& constants, const scene::Camera& camera, const render::ImageSettings& image);

}  // namespace candela::flatten
