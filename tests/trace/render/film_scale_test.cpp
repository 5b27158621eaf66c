// Films of scenes with strong lights: nothing is cut, and a scale is only another unit.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <numbers>

#include "host/trace/render/request.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::SceneBuilder;

namespace {

using Kind = scene::PunctualLight::Kind;

scene::Material surface(const scene::SurfaceParameters& parameters) {
  scene::Material material;
  material.surface = parameters;
  return material;
}

scene::Material metal(float roughness) { return surface({.metalness = 1, .roughness = roughness}); }

// The settings that a render of the command line has.
render::RenderSettings resolved(const scene::Scene& scene, std::uint32_t side, std::uint32_t samples) {
  render::RenderRequest request;
  request.sampleCount = samples;
  request.size = render::Extent{side, side};
  return resolve(request, scene);
}

// A square that fills the picture, lit and seen from its normal.
scene::Scene facingSquare(const scene::Material& material, float irradiance) {
  SceneBuilder b;
  b.material(material).view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.001f);
  b.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  b.scene.punctualLights = {{.kind = Kind::directional, .direction = {0, 0, -1}, .intensity = vec3(irradiance)}};
  return b.scene;
}

// Every kind of light that has a strength, and every kind of value that a film stores. `unit` divides the light.
scene::Scene manyLights(float unit) {
  SceneBuilder b;
  b.material(surface({.baseColour = {0.6f, 0.5f, 0.4f}, .roughness = 0.4f}))
      .quad({-4, -4, -1}, {4, -4, -1}, {4, 4, -1}, {-4, 4, -1});
  b.material(metal(0.05f)).quad({-1, -0.4f, 0}, {1, -0.4f, 0}, {1, 1, 1.5f}, {-1, 1, 1.5f});
  b.material(test::diffuseMaterial(vec3(0.5f), vec3(3e6f, 1e6f, 2e5f) / unit)).sphere({-1.5f, 1, 1}, 0.3f);
  b.view({0, -4, 4}, {0, 0, 0}, {0, 0, 1}, 40);
  b.scene.background = vec3(200, 300, 500) / unit;
  b.scene.punctualLights = {{.kind = Kind::directional,
                             .direction = {0, 0.6f, -0.8f},
                             .intensity = vec3(1e5f, 9e4f, 7e4f) / unit,
                             .reach = 4},
                            {.kind = Kind::point, .position = {1, 2, 3}, .intensity = vec3(4e5f, 1e5f, 3e5f) / unit}};
  b.scene.pointLights = {{.position = {2, -3, 5}, .colour = vec3(4000, 3000, 1000) / unit}};
  return b.scene;
}

render::RenderSettings withLayers(const scene::Scene& scene) {
  render::RenderSettings settings = resolved(scene, 24, 16);
  for (const image::Layer layer :
       {image::Layer::albedo, image::Layer::direct, image::Layer::indirect, image::Layer::moments}) {
    settings.image.layers.add(layer);
  }
  return settings;
}

template <class T>
bool haveEqualBytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

}  // namespace

TEST_CASE("a diffuse surface in the sun shows its closed form, whatever the unit of light") {
  const float lux = GENERATE(1e5f, 1e6f, 1e9f);
  const scene::Scene scene = facingSquare(test::diffuseMaterial(vec3(0.5f)), lux);
  onBothTracers([&](const RenderFunction& render) {
    const render::RenderResult result = render(scene, resolved(scene, 4, 16));
    CHECK(result.film.scale() > 0);
    CHECK(result.statistics.badSamples == 0);
    CHECK(meanLuminance(result.film) == Approx(0.5 * std::numbers::inv_pi * lux).epsilon(1e-5));
    CHECK(result.film.luminanceVariance(1, 1) < 1e-6 * std::pow(meanLuminance(result.film), 2));
  });
}

TEST_CASE("highlights of smooth metal in the sun are not cut") {
  // GGX at normal incidence: F D / 4 with D = 1 / (pi alpha^2), and the little that multiple scattering adds.
  constexpr float kLux = 1e5f;
  const float roughness = GENERATE(0.05f, 0.02f);
  const scene::Scene scene = facingSquare(metal(roughness), kLux);
  const double expected = kLux / (4 * std::numbers::pi * std::pow(roughness, 4));
  REQUIRE(expected > 1000 * image::kFilmMaximum);
  onBothTracers([&](const RenderFunction& render) {
    const render::RenderResult result = render(scene, resolved(scene, 4, 16));
    CHECK(result.statistics.badSamples == 0);
    CHECK(meanLuminance(result.film) == Approx(expected).epsilon(2e-3));
    render::RenderSettings unscaled = resolved(scene, 4, 16);
    unscaled.image.filmScale = 0;
    CHECK(meanLuminance(render(scene, unscaled).film) == Approx(image::kFilmMaximum));
  });
}

TEST_CASE("the film of scale k is that of the lights divided by 2^k, bit for bit", "[swiftshader-slow]") {
  const scene::Scene strong = manyLights(1);
  const render::RenderSettings settings = withLayers(strong);
  const std::uint32_t scale = settings.image.filmScale;
  REQUIRE(scale > 15);
  const scene::Scene weak = manyLights(std::ldexp(1.0f, static_cast<int>(scale)));
  const render::RenderSettings plain = withLayers(weak);
  REQUIRE(plain.image.filmScale == 0);
  onBothTracers([&](const RenderFunction& render) {
    const image::Film scaled = render(strong, settings).film;
    const image::Film expected = render(weak, plain).film;
    CHECK(haveEqualBytes(scaled.pixels(), expected.pixels()));
    CHECK(haveEqualBytes(scaled.layerRows(), expected.layerRows()));
    CHECK(scaled.scale() == scale);
    CHECK(meanLuminance(scaled) == std::ldexp(meanLuminance(expected), static_cast<int>(scale)));
    CHECK(scaled.hash() != expected.hash());
  });
}

TEST_CASE("the wavefront kernel scales its samples, too", "[swiftshader-slow]") {
  const scene::Scene scene = manyLights(1);
  render::RenderSettings settings = withLayers(scene);
  const image::Film film = renderOnDevice(scene, settings).film;
  settings.execution.kernel = render::KernelKind::wavefront;
  const image::Film waves = renderOnDevice(scene, settings).film;
  CHECK(haveEqualBytes(film.pixels(), waves.pixels()));
  CHECK(haveEqualBytes(film.layerRows(), waves.layerRows()));
}

TEST_CASE("the scale raises the limit of a sample to 2^(20+k), also in views and by Whitted's tracer") {
  const scene::Scene scene = sceneFromText(
      "v\nfrom 0 0 5\nat 0 0 0\nup 0 1 0\nangle 1\nhither 0\nresolution 4 4\nl 0 0 5 2e8 1e8 1e8\n"
      "f 1 1 1 1 0 0 0 0 1 0 1\ns 0 0 -4e6 1\np 4\n-9e6 -9e6 -4e6\n9e6 -9e6 -4e6\n9e6 9e6 -4e6\n-9e6 9e6 -4e6\n");
  const auto [integrator, value] = GENERATE(
      table<render::Integrator, double>({{render::Integrator::depth, 4e6}, {render::Integrator::whitted, 2e8}}));
  onBothTracers([&, integrator = integrator, value = value](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(4, 1);
    settings.image.integrator = integrator;
    settings.image.filmScale = 8;
    CHECK(render(scene, settings).film.mean(0, 0).x == Approx(value).epsilon(1e-4));
    settings.image.filmScale = 1;
    const render::RenderResult limited = render(scene, settings);
    CHECK(limited.film.mean(0, 0).x == 2 * image::kFilmMaximum);
    CHECK(limited.film.at(0, 0).badCount == 1);
  });
}

TEST_CASE("a session continues films of its own scale only") {
  const scene::Scene scene = facingSquare(test::diffuseMaterial(vec3(0.5f)), 1e5f);
  const render::RenderSettings settings = resolved(scene, 4, 4);
  const std::unique_ptr<render::Renderer> reference = reference::makeReferenceRenderer();
  for (render::Renderer* const renderer : {&testRenderer(), reference.get()}) {
    const auto session = renderer->prepare(scene, settings);
    CHECK_THROWS_WITH(session->load(image::Film(4, 4)), Catch::Contains("a render of scale 17"));
    session->advance({0, 2}, {});
    const image::Film half = session->film();
    session->advance({0, 4}, {});
    const auto later = renderer->prepare(scene, settings);
    later->load(half);
    later->advance({0, 4}, {});
    CHECK(later->film().hash() == session->film().hash());
  }
}
