// The kernel's specialisation constants for a scene and its settings.
#pragma once
#include <vector>

#include "host/render/flat_scene.h"
#include "host/vulkan/compute_pipeline.h"

namespace candela {

/// `texels`: scene rows are read through the texel buffer.
std::vector<vulkan::Specialisation> specialise(const FlatScene& flat, const RenderSettings& settings, bool texels);

}  // namespace candela
