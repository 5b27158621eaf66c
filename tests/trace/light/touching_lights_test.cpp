// Lights that touch surfaces: a surface must not hide the light that lies on it, on either tracer, near the origin and
// far from it. The light on the floor is compared with that of the floor alone, whose closed form closed_form_test.cpp
// knows.
#include "tests/trace/reference/touching_lights.h"

#include "host/judge/verify/agreement.h"
#include "tests/trace/light/added_lights.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::addPointLight;
using test::addSpotLight;
using test::SceneBuilder;
using test::Shifted;

namespace {

const std::vector<vec3> kShifts{{0, 0, 0}, {100000, -100000, 100000}};

// Direct light only.
render::RenderSettings directLight() {
  render::RenderSettings settings = squareSettings(32, 1);
  settings.image.maxDepth = 2;
  return settings;
}

scene::Scene sceneOf(const test::TouchedSurface* surface, const vec3& shift, const vec3& light,
                     const test::AddLight& addLight) {
  SceneBuilder b = test::floorUnder(shift);
  if (surface) surface->add({b, shift});
  addLight(b, light);
  return b.scene;
}

struct Comparison {
  int lit = 0;        // pixels that are not black
  int different = 0;  // those that differ from the film of the floor alone
};

Comparison compare(const image::Film& film, const image::Film& alone) {
  Comparison result;
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      const double seen = pixelLuminance(film, x, y), expected = pixelLuminance(alone, x, y);
      result.lit += seen > 0;
      result.different += std::abs(seen - expected) > 1e-4 * expected;
    }
  }
  return result;
}

void checkIlluminates(const RenderFunction& renderScene, const test::TouchedSurface& surface, const vec3& shift,
                      const test::AddLight& addLight, const render::RenderSettings& settings) {
  const vec3 light = surface.light + shift;
  CAPTURE(surface.name, shift.x);
  const image::Film alone = renderScene(sceneOf(nullptr, shift, light, addLight), settings).film;
  const Comparison touching = compare(renderScene(sceneOf(&surface, shift, light, addLight), settings).film, alone);
  CHECK(touching.lit == 32 * 32);
  CHECK(touching.different == 0);
}

// The surface that contains one light hides another one behind it: the film is that of the floor alone with the other
// light below it.
void checkHides(const RenderFunction& renderScene, const test::TouchedSurface& surface, const vec3& shift) {
  const vec3 touching = surface.light + shift;
  const vec3 behind = touching + 4 * test::marginNear(shift) * normalize(surface.inward);
  CAPTURE(surface.name, shift.x);
  const auto film = [&](const test::TouchedSurface* added, const vec3& hidden) {
    return renderScene(sceneOf(added, shift, touching,
                               [&](SceneBuilder& b, const vec3& light) {
                                 addPointLight(b, light);
                                 addPointLight(b, hidden);
                               }),
                       directLight())
        .film;
  };
  const Comparison hiding = compare(film(&surface, behind), film(nullptr, shift - vec3(0, 0, 8)));
  CHECK(hiding.lit > 32 * 32 / 3);
  CHECK(hiding.lit < 32 * 32 * 2 / 3);
  CHECK(hiding.different == 0);
}

const test::TouchedSurface& named(const std::vector<test::TouchedSurface>& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const auto& surface) { return surface.name == name; });
}

}  // namespace

TEST_CASE("a light in the plane of a wall illuminates the room in front of it") {
  const std::vector<test::TouchedSurface> all = test::touchedSurfaces();
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const vec3& shift : kShifts) {
      checkIlluminates(renderScene, named(all, "the plane of a wall"), shift, addPointLight, directLight());
      checkHides(renderScene, named(all, "the plane of a wall"), shift);
    }
  });
}

TEST_CASE("a light on an edge, in a corner, on a sphere, a cone, a box or a mesh illuminates everything in front of it",
          "[swiftshader-slow]") {
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const vec3& shift : kShifts) {
      for (const test::TouchedSurface& surface : test::touchedSurfaces())
        checkIlluminates(renderScene, surface, shift, addPointLight, directLight());
    }
  });
}

TEST_CASE("a light behind a surface by more than the margin is hidden", "[swiftshader-slow]") {
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const vec3& shift : kShifts) {
      for (const test::TouchedSurface& surface : test::touchedSurfaces()) checkHides(renderScene, surface, shift);
    }
  });
}

TEST_CASE("spot lights and the point lights of Whitted's tracer have the margin, too", "[swiftshader-slow]") {
  const std::vector<test::TouchedSurface> all = test::touchedSurfaces();
  render::RenderSettings whitted = directLight();
  whitted.image.integrator = render::Integrator::whitted;
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const char* name : {"the plane of a wall", "a sphere", "a vertex of a mesh"}) {
      checkIlluminates(renderScene, named(all, name), kShifts[0], addSpotLight, directLight());
      checkIlluminates(renderScene, named(all, name), kShifts[0], addPointLight, whitted);
    }
  });
}

TEST_CASE("an area light in the plane of a ceiling illuminates the room below it, and one above it does not",
          "[swiftshader-slow]") {
  const auto ceilings = std::vector<std::pair<std::string, std::function<void(const Shifted&)>>>{
      {"quad", test::addCeiling},
      {"box",
       [](const Shifted& s) {
         s.builder.box(s.at({-4, -4, 4}), s.at({4, 4, 5}));
       }},
      {"plane",
       [](const Shifted& s) {
         s.builder.plane(s.at({0, 0, 4}), s.at({0, 1, 4}), s.at({1, 0, 4}));
       }},
      {"huge sphere", [](const Shifted& s) {
         s.builder.sphere(s.at({0, 0, 100004}), 100000);
       }}};
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const auto& [name, addCeiling] : ceilings) {
      const auto render = [&, add = addCeiling](bool hasCeiling, float height) {
        SceneBuilder b = test::floorUnder(vec3(0));
        if (hasCeiling) add({b, vec3(0)});
        b.material(test::diffuseMaterial(vec3(0), {1, 2, 3}));
        b.triangle({-0.0625f, 0, height}, {0, 0.0625f, height}, {0.0625f, 0, height});
        return renderScene(b.scene, directLight()).film;
      };
      CAPTURE(name);
      const Comparison flush = compare(render(true, 4), render(false, 4));
      CHECK(flush.lit == 32 * 32);
      CHECK(flush.different == 0);
      CHECK(meanLuminance(render(true, 4 + 4 * test::marginNear(vec3(0)))) == 0);
    }
  });
}

TEST_CASE("a light on the far side of a ball or a cylinder is hidden", "[swiftshader-slow]") {
  const std::vector<test::TouchedSurface> all = test::touchedSurfaces();
  onBothTracers([&](const RenderFunction& renderScene) {
    for (const vec3& shift : kShifts) {
      for (const char* name : {"a sphere", "a cylinder"}) {
        CAPTURE(name, shift.x);
        const vec3 top = vec3(0.5f, 0.25f, 4.25f) + shift;
        const scene::Scene scene = sceneOf(&named(all, name), shift, top, addPointLight);
        CHECK(meanLuminance(renderScene(scene, directLight()).film) == 0);
      }
    }
  });
}

TEST_CASE("a small panel illuminates a large floor from its light in a distance of thousands of its size",
          "[swiftshader-slow]") {
  // The panel's own coordinates are so small that the rounding of distances is 16 times the margin.
  const vec3 shift(0, 0, -4);
  onBothTracers([&](const RenderFunction& renderScene) {
    const auto film = [&](bool hasPanel) {
      SceneBuilder b = test::floorUnder(shift);
      constexpr float kHalfSide = 0x1p-10f;
      if (hasPanel)
        b.quad({-kHalfSide, -kHalfSide, 0}, {-kHalfSide, kHalfSide, 0}, {kHalfSide, kHalfSide, 0},
               {kHalfSide, -kHalfSide, 0});
      addPointLight(b, vec3(0));
      return renderScene(b.scene, directLight()).film;
    };
    const Comparison panel = compare(film(true), film(false));
    CHECK(panel.lit == 32 * 32);
    CHECK(panel.different == 0);
  });
}

namespace {

// Returns how many of 64 pixels of a panel the light illuminates. The panel is in front of the surface, at the distance
// 2 from the light.
int litPixels(const RenderFunction& renderScene, const std::function<void(SceneBuilder&)>& addSurface,
              const glm::dvec3& light, const glm::dvec3& normal) {
  const glm::dvec3 front = glm::normalize(normal);
  const glm::dvec3 u = glm::normalize(glm::cross(front, glm::dvec3(0.3, 0.5, -0.4)));
  const glm::dvec3 v = glm::cross(front, u);
  const auto at = [&](double x, double y, double height) { return vec3(light + x * u + y * v + height * front); };
  SceneBuilder b;
  b.view(at(0, 0, 1), at(0, 0, 2), vec3(u), 40);
  b.material(test::diffuseMaterial(vec3(0.8f))).quad(at(-1, -1, 2), at(1, -1, 2), at(1, 1, 2), at(-1, 1, 2));
  addSurface(b);
  addPointLight(b, vec3(light));
  render::RenderSettings settings = directLight();
  settings.image.size = {8, 8};
  return compare(renderScene(b.scene, settings).film, image::Film(8, 8)).lit;
}

}  // namespace

TEST_CASE("the margin of a plane has the coordinates of the light, and that of a triangle those of its vertices") {
  const auto on = [](double x, double y) { return glm::dvec3(x, y, 0.3 * x - 0.2 * y); };
  const glm::dvec3 normal(-0.3, 0.2, 1);
  onBothTracers([&](const RenderFunction& renderScene) {
    for (int i = 0; i < 12; ++i) {
      CAPTURE(i);
      const auto addPlane = [&](SceneBuilder& b) { b.plane(vec3(0), vec3(on(1, 0)), vec3(on(0, 1))); };
      CHECK(litPixels(renderScene, addPlane, on(1000.3 + 7.1 * i, 507.7 - 3.3 * i), normal) == 64);
      const auto addTriangle = [&](SceneBuilder& b) {
        b.triangle(vec3(on(-1000.1, -907.7 - i)), vec3(on(1100.3, -807.1)), vec3(on(3.3 * i, 1207.9)));
      };
      CHECK(litPixels(renderScene, addTriangle, on(0.13 + 0.1 * i, 0.07 * i), normal) == 64);
    }
  });
}

TEST_CASE("the margin of an oblique surface is that of its axes, and the margin of a cone is along its normal") {
  const auto addOblique = [](SceneBuilder& b) { b.triangle({9, -3, -3}, {-3, 9, -3}, {-3, -3, 9}); };
  const auto addCone = [](SceneBuilder& b) { b.cone({0, 0, -4}, 8, {0, 0, 0}, 0); };
  onBothTracers([&](const RenderFunction& renderScene) {
    // |n.x| + |n.y| + |n.z| = 1.73, and the largest coordinate is 9.
    const auto depth = [](double margins) { return glm::dvec3(1) * (1 - margins * 9 * 0x1p-19 / std::sqrt(3.0)); };
    CHECK(litPixels(renderScene, addOblique, depth(1.4), glm::dvec3(1)) == 64);
    CHECK(litPixels(renderScene, addOblique, depth(2.2), glm::dvec3(1)) == 0);
    // The slope is 2, and the largest coordinate plus the radius is 12.
    const auto radius = [](double margins) { return glm::dvec3(2 - margins * 12 * 0x1p-19, 0, -1); };
    CHECK(litPixels(renderScene, addCone, radius(1.7), {1, 0, 2}) == 64);
    CHECK(litPixels(renderScene, addCone, radius(2.8), {1, 0, 2}) == 0);
  });
}

namespace {

// A room whose walls are polygons at x, y = +-4, with a ball and a box, lit by lights on a wall, in a corner and on the
// ball, and by a panel in the ceiling.
scene::Scene room() {
  SceneBuilder b = test::floorUnder(vec3(0));
  const Shifted here{b, vec3(0)};
  b.material(test::diffuseMaterial({0.7f, 0.5f, 0.4f}));
  test::addWallInX(here), test::addWallInY(here), test::addCeiling(here);
  here.quad({4, -4, 0}, {4, -4, 4}, {4, 4, 4}, {4, 4, 0});
  here.quad({-4, 4, 0}, {4, 4, 0}, {4, 4, 4}, {-4, 4, 4});
  b.material(test::mixtureMaterial(0.5f, 0.4f, 30)).sphere({1, 2, 1.25f}, 1.25f).box({-2, 1, 0}, {-1, 2, 1.5f});
  b.cone({-2.5f, -2, 0}, 0.5f, {-2.5f, -2, 2}, 0.25f);
  b.material(test::diffuseMaterial(vec3(0), vec3(40)));
  b.triangle({0, 0, 4}, {0, 0.5f, 4}, {0.5f, 0, 4});
  b.pointLight({1.5f, -4, 2}, vec3(1)).pointLight({-4, -4, 0}, vec3(0.5f)).pointLight({1, 1.25f, 2.25f}, vec3(0.5f));
  b.pointLight({-1.5f, 1.5f, 1.5f}, vec3(0.5f)).pointLight({-2.5f, -2.375f, 1}, vec3(0.25f));
  b.view({0, -2, 2}, {0.5f, 4, 1}, {0, 0, 1}, 75);
  b.scene.name = "room";
  return b.scene;
}

}  // namespace

TEST_CASE("a room with lights on its surfaces has the reference's pixels") {
  render::RenderSettings settings = squareSettings(64, 1);
  settings.execution.recordPaths = true;
  const verify::PixelAgreement pixels = verify::comparePixels(renderOnDevice(room(), settings),
                                                              renderOnReference(room(), settings));
  CAPTURE(pixels.causes, pixels.worst, pixels.worstX, pixels.worstY);
  CHECK(pixels.lit > pixels.pixels / 2);
  CHECK(pixels.equalFraction() > kRequiredEqualFraction);
  CHECK(pixels.causes[static_cast<std::size_t>(verify::Cause::shadow)] <= 2);
}

TEST_CASE("every kernel and structure gives the same film of lights on surfaces", "[swiftshader-slow]") {
  using render::AccelKind;
  render::RenderSettings settings = squareSettings(48, 2);
  const std::uint64_t expected = renderOnDevice(room(), settings).film.hash();
  for (const render::KernelKind kernel : {render::KernelKind::megakernel, render::KernelKind::wavefront}) {
    for (const AccelKind accel : {AccelKind::none, AccelKind::grid, AccelKind::bvh}) {
      for (const render::BvhLayout layout : {render::BvhLayout::bvh2, render::BvhLayout::cwbvh}) {
        if (accel != AccelKind::bvh && layout == render::BvhLayout::cwbvh) continue;
        settings.execution.kernel = kernel;
        settings.structure.accel = accel;
        settings.structure.bvhLayout = layout;
        CAPTURE(static_cast<int>(kernel), static_cast<int>(accel), static_cast<int>(layout));
        CHECK(renderOnDevice(room(), settings).film.hash() == expected);
      }
    }
  }
}
