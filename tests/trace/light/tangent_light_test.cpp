// Lights on curved and closed surfaces, seen from both sides of their tangent planes: what is in front of the plane is
// lit, and what is behind it is dark, near the origin and far from it.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "tests/trace/light/added_lights.h"
#include "tests/trace/reference/touching_lights.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::addPointLight;
using test::addSpotLight;
using test::SceneBuilder;
using test::Shifted;

namespace {

constexpr std::uint32_t kSide = 32;
const glm::dvec3 kNormal = glm::dvec3(6, 2, 3) / 7.0;  // of the tangent plane, outward
constexpr float kRadius = 1.75f;
const vec3 kCentre(-3.5f, -3, 4);
// On the upper side, towards which origins on the floor are moved.
const vec3 kLight = kCentre + vec3(1.5f, 0.5f, 0.75f);

struct Body {
  const char* name;
  void (*add)(const Shifted&);
};

// Each contains kLight and is behind the plane through it.
const Body kBodies[] = {
    {"a sphere", [](const Shifted& s) { s.builder.sphere(s.at(kCentre), kRadius); }},
    {"a cylinder",
     [](const Shifted& s) {
       const vec3 axis(2, -6, 0);
       s.builder.cone(s.at(kCentre - axis), kRadius, s.at(kCentre + axis), kRadius);
     }},
    {"a mesh", [](const Shifted& s) {
       const vec3 across(0.5625f, 0.1875f, -1.25f), along(0.5f, -1.5f, 0);
       const vec3 corners[] = {kLight + along + across, kLight - along + across, kLight - 2.0f * across};
       for (int i = 0; i < 3; ++i) s.triangle(kCentre, corners[i], corners[(i + 1) % 3]);
       s.triangle(corners[0], corners[1], corners[2]);
     }}};

scene::Scene sceneOf(const Body* body, const vec3& shift, const test::AddLight& addLight) {
  SceneBuilder b = test::floorUnder(shift);
  if (body) body->add({b, shift});
  addLight(b, kLight + shift);
  return b.scene;
}

// Returns the point of the floor at the centre of a pixel, without the shift.
glm::dvec3 floorPoint(const scene::Camera& camera, const vec3& shift, std::uint32_t x, std::uint32_t y) {
  const double side = 2 * std::tan(149 * std::numbers::pi / 360);
  const glm::dvec3 below = glm::dvec3(camera.at) - glm::dvec3(shift);
  return below + side * glm::dvec3((x + 0.5) / kSide - 0.5, 0.5 - (y + 0.5) / kSide, 0);
}

struct Seen {
  int lit = 0, dark = 0;  // pixels that are, as they have to be
  int wrong = 0;
};

Seen look(const RenderFunction& renderScene, const Body& body, const vec3& shift, const test::AddLight& addLight,
          const render::RenderSettings& settings) {
  const image::Film alone = renderScene(sceneOf(nullptr, shift, addLight), settings).film;
  const scene::Scene scene = sceneOf(&body, shift, addLight);
  const image::Film film = renderScene(scene, settings).film;
  const double rounding = 0x1p-20 * (8 + std::abs(double{shift.x}));  // of a point of the floor
  Seen seen;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x) {
      const double height = dot(kNormal, floorPoint(*scene.camera, shift, x, y) - glm::dvec3(kLight));
      if (std::abs(height) < rounding) continue;
      const double value = pixelLuminance(film, x, y), full = pixelLuminance(alone, x, y);
      const bool isRight = height > 0 ? std::abs(value - full) <= 1e-4 * full && value > 0 : value == 0;
      ++(!isRight ? seen.wrong : height > 0 ? seen.lit : seen.dark);
    }
  }
  return seen;
}

void checkBodies(render::Integrator integrator, render::KernelKind kernel, const test::AddLight& addLight) {
  render::RenderSettings settings = squareSettings(kSide, 1);
  settings.image.maxDepth = 2;
  settings.image.antialiasing = false;
  settings.image.integrator = integrator;
  settings.execution.kernel = kernel;
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const float distance : {0.0f, 1e3f, 1e4f, 1e5f}) {
      for (const Body& body : kBodies) {
        CAPTURE(body.name, distance);
        const Seen seen = look(renderScene, body, {distance, -distance, distance}, addLight, settings);
        CHECK(seen.wrong == 0);
        CHECK(seen.lit > 200);
        CHECK(seen.dark > 200);
      }
    }
  });
}

}  // namespace

TEST_CASE("a point light on a body illuminates what is in front of its tangent plane, and nothing behind it",
          "[swiftshader-slow]") {
  checkBodies(render::Integrator::path, render::KernelKind::megakernel, addPointLight);
}

TEST_CASE("a spot light on a body illuminates what is in front of its tangent plane, by the wavefront kernel, too",
          "[swiftshader-slow]") {
  checkBodies(render::Integrator::path, render::KernelKind::wavefront, addSpotLight);
}

TEST_CASE("Whitted's tracer illuminates what is in front of the tangent plane of a light on a body",
          "[swiftshader-slow]") {
  checkBodies(render::Integrator::whitted, render::KernelKind::megakernel, addPointLight);
}
