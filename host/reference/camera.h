// From a pixel and random numbers to a ray: docs/light-transport.md section 3.
#pragma once
#include "host/reference/ray.h"
#include "host/reference/sampler.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::reference {

class CameraRays {
 public:
  /// Of `image`, size, pixel origin, filter, lens and whether pixels are jittered count.
  CameraRays(const scene::Camera& camera, const render::ImageSettings& image);
  Ray generate(std::uint32_t x, std::uint32_t y, SampleNumbers& numbers) const;

 private:
  double filterOffset(SampleNumbers& numbers, std::uint32_t dimension) const;

  bool jitters_;
  render::FilterKind filter_;
  render::LensKind lens_;
  dvec3 eye_;
  dvec3 right_;             ///< unit, u of the page
  dvec3 upward_;            ///< unit, v of the page
  dvec3 forward_;           ///< from the eye to the centre of the view plane
  glm::dvec2 viewPixels_;   ///< that fill the view plane
  glm::dvec2 pixelOrigin_;  ///< within a pixel
  glm::dvec2 planeSize_;    ///< of the view plane
  double lensRadius_;
  double focal_;
};

}  // namespace candela::reference
