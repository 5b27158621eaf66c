// Pinhole and thin lens.
#include "host/reference/camera.h"

#include <cmath>

#include "host/reference/sampling.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {

CameraRays::CameraRays(const Camera& camera, const RenderSettings& settings)
    : filter_(settings.filter),
      lens_(settings.lens),
      eye_(camera.from),
      forward_(dvec3(camera.at) - eye_),
      imageSize_(settings.size.width, settings.size.height),
      focal_(camera.focal) {
  const dvec3 backward = normalize(-forward_);
  right_ = normalize(cross(dvec3(camera.up), backward));
  upward_ = cross(backward, right_);
  const double height = 2 * length(forward_) * std::tan(camera.angle * kPi / 360);
  planeSize_ = {height * imageSize_.x / imageSize_.y, height};
  lensRadius_ = camera.aperture * height / camera.height;
}

Ray CameraRays::generate(std::uint32_t x, std::uint32_t y, SampleNumbers& numbers) const {
  const auto offset = [&](std::uint32_t dimension) {
    const double u = numbers.unit(dimension);
    return filter_ == FilterKind::box ? u - 0.5 : sampleTent(u);
  };
  const dvec2 raster(x + 0.5 + offset(kDimensionFilterX), y + 0.5 + offset(kDimensionFilterY));
  const dvec3 towards = forward_ + planeSize_.x * (raster.x / imageSize_.x - 0.5) * right_ +
                        planeSize_.y * (0.5 - raster.y / imageSize_.y) * upward_;
  if (lensRadius_ == 0) return {eye_, normalize(towards)};

  const dvec2 u(numbers.unit(kDimensionLensU), numbers.unit(kDimensionLensV));
  const dvec2 onLens = lensRadius_ * (lens_ == LensKind::disc ? sampleDisc(u) : 2.0 * u - 1.0);
  const dvec3 shift = onLens.x * right_ + onLens.y * upward_;
  return {eye_ + shift, normalize(towards - shift / focal_)};
}

}  // namespace candela::reference
