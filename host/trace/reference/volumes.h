// Volumes that surfaces bound, which absorb light: docs/light-transport.md section 5.6.
#pragma once
#include <optional>

#include "host/scene/scene.h"
#include "host/trace/reference/surface.h"

namespace candela::reference {

/// The volume that a ray of a path is in.
class Volumes {
 public:
  explicit Volumes(const scene::Scene& scene) : scene_(&scene) {}

  bool isInside() const { return material_.has_value(); }
  /// Follows light that is transmitted through a surface. Returns false if volumes that are nested or closed do not
  /// explain it.
  bool cross(const Surface& surface);
  /// Returns the fraction of light that passes a length of the volume; 1 for an infinite one, as volumes are bounded.
  dvec3 transmittance(double distance) const;

 private:
  const scene::Scene* scene_;
  std::optional<std::uint32_t> material_;
};

}  // namespace candela::reference
