// The kernel's specialisation constants for a scene and its settings.
#pragma once
#include <vector>

#include "host/trace/device/code_form.h"
#include "host/trace/flatten/scene_shape.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/compute_pipeline.h"

namespace candela::device {

/// Returns the specialisation constants. `texels`: the scene is read through the texel buffer.
std::vector<vulkan::Specialisation> specialise(const CodeForm& form, const flatten::SceneShape& shape,
                                               const render::RenderSettings& settings, bool texels);

/// Returns these constants and the bindings of shared/bindings.h, which all kernels have that read a scene.
vulkan::PipelineOptions kernelOptions(const CodeForm& form, const flatten::SceneShape& shape,
                                      const render::RenderSettings& settings, bool texels,
                                      std::uint32_t pushConstantBytes);

}  // namespace candela::device
