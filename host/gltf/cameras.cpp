// Chooses and converts cameras.
#include "host/gltf/cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/image/image.h"
#include "host/scene/quote.h"

namespace candela::gltf {
namespace {

constexpr double kFramingAngle = 30;      // degrees
constexpr double kFramingElevation = 15;  // degrees
constexpr double kFramingMargin = 1.05;
constexpr std::uint32_t kDefaultHeight = 512;

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// A camera and a visible node that has it.
struct PlacedCamera {
  std::size_t camera;
  std::size_t node;
};

std::vector<PlacedCamera> placedCameras(const Value& root, const NodeTree& nodes) {
  std::vector<PlacedCamera> placed;
  for (const std::size_t node : nodes.visible()) {
    const std::optional<Value> camera = root.require("nodes")[node].find("camera");
    if (camera) placed.push_back({camera->indexInto("cameras", root.sizeOf("cameras")), node});
  }
  return placed;
}

std::string nameOf(const Value& root, const char* list, std::size_t index) {
  return root.require(list)[index].textOr("name", "");
}

bool answers(const Value& root, const PlacedCamera& placed, const std::string& wish) {
  return wish == std::to_string(placed.camera) || wish == nameOf(root, "cameras", placed.camera) ||
         wish == nameOf(root, "nodes", placed.node);
}

std::string listOf(const Value& root, const std::vector<PlacedCamera>& all) {
  constexpr std::size_t kShown = 20;
  std::string text;
  for (std::size_t i = 0; i < all.size() && i < kShown; ++i) {
    const std::string camera = nameOf(root, "cameras", all[i].camera);
    const std::string name = camera.empty() ? nameOf(root, "nodes", all[i].node) : camera;
    text += fmt::format("{}{}", text.empty() ? "" : ", ", all[i].camera);
    if (!name.empty()) text += " " + scene::quote(name);
  }
  if (text.empty()) return "the scene has no camera";
  return "the scene's cameras are " + text + (all.size() > kShown ? " and others" : "");
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& other) {
  const double length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : other;
}

/// From `eye` along `forward` to the depth of the box's centre; 1 if that is not in front.
double depthOf(const std::optional<Box>& bounds, const glm::dvec3& eye, const glm::dvec3& forward) {
  if (!bounds) return 1;
  const double depth = glm::dot((bounds->min + bounds->max) / 2.0 - eye, forward);
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

View viewOf(const Value& root, const NodeTree& nodes, const PlacedCamera& placed, const std::optional<Box>& bounds) {
  const Value camera = root.require("cameras")[placed.camera];
  const std::string name = nameOf(root, "cameras", placed.camera);
  return {cameraAt(camera, nodes.world(placed.node), bounds),
          fmt::format("camera {}{} of the file", placed.camera, name.empty() ? "" : " " + scene::quote(name))};
}

View framingView(const std::optional<Box>& bounds) { return {framingCamera(bounds), "a view that frames the model"}; }

}  // namespace

scene::Camera cameraAt(const Value& camera, const glm::dmat4& world, const std::optional<Box>& bounds) {
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

ViewAxes axesOf(const scene::Camera& camera) {
  const glm::dvec3 forward = glm::normalize(glm::dvec3(camera.at) - glm::dvec3(camera.from));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(camera.up)));
  return {right, glm::cross(right, forward), forward};
}

double coverageOf(const scene::Camera& camera, const Box& bounds) {
  const auto& [right, up, forward] = axesOf(camera);
  const glm::dvec3 centre = (bounds.min + bounds.max) / 2.0 - glm::dvec3(camera.from);
  const double radius = glm::length(bounds.max - bounds.min) / 2;
  if (glm::length(centre) <= radius) return 1;
  const double depth = glm::dot(centre, forward);
  if (depth <= 0) return depth > -radius ? 1 : 0;
  const double halfHeight = camera.orthographicHeight ? double{*camera.orthographicHeight} / 2
                                                      : depth * std::tan(radians(camera.angle) / 2);
  const double halfWidth = halfHeight * camera.width / camera.height;
  const bool isOutside = std::abs(glm::dot(centre, right)) - radius > halfWidth ||
                         std::abs(glm::dot(centre, up)) - radius > halfHeight;
  return isOutside ? 0 : std::min(1.0, std::numbers::pi * radius * radius / (4 * halfWidth * halfHeight));
}

scene::Camera framingCamera(const std::optional<Box>& bounds) {
  const glm::dvec3 centre = bounds ? (bounds->min + bounds->max) / 2.0 : glm::dvec3(0);
  const double radius = bounds ? glm::length(bounds->max - bounds->min) / 2 : 0;
  const double distance = kFramingMargin * (radius > 0 ? radius : 1) / std::sin(radians(kFramingAngle / 2));
  const double elevation = radians(kFramingElevation);
  scene::Camera view;
  view.at = glm::vec3(centre);
  view.from = glm::vec3(centre + distance * glm::dvec3(0, std::sin(elevation), std::cos(elevation)));
  view.angle = kFramingAngle;
  return view;
}

View chooseView(const Value& root, const NodeTree& nodes, const std::optional<std::string>& wish,
                const std::optional<Box>& bounds) {
  const std::vector<PlacedCamera> all = placedCameras(root, nodes);
  if (wish == "none") return framingView(bounds);
  if (!wish) return all.empty() ? framingView(bounds) : viewOf(root, nodes, all.front(), bounds);
  const auto found = std::ranges::find_if(all,
                                          [&](const PlacedCamera& placed) { return answers(root, placed, *wish); });
  if (found == all.end()) {
    throw FileError(
        fmt::format("no camera {}; {}; --camera none frames the model", scene::quote(*wish), listOf(root, all)));
  }
  return viewOf(root, nodes, *found, bounds);
}

}  // namespace candela::gltf
