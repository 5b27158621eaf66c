// Pictures whose exact values are known independently of both tracers.
#include <catch2/catch.hpp>
#include <numbers>

#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;

namespace {

// A closed sphere, seen from inside, whose surface has albedo `albedo` and emission 1.
scene::Scene furnace(const std::string& albedo) {
  return sceneFromText("v\nfrom 0 0 0\nat 0 0 -1\nup 0 1 0\nangle 60\nhither 0\nresolution 16 16\nf " + albedo + " " +
                       albedo + " " + albedo + " 1 0 0 0 0 1 0 1 1 1 1\ns 0 0 0 3\n");
}

// Without roulette every path has the exact value, except for the light beyond the maximum depth: 0.8^100 = 2e-10.
render::RenderSettings withoutRoulette(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = squareSettings(side, samples);
  settings.image.maxDepth = 100;
  settings.image.rouletteStart = 100;
  return settings;
}

}  // namespace

TEST_CASE("a furnace of albedo a shows 1 / (1 - a)") {
  const auto [text, albedo] = GENERATE(table<std::string, double>({{"0.2", 0.2}, {"0.5", 0.5}, {"0.8", 0.8}}));
  const bool nextEventEstimation = GENERATE(true, false);
  onBothTracers([&, text = text, albedo = albedo](const RenderFunction& renderScene) {
    render::RenderSettings settings = withoutRoulette(8, nextEventEstimation ? 64 : 4);
    settings.image.nextEventEstimation = nextEventEstimation;
    const double mean = meanLuminance(renderScene(furnace(text), settings).film);
    CAPTURE(albedo, nextEventEstimation);
    CHECK(mean == Approx(1 / (1 - albedo)).epsilon(1e-3));
  });
}

TEST_CASE("the furnace scene shows 2") {
  onBothTracers([&](const RenderFunction& renderScene) {
    const scene::Scene scene = loadTestScene("furnace.p3f");
    CHECK(meanLuminance(renderScene(scene, withoutRoulette(16, 16)).film) == Approx(2).epsilon(1e-3));
  });
}

TEST_CASE("Russian roulette preserves the mean 2 of the furnace scene", "[slow]") {
  onBothTracers([&](const RenderFunction& renderScene) {
    const scene::Scene scene = loadTestScene("furnace.p3f");
    CHECK(meanLuminance(renderScene(scene, squareSettings(64, 256)).film) == Approx(2).epsilon(1e-3));
  });
}

TEST_CASE("a spherical light over a plane gives the closed-form irradiance") {
  // Albedo 1/2, radiance 8, radius 1/2, height 2: a L (R/d)^2 = 1/4 at the foot, where the middle pixel looks.
  scene::Scene scene = loadTestScene("lamp_over_plane.p3f");
  scene.camera->angle = 0.05f;
  onBothTracers([&](const RenderFunction& renderScene) {
    const image::Film film = renderScene(scene, squareSettings(8, 1024)).film;
    CHECK(meanLuminance(film) == Approx(0.25).epsilon(2e-3));
  });
}

TEST_CASE("a point light shows Kd Lc cd cos on a diffuse plane") {
  // cos = 3/5 at the origin; Kd is 1, cd (0.8, 0.5, 0.25), Lc (1, 2, 3).
  const scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 0.01\nhither 0\nresolution 4 4\nl 4 0 3 1 2 3\n"
      "f 0.8 0.5 0.25 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\n");
  const bool nextEventEstimation = GENERATE(true, false);
  onBothTracers([&](const RenderFunction& renderScene) {
    render::RenderSettings settings = squareSettings(4, 4);
    settings.image.nextEventEstimation = nextEventEstimation;
    const glm::dvec3 mean = renderScene(scene, settings).film.mean(2, 2);
    CHECK(mean.x == Approx(0.8 * 1 * 0.6).epsilon(1e-3));
    CHECK(mean.y == Approx(0.5 * 2 * 0.6).epsilon(1e-3));
    CHECK(mean.z == Approx(0.25 * 3 * 0.6).epsilon(1e-3));
  });
}

TEST_CASE("a lamp gives its light beside a hidden sun of a billion times its power") {
  // The sun shines from below the plane: 0.5 / pi * 64 cd / (4 m)^2 is the lamp's light alone.
  scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 0.01\nhither 0\nresolution 32 32\n"
      "f 0.5 0.5 0.5 1 0 0 0 0 1 0 1 0 0 0\npl 0 0 0 1 0 0 0 1 0\n");
  using Kind = scene::PunctualLight::Kind;
  scene.punctualLights = {
      {.kind = Kind::point, .position = {0, 0, 4}, .intensity = glm::vec3(64)},
      {.kind = Kind::directional, .direction = {0, 0, 1}, .intensity = glm::vec3(1e5f), .reach = 800}};
  onBothTracers([&](const RenderFunction& renderScene) {
    const double mean = meanLuminance(renderScene(scene, squareSettings(32, 64)).film);
    CHECK(mean == Approx(2 / std::numbers::pi).epsilon(0.05));
  });
}

TEST_CASE("a lens of radius 0 is a pinhole, bit for bit") {
  scene::Scene scene = loadTestScene("depth_of_field.p3f");
  scene.camera->aperture = 0;
  scene.camera->focal = 1;
  onBothTracers([&](const RenderFunction& renderScene) {
    const render::RenderSettings settings = squareSettings(48, 4);
    const std::uint64_t pinhole = renderScene(scene, settings).film.hash();
    scene::Scene refocused = scene;
    refocused.camera->focal = 0.37f;
    render::RenderSettings square = settings;
    square.image.lens = render::LensKind::square;
    CHECK(renderScene(refocused, square).film.hash() == pinhole);
    refocused.camera->aperture = 1e-30f;  // the lens is compiled in and has no width
    CHECK(renderScene(refocused, square).film.hash() == pinhole);
  });
}
