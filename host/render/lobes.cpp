#include "host/render/lobes.h"

namespace candela {

Lobes lobesOf(const Material& material) {
  if (material.kd == 1) return {.diffuse = 1};
  if (material.ks == 1) return {.mirror = true};
  const double transmitted = material.ior > 0 ? 1 : 0;
  if (material.kd == 0 && material.ks == 0) return {.dielectric = transmitted};
  const double sum = double{material.kd} + double{material.ks} + double{material.t};
  const double scale = sum > 1 ? 1 / sum : 1;
  return {.diffuse = material.kd * scale, .glossy = material.ks * scale, .dielectric = material.t * scale * transmitted};
}

}  // namespace candela
