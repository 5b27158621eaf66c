// Converts perspective and orthographic cameras.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/formats/gltf/cameras.h"
#include "host/image/image.h"

namespace candela::gltf {
namespace {

constexpr std::uint32_t kDefaultHeight = 512;

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& other) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : other;
}

/// From `eye` along `forward` to the depth of the box's centre; 1 if that is not in front.
double depthOf(const std::optional<scene::Bounds>& bounds, const glm::dvec3& eye, const glm::dvec3& forward) {
  if (!bounds) return 1;
  const double depth = glm::dot(scene::centreOf(*bounds) - eye, forward);
  return depth > 0 ? depth : 1;
}

// Sets the image's default size from the ratio of its width to its height.
void setAspect(double aspect, scene::Camera& view) {
  view.height = kDefaultHeight;
  view.width = static_cast<std::uint32_t>(
      std::clamp(std::round(aspect * kDefaultHeight), 1.0, double{image::kMaxImageSide}));
}

void setPerspective(const Value& lens, scene::Camera& view) {
  const double yfov = lens.require("yfov").number();
  if (!(yfov > 0 && yfov < std::numbers::pi)) lens.require("yfov").fail("the angle is outside 0 to pi");
  const double aspect = lens.numberOr("aspectRatio", 1);
  if (!(aspect > 0)) lens.require("aspectRatio").fail("the ratio is not positive");
  view.angle = static_cast<float>(yfov * 180 / std::numbers::pi);
  setAspect(aspect, view);
}

// Half the extent of the view along an axis. The specification advises against negative values, which would mirror the
// picture, and forbids 0.
double magnification(const Value& lens, const char* key) {
  const double magnitude = std::abs(lens.require(key).number());
  if (!(static_cast<float>(2 * magnitude) > 0 && magnitude < 1e38)) {
    lens.require(key).fail("half the extent of the view must be from 1e-45 to 1e38");
  }
  return magnitude;
}

void setOrthographic(const Value& lens, scene::Camera& view) {
  const double xmag = magnification(lens, "xmag");
  const double ymag = magnification(lens, "ymag");
  view.orthographicHeight = static_cast<float>(2 * ymag);
  setAspect(xmag / ymag, view);
}

}  // namespace

scene::Camera cameraAt(const Value& camera, const glm::dmat4& world, const std::optional<scene::Bounds>& bounds) {
  scene::Camera view;
  const glm::dvec3 eye(world[3]);
  const glm::dvec3 forward = unitOr(-glm::dvec3(world[2]), {0, 0, -1});
  const glm::dvec3 up = unitOr(glm::dvec3(world[1]), {0, 1, 0});
  view.from = glm::vec3(eye);
  view.at = glm::vec3(eye + depthOf(bounds, eye, forward) * forward);
  view.up = glm::vec3(up);
  if (view.at == view.from || glm::length(glm::cross(forward, up)) < 1e-6) {
    camera.fail("the node of the camera places it so that it has no direction");
  }
  const Value type = camera.require("type");
  if (type.text() == "perspective") {
    setPerspective(camera.require("perspective"), view);
  } else if (type.text() == "orthographic") {
    setOrthographic(camera.require("orthographic"), view);
  } else {
    type.fail("expected \"perspective\" or \"orthographic\"");
  }
  return view;
}

}  // namespace candela::gltf
