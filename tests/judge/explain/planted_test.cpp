// A difference that is planted on one side is named with its vertex, its quantity and its size.
#include <catch2/catch.hpp>
#include <functional>

#include "host/judge/explain/explanation.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::explain;

namespace {

// Primitives: 0 light, 1 glass ball, 2 glossy ball, 3 another one far away, 4 and 5 floor. Materials are in the same
// order. None of the changes below needs another kernel.
const char* const kScene =
    "b 0.1 0.2 0.3\nv\nfrom 0 -9 3\nat 0 0 1\nup 0 0 1\nangle 40\nhither 0\nresolution 16 16\n"
    "f 1 1 1 1 0 0 0 0 1 0 1 12 11 10\ns 2 -1 6 1\n"
    "f 0.9 0.9 0.9 0 0 0 0 0 1 1 1.5 0 0 0\ns -1.2 0 1 1\n"
    "f 0.7 0.3 0.2 0.5 1 1 1 0.5 40 0 1 0 0 0\ns 1.2 0 1 1\ns 50 50 50 1\n"
    "f 0.8 0.7 0.6 1 0 0 0 0 1 0 1 0 0 0\np 4\n-8 -8 0\n8 -8 0\n8 8 0\n-8 8 0\n";
constexpr std::uint32_t kLamp = 0, kGlass = 1, kShiny = 2, kFarBall = 3, kFloor = 4;

using Change = std::function<void(scene::Scene&, render::RenderSettings&)>;
using Wanted = std::function<bool(const render::VertexTrace& first)>;

bool sees(const render::VertexTrace& vertex, std::uint32_t primitive) {
  return vertex.hit && vertex.hit->primitive == primitive;
}

bool seesLitFloor(const render::VertexTrace& vertex) {
  const bool floor = sees(vertex, kFloor) || sees(vertex, kFloor + 1);
  return floor && vertex.light && vertex.light->shadow == render::ShadowOutcome::visible;
}

render::RenderSettings testSettings() {
  render::RenderSettings settings = device::squareSettings(16, 1);
  settings.image.rouletteStart = 0;
  return settings;
}

// Returns a pixel whose first vertex meets a condition, by the reference.
render::PixelSample findPixel(const scene::Scene& scene, const render::RenderSettings& settings, const Wanted& wanted) {
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  for (std::uint32_t y = 0; y < settings.image.size.height; ++y) {
    for (std::uint32_t x = 0; x < settings.image.size.width; ++x) {
      const render::Replay replay = reference->replay(scene, settings, {x, y, 0});
      if (wanted(replay.path.vertices.front())) return {x, y, 0};
    }
  }
  FAIL("no pixel is as wanted");
  return {};
}

// Returns the explanation of such a pixel if one side, either one, has a changed scene or changed settings.
Explanation explainPlanted(const Wanted& wanted, const Change& change, bool onDevice) {
  const scene::Scene scene = device::sceneFromText(kScene);
  const render::RenderSettings settings = testSettings();
  REQUIRE(scene.primitives.size() == 6);
  const render::PixelSample pixel = findPixel(scene, settings, wanted);
  scene::Scene changedScene = scene;
  render::RenderSettings changedSettings = settings;
  change(changedScene, changedSettings);
  const auto replay = [&](render::Renderer& tracer, bool changed) {
    return tracer.replay(changed ? changedScene : scene, changed ? changedSettings : settings, pixel);
  };
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  return explainReplays(scene, settings, pixel, replay(device::testRenderer(), onDevice),
                        replay(*reference, !onDevice));
}

void requireFirst(const Wanted& wanted, const Change& change, const std::string& stage, const std::string& quantity) {
  const bool onDevice = GENERATE(true, false);
  const Explanation explanation = explainPlanted(wanted, change, onDevice);
  CAPTURE(onDevice, toText(explanation));
  REQUIRE(explanation.firstDifference);
  CHECK(explanation.stages[explanation.firstDifference->stage].title == stage);
  CHECK(explanation.at(*explanation.firstDifference).name == quantity);
}

}  // namespace

TEST_CASE("without a planted fault, no difference is reported") {
  const Explanation explanation = explainPlanted(
      seesLitFloor, [](scene::Scene&, render::RenderSettings&) {}, true);
  CAPTURE(toText(explanation));
  CHECK_FALSE(explanation.firstDifference);
  CHECK(explanation.furthestBefore);
}

TEST_CASE("a different albedo is reported where the surface is lit, with its size") {
  const auto brighter = [](scene::Scene& scene, render::RenderSettings&) {
    scene.materials[3].diffuse->colour *= 1.005f;
  };
  requireFirst(seesLitFloor, brighter, "vertex 1", "light adds");
  const Explanation explanation = explainPlanted(seesLitFloor, brighter, true);
  CHECK(explanation.at(*explanation.firstDifference).apart == Approx(0.005 / 1.005).epsilon(0.01));
}

TEST_CASE("a different radius is reported by the position") {
  requireFirst([](const render::VertexTrace& v) { return sees(v, kShiny); },
               [](scene::Scene& scene, render::RenderSettings&) { scene.spheres[kShiny].radius = 1.01f; }, "vertex 1",
               "position");
}

TEST_CASE("a different index of refraction is reported by the direction in the glass") {
  const auto refracts = [](const render::VertexTrace& v) {
    return sees(v, kGlass) && v.scattering && v.scattering->lobe == render::Lobe::refract;
  };
  requireFirst(
      refracts, [](scene::Scene& scene, render::RenderSettings&) { scene.materials[1].dielectric->ior = 1.51f; },
      "vertex 1", "direction");
}

TEST_CASE("a missing surface is reported by its primitive") {
  requireFirst(
      seesLitFloor,
      [](scene::Scene& scene, render::RenderSettings&) {
        for (scene::Mesh& mesh : scene.meshes) {
          for (glm::vec3& position : mesh.positions) position.z -= 1000;
        }
      },
      "vertex 1", "primitive");
}

TEST_CASE("a different material of a primitive is reported as such") {
  requireFirst([](const render::VertexTrace& v) { return sees(v, kShiny); },
               [](scene::Scene& scene, render::RenderSettings&) {
                 std::vector<scene::Primitive> primitives(scene.primitives.begin(), scene.primitives.end());
                 primitives.at(kShiny).material = 3;
                 scene.primitives = scene::PrimitiveList(primitives);
               },
               "vertex 1", "material");
}

TEST_CASE("a brighter light is reported where it is visible, and by its contribution") {
  const auto brighter = [](scene::Scene& scene, render::RenderSettings&) { scene.materials[0].emission *= 1.01f; };
  requireFirst(seesLitFloor, brighter, "vertex 1", "light adds");
}

TEST_CASE("a light at a different position is reported by the direction to it") {
  requireFirst(
      seesLitFloor, [](scene::Scene& scene, render::RenderSettings&) { scene.spheres[kLamp].centre.x += 0.05f; },
      "vertex 1", "light direction");
}

TEST_CASE("an occluder of the light is reported by the shadow ray") {
  const auto blocked = [](scene::Scene& scene, render::RenderSettings&) {
    scene.spheres[kFarBall] = {glm::vec3(2, -1, 4.2f), 0.6f};
  };
  const auto belowLamp = [](const render::VertexTrace& v) {
    return seesLitFloor(v) && glm::length(glm::dvec2(v.hit->position) - glm::dvec2(2, -1)) < 1;
  };
  requireFirst(belowLamp, blocked, "vertex 1", "shadow ray");
}

TEST_CASE("a different rule of roulette is reported as a decision") {
  requireFirst([](const render::VertexTrace& v) { return seesLitFloor(v) && v.roulette && v.roulette->survived; },
               [](scene::Scene&, render::RenderSettings& settings) { settings.image.rouletteStart = 5; }, "vertex 1",
               "roulette");
}

TEST_CASE("a different camera is reported by its ray, a different seed by the first random number") {
  requireFirst(
      seesLitFloor, [](scene::Scene& scene, render::RenderSettings&) { scene.camera->from.x += 0.1f; }, "camera",
      "ray origin");
  requireFirst(
      seesLitFloor, [](scene::Scene& scene, render::RenderSettings&) { scene.camera->angle += 0.1f; }, "camera",
      "ray direction");
  requireFirst(
      seesLitFloor, [](scene::Scene&, render::RenderSettings& settings) { settings.image.seed = 1; }, "camera",
      "filter x");
}

TEST_CASE("a difference at a later vertex is reported there") {
  // Off the shiny ball onto the floor, whose albedo differs: all up to there is equal.
  const auto viaBall = [](const render::VertexTrace& v) {
    return sees(v, kShiny) && v.scattering && v.scattering->direction.z < -0.5;
  };
  const bool onDevice = GENERATE(true, false);
  const Explanation explanation = explainPlanted(
      viaBall, [](scene::Scene& scene, render::RenderSettings&) { scene.materials[3].diffuse->colour *= 1.005f; },
      onDevice);
  CAPTURE(toText(explanation));
  REQUIRE(explanation.firstDifference);
  CHECK(explanation.stages[explanation.firstDifference->stage].title == "vertex 2");
  CHECK(explanation.reference.vertices[1].hit->material == 3);
}
