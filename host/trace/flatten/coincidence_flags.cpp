// Marks surfaces with which others coincide, and how rays cross them.
#include "host/scene/stored_primitives.h"
#include "host/trace/flatten/flatten_primitives.h"
#include "host/trace/flatten/lobes.h"

namespace candela::flatten {

std::uint32_t coincidenceFlags(const scene::Scene& scene, const scene::Primitive& primitive,
                               render::Integrator integrator) {
  const scene::Material& material = scene.materials[primitive.material];
  std::uint32_t flags = gpu::kFlagCoincident;
  const auto isCrossed = [&](const scene::Material& m) { return transmits(integrator, m); };
  if (anyMaterial(scene, primitive.material, isCrossed)) flags |= gpu::kFlagTransmits;
  if (material.surface && !material.surface->hasVolume()) flags |= gpu::kFlagThinWalled;
  return flags;
}

std::uint32_t coincidentKinds(const scene::Scene& scene, const std::vector<bool>& coincident,
                              render::Integrator integrator) {
  const scene::StoredPrimitives stored(scene.primitives);
  std::vector<std::uint32_t> countBefore{0};  // of marks, by number
  for (const bool mark : coincident) countBefore.push_back(countBefore.back() + (mark ? 1 : 0));
  std::uint32_t kinds = 0;
  std::size_t emitterCount = 0;
  const std::span<const scene::PrimitiveRun> runs = scene.primitives.runs();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const std::uint32_t first = stored.firstOf(run), end = first + scene.primitives.countOf(runs[run]);
    const std::uint32_t count = countBefore[end] - countBefore[first];
    if (count == 0) continue;
    const scene::Primitive& primitive = runs[run].start;
    kinds |= 1u << static_cast<std::uint32_t>(primitive.kind);
    if ((coincidenceFlags(scene, primitive, integrator) & gpu::kFlagTransmits) != 0) kinds |= gpu::kCoincidentTransmits;
    if (isEmissive(scene.materials[primitive.material])) emitterCount += count;
  }
  return emitterCount > 1 ? kinds | gpu::kCoincidentEmitters : kinds;
}

}  // namespace candela::flatten
