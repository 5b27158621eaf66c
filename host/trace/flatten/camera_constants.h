// The constants of a kernel that a session can change: camera and random numbers, docs/light-transport.md sections 3
// and 1.
#pragma once
#include "host/scene/scene.h"
#include "host/trace/flatten/scene_shape.h"
#include "host/trace/render/settings.h"
#include "shaders/shared/render_data.h"

namespace candela::flatten {

/// Sets everything in `constants` that depends on the camera: its vectors, the lens, and the maximum length of `ao`
/// rays. All values are computed in double precision and rounded once.
void setCamera(gpu::RenderConstants& constants, const scene::Camera& camera, const render::ImageSettings& image);
/// Sets everything in `shape` that depends on the camera, whose constants these are.
void noteCamera(const scene::Camera& camera, const gpu::RenderConstants& constants, SceneShape& shape);
/// Sets everything in `constants` that depends on the seed and on the number of samples.
void setSampling(gpu::RenderConstants& constants, const render::ImageSettings& image);

}  // namespace candela::flatten
