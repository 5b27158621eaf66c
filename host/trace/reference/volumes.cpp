// Beer and Lambert's law.
#include "host/trace/reference/volumes.h"

#include <cmath>

namespace candela::reference {

bool Volumes::cross(const Surface& surface) {
  const auto& parameters = scene_->materials[surface.material].surface;
  if (!parameters || !parameters->hasVolume()) return true;
  const bool isExplained = surface.fromOutside ? !material_ : material_ == surface.material;
  material_ = surface.fromOutside ? std::optional(surface.material) : std::nullopt;
  return isExplained;
}

dvec3 Volumes::transmittance(double distance) const {
  constexpr double kInfinite = 1e38;  // lights at infinity are farther
  if (!material_ || distance > kInfinite) return dvec3(1);
  return glm::exp(-distance * dvec3(scene_->materials[*material_].surface->absorption));
}

}  // namespace candela::reference
