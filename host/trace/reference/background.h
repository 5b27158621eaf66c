// The radiance that a ray sees when it hits nothing: docs/light-transport.md section 7, background.
#pragma once
#include <array>

#include "host/scene/scene.h"
#include "host/trace/reference/ray.h"

namespace candela::reference {

class Background {
 public:
  /// The scene must outlive the object.
  explicit Background(const scene::Scene& scene);
  dvec3 radiance(const dvec3& direction) const;

 private:
  dvec3 texel(const scene::SkyFace& face, int column, int row) const;
  dvec3 lookUp(const scene::SkyFace& face, double sc, double tc) const;

  const scene::Scene& scene_;
  std::array<double, 256> linear_;  ///< linear value of each sRGB value
};

}  // namespace candela::reference
