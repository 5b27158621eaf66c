// Marks surfaces with which others coincide, and how rays cross them.
#include "host/flatten/flatten_primitives.h"
#include "host/flatten/lobes.h"

namespace candela::flatten {

std::vector<std::uint32_t> coincidenceFlags(const scene::Scene& scene, const std::vector<bool>& coincident,
                                            render::Integrator integrator) {
  std::vector<std::uint32_t> flags(scene.primitives.size(), 0);
  for (std::size_t i = 0; i < flags.size(); ++i) {
    if (!coincident[i]) continue;
    const scene::Material& material = scene.materials[scene.primitives[i].material];
    flags[i] = gpu::kFlagCoincident;
    if (transmits(integrator, material)) flags[i] |= gpu::kFlagTransmits;
    if (material.surface && !material.surface->hasVolume()) flags[i] |= gpu::kFlagThinWalled;
  }
  return flags;
}

}  // namespace candela::flatten
