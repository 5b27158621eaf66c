// Marks surfaces with which others coincide, and how rays cross them.
#include "host/trace/flatten/flatten_primitives.h"
#include "host/trace/flatten/lobes.h"

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

std::uint32_t coincidentKinds(const scene::Scene& scene, std::span<const std::uint32_t> coincidence) {
  std::uint32_t kinds = 0;
  std::size_t emitterCount = 0;
  for (std::size_t i = 0; i < coincidence.size(); ++i) {
    if (coincidence[i] == 0) continue;
    kinds |= 1u << static_cast<std::uint32_t>(scene.primitives[i].kind);
    if ((coincidence[i] & gpu::kFlagTransmits) != 0) kinds |= gpu::kCoincidentTransmits;
    if (isEmissive(scene.materials[scene.primitives[i].material])) ++emitterCount;
  }
  return emitterCount > 1 ? kinds | gpu::kCoincidentEmitters : kinds;
}

}  // namespace candela::flatten
