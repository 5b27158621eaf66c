// The scale of films: docs/light-transport.md section 8.
#pragma once
#include <cstdint>

#include "host/image/fixed_sum.h"
#include "host/scene/scene.h"

namespace candela::scene {

/// Returns the exponent k of the scale 2^k with which the samples of a scene fit into a film, at most
/// image::kMaxFilmScale. It depends on the scene's lights alone, and is 0 unless they are strong.
std::uint32_t filmScaleOf(const Scene& scene);

}  // namespace candela::scene
