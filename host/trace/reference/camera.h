// Computes camera rays from pixels and random numbers: docs/light-transport.md section 3.
#pragma once
#include "host/scene/scene.h"
#include "host/trace/reference/ray.h"
#include "host/trace/reference/sampler.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

class CameraRays {
 public:
  /// Uses the size, pixel origin, filter, lens and antialiasing of `image`.
  CameraRays(const scene::Camera& camera, const render::ImageSettings& image);
  /// Sets whether rays pass through random points of their pixels.
  void setJitter(bool jitters) { jitters_ = jitters; }
  Ray generate(std::uint32_t x, std::uint32_t y, SampleNumbers& numbers) const;

 private:
  double filterOffset(SampleNumbers& numbers, std::uint32_t dimension) const;

  bool jitters_;
  render::PixelFilter filter_;
  render::LensKind lens_;
  dvec3 eye_;               ///< of an orthographic camera, from which rays start: the centre of the view
  dvec3 right_;             ///< unit, u of the specification, or -u if the camera mirrors
  dvec3 upward_;            ///< unit, v of the specification
  dvec3 forward_;           ///< from the eye to the centre of the view; of an orthographic camera, the direction
  glm::dvec2 viewPixels_;   ///< number of pixels that fill the view plane
  glm::dvec2 pixelOrigin_;  ///< within a pixel
  glm::dvec2 planeSize_;    ///< size of the view plane
  double lensRadius_;
  bool isOrthographic_;
  double focal_;
};

}  // namespace candela::reference
