// The test of two films on actual renders: independent samples have the requested rate of false alarms, stratified
// samples a lower one.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/formats/nff/nff_loader.h"
#include "host/judge/verify/film_test.h"
#include "host/trace/reference/reference_renderer.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::verify {
namespace {

// A mirror ball and a floor under a light of this radiance. Rare paths hit the light via the mirror: fireflies.
scene::Scene ballUnderLamp(double strength) {
  const std::string lamp = std::to_string(strength);
  return scene::parseScene(
             "v\nfrom 0 -4 1\nat 0 0 0\nup 0 0 1\nangle 40\nhither 1\nresolution 16 16\n"
             "b 0.1 0.2 0.3\n"
             "f 0.9 0.9 0.9 0 1 1 1 1 1 0 1\ns 0 0 0 0.5\n"
             "f 0.8 0.6 0.4 1 0 0 0 0 1 0 1\np 4\n-3 -3 -0.5\n3 -3 -0.5\n3 3 -0.5\n-3 3 -0.5\n"
             "f 1 1 1 1 0 0 0 0 1 0 1 " +
                 lamp + " " + lamp + " " + lamp + "\ns 1 -1 2 0.4\n",
             "ball", ".")
      .scene;
}

image::Image render(const scene::Scene& scene, render::SamplerKind sampler, std::uint32_t seed) {
  static const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  render::RenderSettings settings = render::defaultSettings();
  settings.image.size = {16, 16};
  settings.image.sampleCount = 16;
  settings.image.sampler = sampler;
  settings.image.seed = seed;
  image::Image image = toImage(reference->render(scene, settings, {}).film);
  image.metadata[kSeedMetadata] = std::to_string(seed);
  return image;
}

struct Alarms {
  int count = 0;
  double deviation = 0;  ///< root mean square of the image means' z
};

Alarms alarmsOf(int pairs, render::SamplerKind sampler, double strength, double alpha) {
  const scene::Scene a = ballUnderLamp(strength);
  const scene::Scene b = ballUnderLamp(4);
  Alarms alarms;
  for (int i = 0; i < pairs; ++i) {
    const auto seed = static_cast<std::uint32_t>(2 * i);
    const FilmTestResult result = testFilms(render(a, sampler, seed), render(b, sampler, seed + 1), {.alpha = alpha});
    const double z = result.image().test.difference / result.image().test.standardError;
    alarms.count += result.differs() ? 1 : 0;
    alarms.deviation += z * z / pairs;
  }
  alarms.deviation = std::sqrt(alarms.deviation);
  return alarms;
}

TEST_CASE("the errors of independent samples agree with their variance") {
  const Alarms alarms = alarmsOf(80, render::SamplerKind::independent, 4, 0.05);
  INFO(alarms.count << " alarms, deviation " << alarms.deviation);
  CHECK(alarms.count <= 10);
  CHECK(alarms.deviation > 0.75);  // 1, give or take three standard errors of 80 pairs
  CHECK(alarms.deviation < 1.25);
}

TEST_CASE("the errors of stratified samples are smaller than estimated, so that the test is conservative") {
  for (const render::SamplerKind sampler : {render::SamplerKind::stratified, render::SamplerKind::sobol}) {
    const Alarms alarms = alarmsOf(40, sampler, 4, 0.05);
    INFO(alarms.count << " alarms, deviation " << alarms.deviation);
    CHECK(alarms.count <= 2);
    CHECK(alarms.deviation < 1);
  }
}

TEST_CASE("every sampler detects a light of twice the radiance") {
  for (const render::SamplerKind sampler :
       {render::SamplerKind::independent, render::SamplerKind::stratified, render::SamplerKind::sobol}) {
    CHECK(alarmsOf(10, sampler, 8, 1e-4).count == 10);
  }
}

}  // namespace
}  // namespace candela::verify
