// The rules that turn an `f` line into weighted lobes: docs/light-transport.md section 5.
#pragma once
#include "host/scene/scene.h"

namespace candela {

/// Weights sum to at most 1; all 0: the surface is black. A mirror has weights 0 and takes `diffuse` as its colour.
struct Lobes {
  double diffuse = 0;
  double glossy = 0;
  double dielectric = 0;
  bool mirror = false;
};

Lobes lobesOf(const Material& material);

}  // namespace candela
