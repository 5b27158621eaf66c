// Samples that single precision can decide are equal on device and reference, in scenes of every kind; and the rounding
// of replicas covers the device's.
#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "host/judge/verify/agreement.h"
#include "tests/scene/generate/generated_text.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

struct OddCounts {
  std::uint64_t device = 0;
  std::uint64_t all = 0;
};

// Adds the odd participants of one scene. The seeds are fixed, so that the result is deterministic.
void addScene(const scene::Scene& scene, render::RenderSettings settings, OddCounts& counts) {
  settings.image.oneSided = scene.name == "mirror.p3f";  // its camera looks through the back of a wall
  const auto reference = reference::makeReferenceRenderer();
  verify::PathRenders renders;
  const auto pixels = verify::comparePaths(scene, settings, testRenderer(), *reference, 1e-4, {}, renders);
  REQUIRE(pixels);
  INFO(scene.name << ": " << pixels->decisions.text());
  CHECK(pixels->decisions.isPossible);
  CHECK(pixels->decisions.agrees());
  counts.device += pixels->decisions.oddDevice;
  counts.all += pixels->decisions.odd;
}

render::RenderSettings settingsOf(render::Integrator integrator) {
  render::RenderSettings settings = squareSettings(64, 1);
  settings.image.integrator = integrator;
  settings.image.maxDepth = render::defaultMaxDepth(integrator);
  return settings;
}

}  // namespace

TEST_CASE("samples that single precision can decide are equal in every scene, by paths", "[swiftshader-slow]") {
  OddCounts counts;
  for (const auto& file : sceneFiles()) {
    addScene(formats::loadScene(file).scene, settingsOf(render::Integrator::path), counts);
  }
  INFO(counts.device << " of " << counts.all);
  CHECK(3 * counts.device <= counts.all);
}

TEST_CASE("the resolution of a film with a scale is no difference of a device") {
  // In multiples of 1/16, most samples differ from those of replicas by several per cent.
  render::RenderSettings settings = settingsOf(render::Integrator::path);
  settings.image.filmScale = 36;
  OddCounts counts;
  addScene(loadTestScene("cornell.p3f"), settings, counts);
  CHECK(counts.device == 0);
}

TEST_CASE("samples that single precision can decide are equal in generated scenes that amplify rounding or coincide",
          "[slow]") {
  const auto integrator = GENERATE(render::Integrator::path, render::Integrator::whitted);
  OddCounts counts;
  for (const auto& [kind, size] : {std::pair("balls", 3u),
                                   {"jacks", 3u},
                                   {"lattice", 3u},
                                   {"rings", 2u},
                                   {"teapot", 1u},
                                   {"teapot", 2u},
                                   {"shells", 2u},
                                   {"mount", 3u},
                                   {"tree", 3u},
                                   {"cornell", 2u}}) {
    addScene(generatedScene(kind, size).scene, settingsOf(integrator), counts);
  }
  INFO(counts.device << " of " << counts.all);
  CHECK(3 * counts.device <= counts.all + 3);
}
