// Hits of a ray caster as words, for comparisons bit by bit.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "host/trace/device/ray_caster.h"

namespace candela::device {

/// The bits of the distance and the primitive index, or gpu::kNoPrimitive, of each ray's hit; with `anyHit` 0, and
/// whether the ray is occluded.
using CastWords = std::vector<std::array<std::uint32_t, 2>>;

inline CastWords castWords(RayCaster& caster, std::span<const gpu::CastRay> rays, bool anyHit) {
  caster.load(rays, anyHit);
  caster.trace();
  CastWords words;
  for (const gpu::CastHit& hit : caster.hits()) words.push_back({hit.found.x, hit.found.y});
  return words;
}

}  // namespace candela::device
