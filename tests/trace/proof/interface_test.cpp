// Single interfaces: docs/light-transport.md section 5.15.
#include <catch2/catch.hpp>
#include <cmath>
#include <complex>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/surface_density.h"
#include "tests/trace/proof/surface_samples.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using enum scene::Interface;

namespace {

// Roughnesses along the axes, the first of which is the larger one.
void setAlphas(double rough, double narrow, scene::SurfaceParameters& surface) {
  surface.roughness = static_cast<float>(std::sqrt(narrow));
  surface.anisotropy = static_cast<float>(std::sqrt((rough - narrow) / (1 - narrow)));
}

scene::SurfaceParameters glass(scene::Interface shape, double alpha, double ior = 1.5) {
  return {.roughness = static_cast<float>(std::sqrt(alpha)),
          .ior = static_cast<float>(ior),
          .transmissionWeight = 1,
          .isThinWalled = false,
          .bareInterface = shape};
}

scene::SurfaceParameters pane(double ior) {
  scene::SurfaceParameters surface = glass(smooth, 0, ior);
  surface.isThinWalled = true;
  return surface;
}

scene::SurfaceParameters gold(scene::Interface shape, double alpha) {
  return {
      .metalness = 1, .roughness = static_cast<float>(std::sqrt(alpha)), .conductor = kGold, .bareInterface = shape};
}

std::vector<scene::Material> materialsOf(const std::vector<scene::SurfaceParameters>& surfaces) {
  std::vector<scene::Material> materials;
  for (const scene::SurfaceParameters& surface : surfaces) materials.push_back(materialOf(surface));
  return materials;
}

// Fresnel's reflectance for unpolarised light by complex amplitudes. `n`: beyond the interface relative to the near
// side.
double reflectanceAt(double cosine, std::complex<double> n) {
  const std::complex<double> beyond = std::sqrt(std::complex(1.0) - (1 - cosine * cosine) / (n * n));
  return (std::norm((cosine - n * beyond) / (cosine + n * beyond)) +
          std::norm((n * cosine - beyond) / (n * cosine + beyond))) /
         2;
}

dvec3 goldAt(double cosine) {
  dvec3 reflectance;
  for (int c = 0; c < 3; ++c) reflectance[c] = reflectanceAt(cosine, {kGold.ior[c], kGold.extinction[c]});
  return reflectance;
}

struct Reflection {
  scene::Interface shape;
  double rough, narrow, cosO, cosI, turn;
  double red, blue, entering, leaving;  ///< f of gold, and of glass from outside and from inside
};
struct Refraction {
  scene::Interface shape;
  double rough, narrow, cosOutside, cosInside, turn;
  double entering, leaving;
};

// By tests/trace/proof/interface_model.py.
const std::vector<Reflection> kReflections{
    {ggx, 0.3, 0.3, 0.9, 0.7, 0.45, 0.66433973, 0.225596528, 0.0296753983, 0.061170781},
    {ggx, 0.4, 0.1, 0.6, 0.65, 0.47, 0.81725398, 0.292419312, 0.0504993599, 0.847448834},
    {beckmann, 0.2, 0.2, 0.6, 0.5, 0.52, 4.77602671, 1.77693604, 0.368216401, 4.95855546},
    {beckmann, 0.5, 0.15, 0.25, 0.4, 0.48, 1.71908589, 0.791591144, 0.321822144, 1.79213557}};
const std::vector<Refraction> kRefractions{{ggx, 0.3, 0.3, 0.9, -0.95, 0.45, 8.38594982, 3.72708881},
                                           {ggx, 0.4, 0.1, 0.75, -0.9, 0.51, 29.7259638, 13.2115395},
                                           {beckmann, 0.2, 0.2, 0.4, -0.8, 0.48, 13.0596008, 5.804267},
                                           {beckmann, 0.5, 0.15, 0.6, -0.95, 0.46, 0.00921970281, 0.00409764561}};

const std::vector<dvec3> kInterfaceViews{directionAt(0.99, 0.05), directionAt(0.6, 0.42), directionAt(0.15, 0.7)};

}  // namespace

TEST_CASE("rough interfaces have the values of an independent computation of Mitsuba's model") {
  for (const Reflection& r : kReflections) {
    scene::SurfaceParameters metal = gold(r.shape, r.narrow), dielectric = glass(r.shape, r.narrow);
    metal.baseColour = dielectric.specularColour = glm::vec3(0.5f);
    setAlphas(r.rough, r.narrow, metal);
    setAlphas(r.rough, r.narrow, dielectric);
    const MaterialLeaves leaves(materialsOf({metal, dielectric}));
    const dvec3 wo = directionAt(r.cosO, 0.1), wi = directionAt(r.cosI, 0.1 + r.turn);
    const std::vector<ScatterValue> f = leaves.evaluate(
        std::vector<DirectionPair>{{0, wo, wi}, {1, wo, wi}, {1, wo, wi, false}});
    CAPTURE(static_cast<int>(r.shape), r.rough, r.cosO);
    CHECK(f[0].f.x == Approx(0.5 * r.red).epsilon(1e-4));
    CHECK(f[0].f.z == Approx(0.5 * r.blue).epsilon(1e-4));
    CHECK(f[1].f.x == Approx(0.5 * r.entering).epsilon(1e-4));
    CHECK(f[2].f.x == Approx(0.5 * r.leaving).epsilon(1e-4));
  }
  for (const Refraction& r : kRefractions) {
    scene::SurfaceParameters dielectric = glass(r.shape, r.narrow);
    dielectric.baseColour = glm::vec3(0.25f);
    setAlphas(r.rough, r.narrow, dielectric);
    const MaterialLeaves leaves(materialsOf({dielectric}));
    const dvec3 wo = directionAt(r.cosOutside, 0.1), wi = directionAt(r.cosInside, 0.1 + r.turn);
    const std::vector<ScatterValue> f = leaves.evaluate(std::vector<DirectionPair>{{0, wo, wi}, {0, -wi, -wo, false}});
    CAPTURE(static_cast<int>(r.shape), r.rough, r.cosOutside);
    CHECK(f[0].f.x == Approx(0.25 * r.entering).epsilon(3e-4));
    CHECK(f[1].f.x == Approx(0.25 * r.leaving).epsilon(3e-4));
  }
}

TEST_CASE("rough interfaces are sampled with the stated density", "[swiftshader-slow]") {
  std::vector<scene::SurfaceParameters> surfaces;
  for (const scene::Interface shape : {ggx, beckmann}) {
    for (const double alpha : {1e-4, 0.0025, 0.04, 0.25, 1.0}) {
      surfaces.push_back(gold(shape, alpha));
      surfaces.push_back(glass(shape, alpha));
    }
    surfaces.push_back(glass(shape, 0.2, 1 / 1.4));
    surfaces.push_back(glass(shape, 0.05));
    setAlphas(0.3, 0.05, surfaces.back());
    surfaces.back().baseColour = {0.8f, 0.5f, 0.1f};
    surfaces.back().specularColour = {0.9f, 0.2f, 0.4f};
  }
  const MaterialLeaves leaves(materialsOf(surfaces));
  const SurfaceNumbers numbers;
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    for (const dvec3& wo : kInterfaceViews) {
      for (const bool outside : {true, false}) {
        if (!outside && surfaces[i].transmissionWeight == 0) continue;
        CAPTURE(i, surfaces[i].roughness, wo.z, outside);
        checkSurface(leaves, {i, surfaces[i], wo, outside}, numbers);
      }
    }
  }
}

TEST_CASE("rough interfaces are reciprocal, up to the square of the index of refraction") {
  const MaterialLeaves leaves(
      materialsOf({gold(ggx, 0.2), gold(beckmann, 0.4), glass(ggx, 0.2), glass(beckmann, 0.4)}));
  const std::vector<glm::vec3> a = randomNumbers(2000, 331), b = randomNumbers(2000, 332);
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (const bool crosses : {false, true}) {
      if (crosses && i < 2) continue;
      std::vector<DirectionPair> there, back;
      for (std::size_t k = 0; k < a.size(); ++k) {
        const dvec3 wo = directionAt(1 - 0.97 * a[k].x, a[k].y), wi = directionAt(1 - 0.97 * b[k].x, b[k].y);
        there.push_back({i, wo, crosses ? -wi : wi});
        // Between both, the frame is turned over, so that the normal is again on the side of wo.
        back.push_back({i, wi, crosses ? -wo : wo, !crosses});
      }
      const std::vector<ScatterValue> forwards = leaves.evaluate(there), backwards = leaves.evaluate(back);
      const double factor = crosses ? 1.5 * 1.5 : 1;
      std::size_t lit = 0;
      for (std::size_t k = 0; k < forwards.size(); ++k) {
        CAPTURE(i, crosses, k);
        const dvec3 f = forwards[k].f;
        REQUIRE(length(f - factor * backwards[k].f) <= 5e3 * kRounding * length(f) + 1e-9);
        lit += length(f) > 1e-3 ? 1u : 0u;
      }
      CHECK(lit > 100);
    }
  }
}

TEST_CASE("rough interfaces reflect and transmit no more light than they receive") {
  const MaterialLeaves leaves(
      materialsOf({glass(ggx, 0.01), glass(beckmann, 0.01), glass(ggx, 0.5), glass(beckmann, 0.5)}));
  const std::vector<glm::vec3> numbers = latticeNumbers(50000);
  for (std::uint32_t i = 0; i < 4; ++i) {
    for (const dvec3& wo : kInterfaceViews) {
      const double albedo = meanWeight(scattered(leaves, i, wo, numbers)).x;
      CAPTURE(i, wo.z, albedo);
      CHECK(albedo < 1.005);
      CHECK(albedo > (i < 2 ? 0.98 : 0.5));
    }
  }
}

TEST_CASE("smooth glass reflects Fresnel's fraction and refracts by Snell's law, also into a thinner medium") {
  for (const double ior : {1.5, 1 / 1.5, 1.0}) {
    scene::SurfaceParameters surface = glass(smooth, 0, ior);
    surface.baseColour = {0.9f, 0.8f, 0.7f};
    surface.specularColour = {0.2f, 0.5f, 1};
    const MaterialLeaves leaves(materialsOf({surface}));
    const std::vector<glm::vec3> numbers = randomNumbers(25000, 341);
    for (const double cosine : {1.0, 0.8, 0.3}) {
      for (const bool outside : {true, false}) {
        const double n = outside ? double{surface.ior} : 1 / double{surface.ior};
        const dvec3 wo = directionAt(cosine, 0.3);
        const double share = reflectanceAt(cosine, n), squaredSine = (1 - cosine * cosine) / (n * n);
        const dvec3 refracted = -directionAt(std::sqrt(std::max(0.0, 1 - squaredSine)), 0.3);
        std::vector<double> counts(2);
        for (const Scattered& sample : scattered(leaves, 0, wo, numbers, outside)) {
          const bool reflects = sample.lobe == render::Lobe::reflect;
          REQUIRE((reflects || sample.lobe == render::Lobe::refract));
          REQUIRE(length(sample.wi - (reflects ? dvec3(-wo.x, -wo.y, wo.z) : refracted)) < 20 * kRounding);
          REQUIRE(sample.weight == dvec3(reflects ? surface.specularColour : surface.baseColour));
          REQUIRE(sample.pdf == 0);
          ++counts[reflects ? 0 : 1];
        }
        const double total = static_cast<double>(numbers.size());
        CAPTURE(ior, cosine, outside);
        if (n == 1 || squaredSine >= 1)
          CHECK(counts == std::vector<double>{n == 1 ? 0 : total, n == 1 ? total : 0});
        else
          checkCounts(counts, std::vector<double>{share * total, (1 - share) * total});
      }
    }
  }
}

TEST_CASE("a thin pane transmits straight on what all reflections between its sides leave") {
  const MaterialLeaves leaves(materialsOf({pane(1.5)}));
  const std::vector<glm::vec3> numbers = randomNumbers(25000, 342);
  for (const double cosine : {1.0, 0.6, 0.2}) {
    for (const bool outside : {true, false}) {
      const dvec3 wo = directionAt(cosine, 0.4);
      std::vector<double> counts(2);
      for (const Scattered& sample : scattered(leaves, 0, wo, numbers, outside)) {
        const bool reflects = sample.lobe == render::Lobe::reflect;
        REQUIRE(length(sample.wi - (reflects ? dvec3(-wo.x, -wo.y, wo.z) : -wo)) < 2 * kRounding);
        REQUIRE(sample.weight == dvec3(1));
        ++counts[reflects ? 0 : 1];
      }
      // 1 - R' is the sum (1 - R)^2 (1 + R^2 + R^4 + ...).
      const double once = reflectanceAt(cosine, 1.5), passing = (1 - once) * (1 - once) / (1 - once * once);
      const double total = static_cast<double>(numbers.size());
      CAPTURE(cosine, outside);
      checkCounts(counts, std::vector<double>{(1 - passing) * total, passing * total});
    }
  }
}

TEST_CASE("smooth metal reflects one direction by Fresnel's equations, or everything without a conductor") {
  scene::SurfaceParameters white = gold(smooth, 0), tinted = gold(smooth, 0);
  white.conductor.reset();
  tinted.baseColour = {0.5f, 0.8f, 0.3f};
  const MaterialLeaves leaves(materialsOf({white, tinted}));
  const std::vector<glm::vec3> numbers = randomNumbers(100, 343);
  for (const double cosine : {1.0, 0.6, 0.1}) {
    const dvec3 wo = directionAt(cosine, 0.2);
    for (const std::uint32_t i : {0u, 1u}) {
      const dvec3 expected = i == 0 ? dvec3(1) : dvec3(tinted.baseColour) * goldAt(cosine);
      for (const Scattered& sample : scattered(leaves, i, wo, numbers)) {
        REQUIRE(sample.lobe == render::Lobe::mirror);
        REQUIRE(sample.pdf == 0);
        REQUIRE(length(sample.wi - dvec3(-wo.x, -wo.y, wo.z)) < kRounding);
        REQUIRE(length(sample.weight - expected) < 30 * kRounding);
      }
    }
  }
}

TEST_CASE("below a normal map, smooth interfaces keep their weight, and their directions the side of the surface") {
  const dvec3 geometric = normalize(dvec3(0.9, 0.1, 1));
  const MaterialLeaves leaves(materialsOf({gold(smooth, 0), glass(smooth, 0)}));
  const std::vector<glm::vec3> numbers = randomNumbers(300, 344);
  const auto mirrored = [&](const dvec3& w) { return w - 2 * dot(w, geometric) * geometric; };
  std::size_t turned = 0;
  for (const dvec3& wo : {directionAt(0.9, 0), directionAt(0.5, 0), directionAt(0.7, 0.5)}) {
    for (const std::uint32_t i : {0u, 1u}) {
      const std::vector<Scattered> plain = scattered(leaves, i, wo, numbers);
      const std::vector<Scattered> mapped = scattered(leaves, i, wo, numbers, true, geometric);
      for (std::size_t k = 0; k < plain.size(); ++k) {
        const double side = plain[k].lobe == render::Lobe::refract ? -1 : 1;
        const bool keeps = side * dot(plain[k].wi, geometric) > 0;
        turned += keeps ? 0u : 1u;
        REQUIRE(mapped[k].lobe == plain[k].lobe);
        REQUIRE(mapped[k].weight == plain[k].weight);
        REQUIRE(mapped[k].pdf == 0);
        REQUIRE(length(mapped[k].wi - (keeps ? plain[k].wi : mirrored(plain[k].wi))) < 20 * kRounding);
      }
    }
  }
  CHECK(turned > 0);
}

TEST_CASE("facets of normal maps of rough interfaces scatter with the stated density", "[swiftshader-slow]") {
  const std::vector<scene::SurfaceParameters> surfaces{gold(ggx, 0.3), gold(beckmann, 0.5), glass(beckmann, 0.3)};
  const MaterialLeaves leaves(materialsOf(surfaces));
  const SurfaceNumbers numbers;
  const dvec3 geometric = normalize(dvec3(0.7, 0.2, 1));
  for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
    scene::SurfaceParameters surface = surfaces[i];
    surface.roughness = 1;
    CAPTURE(i);
    checkSurface(leaves, {i, surface, directionAt(0.9, 0.2), true, geometric}, numbers);
  }
}

TEST_CASE("white bodies and panes of smooth glass, and white smooth metal, vanish in a white environment") {
  scene::SurfaceParameters white = gold(smooth, 0);
  white.conductor.reset();
  for (const scene::SurfaceParameters& surface : {glass(smooth, 0), glass(smooth, 0, 0.7), pane(1.5), white}) {
    test::SceneBuilder b;
    b.material(materialOf(surface)).sphere({0, 0, 0}, 1).box({1.2f, -0.5f, -0.5f}, {2, 0.5f, 0.5f});
    b.scene.background = glm::vec3(1);
    b.view({0, -8, 1}, {0.4f, 0, 0}, {0, 0, 1}, 30);
    render::RenderSettings settings = test::settingsOf(32, 32, 16);
    settings.image.maxDepth = 500;
    settings.image.rouletteStart = settings.image.maxDepth;
    const render::RenderResult result = renderScene(b.scene, settings);
    CAPTURE(surface.ior, surface.isThinWalled, surface.metalness);
    for (std::uint32_t y = 0; y < 32; ++y) {
      // Paths that many total reflections keep in the box end at the limit of depth.
      for (std::uint32_t x = 0; x < 32; ++x) REQUIRE(length(result.film.mean(x, y) - dvec3(1)) < 2e-6);
    }
    CHECK(result.statistics.volumeFaults == 0);
  }
}

TEST_CASE("a slab of smooth glass and a thin pane transmit the same fraction, by Fresnel's equations",
          "[swiftshader-slow]") {
  for (const double degrees : {0.0, 45.0, 70.0}) {
    const double angle = degrees * std::numbers::pi / 180;
    const double once = reflectanceAt(std::cos(angle), 1.5), passing = (1 - once) / (1 + once);
    for (const bool isThin : {false, true}) {
      test::SceneBuilder b;
      b.material(materialOf(isThin ? pane(1.5) : glass(smooth, 0)));
      if (isThin)
        b.plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      else
        b.box({-1000, -1000, -1}, {1000, 1000, 0});
      b.material(test::diffuseMaterial(glm::vec3(0), {1, 0, 0})).plane({0, 0, -2}, {1, 0, -2}, {0, 1, -2});
      b.scene.background = {0, 1, 0};
      b.view(glm::vec3(5 * std::sin(angle), 0, 5 * std::cos(angle)), {0, 0, 0}, {0, 1, 0}, 1e-3f);
      render::RenderSettings settings = test::settingsOf(16, 16, 1024);
      settings.image.rouletteStart = settings.image.maxDepth;
      const dvec3 shown = test::meanOf(renderScene(b.scene, settings).film);
      CAPTURE(degrees, isThin);
      CHECK(shown.x == Approx(passing).margin(2e-3));
      CHECK(shown.y == Approx(1 - passing).margin(2e-3));
    }
  }
}
