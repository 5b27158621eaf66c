// The numbers of rays that Haines published with his databases (README of the Standard Procedural Databases): 513 x 513
// rays through the corners of pixels, trees of depth 5. He expects tracers to differ by up to 10 %; these tests require
// 4 %.
#include <catch2/catch.hpp>
#include <vector>

#include "tests/scene/generate/generated_text.h"
#include "tests/trace/render/render_support.h"

using namespace candela;
using namespace candela::device;

namespace {

struct PublishedCounts {
  const char* kind;
  std::uint32_t size;
  std::uint64_t eyeHits;
  std::uint64_t reflected;
  std::uint64_t refracted;
  std::uint64_t shadow;
};

const std::vector<PublishedCounts> kPublished{{"balls", 4, 263169, 175095, 0, 954368},
                                              {"mount", 6, 173125, 354769, 354769, 412922},
                                              {"tetra", 6, 49788, 0, 0, 46112},
                                              {"rings", 7, 263169, 315236, 0, 1085002},
                                              {"gears", 4, 245086, 304643, 207564, 2246955},
                                              {"tree", 11, 169836, 0, 0, 1097419},
                                              {"teapot", 6, 161120, 225248, 0, 407656}};

render::RenderSettings hainesSettings() {
  render::RenderSettings settings = squareSettings(513, 1);
  settings.image.integrator = render::Integrator::whitted;
  settings.image.pixelOrigin = render::PixelOrigin::corner;
  settings.image.maxDepth = 5;
  return settings;
}

void requireNear(std::uint64_t count, std::uint64_t published) {
  CHECK(static_cast<double>(count) == Approx(static_cast<double>(published)).epsilon(0.04));
}

void requirePublishedCounts(const render::RenderStatistics& statistics, const PublishedCounts& published) {
  CAPTURE(published.kind, statistics.device);
  requireNear(statistics.treeRays->cameraHits, published.eyeHits);
  requireNear(statistics.treeRays->reflected, published.reflected);
  requireNear(statistics.treeRays->refracted, published.refracted);
  requireNear(statistics.shadowRays, published.shadow);
}

}  // namespace

TEST_CASE("the tetrahedron takes the numbers of rays that Haines published, on both tracers") {
  const scene::Scene scene = generatedScene(kPublished[2].kind, kPublished[2].size).scene;
  requirePublishedCounts(renderOnDevice(scene, hainesSettings()).statistics, kPublished[2]);
  requirePublishedCounts(renderOnReference(scene, hainesSettings()).statistics, kPublished[2]);
}

TEST_CASE("every database takes the numbers of rays that Haines published, on both tracers", "[slow]") {
  for (const PublishedCounts& published : kPublished) {
    const scene::Scene scene = generatedScene(published.kind, published.size).scene;
    const render::RenderStatistics device = renderOnDevice(scene, hainesSettings()).statistics;
    const render::RenderStatistics reference = renderOnReference(scene, hainesSettings()).statistics;
    requirePublishedCounts(device, published);
    requirePublishedCounts(reference, published);
    CHECK(static_cast<double>(device.bounceRays) == Approx(static_cast<double>(reference.bounceRays)).epsilon(1e-3));
    CHECK(static_cast<double>(device.shadowRays) == Approx(static_cast<double>(reference.shadowRays)).epsilon(1e-3));
  }
}
