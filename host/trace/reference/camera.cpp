// Pinhole, thin lens, and parallel rays.
#include "host/trace/reference/camera.h"

#include <cmath>

#include "host/trace/reference/sampling.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {

CameraRays::CameraRays(const scene::Camera& camera, const render::ImageSettings& image)
    : jitters_(image.jittersPixels()),
      filter_(image.filter),
      lens_(image.lens),
      eye_(camera.from),
      forward_(dvec3(camera.at) - eye_),
      viewPixels_(image.size.width, image.size.height),
      pixelOrigin_(0.5),
      isOrthographic_(camera.orthographicHeight.has_value()),
      focal_(camera.focal) {
  for (int axis = 0; axis < 2; ++axis) {
    if (image.pixelOrigin == render::PixelOrigin::centre || viewPixels_[axis] == 1) continue;
    viewPixels_[axis] -= 1;
    pixelOrigin_[axis] = 0;
  }
  const dvec3 backward = normalize(-forward_);
  right_ = normalize(cross(dvec3(camera.up), backward));
  upward_ = cross(backward, right_);
  if (camera.isMirrored) right_ = -right_;
  const double height = isOrthographic_ ? double{*camera.orthographicHeight}
                                        : 2 * length(forward_) * std::tan(camera.angle * kPi / 360);
  planeSize_ = {height * viewPixels_.x / viewPixels_.y, height};
  lensRadius_ = camera.aperture * height / camera.height;
  if (camera.shift == glm::vec2(0)) return;
  const dvec3 shift = double{camera.shift.x} * planeSize_.x * right_ - double{camera.shift.y} * planeSize_.y * upward_;
  (isOrthographic_ ? eye_ : forward_) += shift;
}

double CameraRays::filterOffset(SampleNumbers& numbers, std::uint32_t dimension) const {
  if (!jitters_) return 0;
  const double u = numbers.unit(dimension);
  switch (filter_.kind) {
    case render::FilterKind::box:
      break;
    case render::FilterKind::tent:
      return sampleTent(u);
    case render::FilterKind::gaussian:
      return filter_.deviation * sampleGaussian(u);
  }
  return u - 0.5;
}

Ray CameraRays::generate(std::uint32_t x, std::uint32_t y, SampleNumbers& numbers) const {
  const dvec2 offset(filterOffset(numbers, kDimensionFilterX), filterOffset(numbers, kDimensionFilterY));
  const dvec2 raster = dvec2(x, y) + pixelOrigin_ + offset;
  const dvec3 point = (isOrthographic_ ? eye_ : forward_) + planeSize_.x * (raster.x / viewPixels_.x - 0.5) * right_ +
                      planeSize_.y * (0.5 - raster.y / viewPixels_.y) * upward_;
  const dvec3 origin = isOrthographic_ ? point : eye_;
  const dvec3 towards = isOrthographic_ ? forward_ : point;
  if (lensRadius_ == 0) return {origin, normalize(towards)};

  const dvec2 u(numbers.unit(kDimensionLensU), numbers.unit(kDimensionLensV));
  const dvec2 onLens = lensRadius_ * (lens_ == render::LensKind::disc ? sampleDisc(u) : 2.0 * u - 1.0);
  const dvec3 shift = onLens.x * right_ + onLens.y * upward_;
  return {origin + shift, normalize(towards - shift / focal_)};
}

}  // namespace candela::reference
