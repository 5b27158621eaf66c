// Indices of refraction by channel: docs/light-transport.md section 5.13.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <span>

#include "tests/trace/proof/hemisphere.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/surface_samples.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using scene::SurfaceParameters;
using test::SceneBuilder;

namespace {

// Throughputs whose channels differ, and one of a single channel.
const std::vector<vec3> kThroughputs{{1, 1, 1}, {0.5f, 0.25f, 0.25f}, {0, 0.75f, 0.25f}, {0, 0, 3}};

SurfaceParameters dispersiveGlass(float roughness, float ior, float dispersion) {
  return {.roughness = roughness,
          .ior = ior,
          .transmissionWeight = 1,
          .transmissionDispersionScale = dispersion,
          .isThinWalled = false};
}

double iorOf(double ior, double dispersion, int channel) { return ior + (channel - 1) * (ior - 1) * dispersion / 40; }

// The surface without dispersion that has the index of refraction of one channel.
SurfaceParameters monochrome(SurfaceParameters surface, int channel) {
  surface.ior = static_cast<float>(std::max(1.0, iorOf(surface.ior, surface.transmissionDispersionScale, channel)));
  surface.transmissionDispersionScale = 0;
  return surface;
}

// Four materials for each surface: with dispersion, and those of the three channels.
std::vector<scene::Material> withMonochromes(const std::vector<SurfaceParameters>& surfaces) {
  std::vector<scene::Material> materials;
  for (const SurfaceParameters& surface : surfaces) {
    materials.push_back(materialOf(surface));
    for (int channel = 0; channel < 3; ++channel) materials.push_back(materialOf(monochrome(surface, channel)));
  }
  return materials;
}

const std::vector<SurfaceParameters>& surfacesWithDispersion() {
  static const std::vector<SurfaceParameters> surfaces = [] {
    std::vector<SurfaceParameters> list{dispersiveGlass(0.2f, 1.5f, 4), dispersiveGlass(0.5f, 2.4f, 1),
                                        dispersiveGlass(0.3f, 1.1f, 50)};  // red: clamped to 1
    list[0].baseColour = {0.9f, 0.7f, 0.5f};
    list[1].metalness = 0.3f;
    list[1].transmissionWeight = 0.6f;
    list[1].coatWeight = 0.5f;
    list[1].coatRoughness = 0.4f;
    list[2].specularColour = {1, 0.5f, 0.8f};
    return list;
  }();
  return surfaces;
}

double sumOf(const vec3& v) { return double{v.x} + v.y + v.z; }

// A number that chooses this channel: the middle of its part of [0, 1).
float numberOf(const vec3& throughput, int channel) {
  double below = 0;
  for (int c = 0; c < channel; ++c) below += throughput[c];
  return static_cast<float>((below + throughput[channel] / 2) / sumOf(throughput));
}

render::RenderSettings dispersionSettings(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = test::settingsOf(side, side, samples);
  settings.image.rouletteStart = settings.image.maxDepth;
  return settings;
}

}  // namespace

TEST_CASE("each channel of a surface with dispersion has the value of its own index, and the pdf is the mixture",
          "[swiftshader-slow]") {
  const MaterialLeaves leaves(withMonochromes(surfacesWithDispersion()));
  const std::vector<vec3> first = randomNumbers(3000, 401), second = randomNumbers(3000, 402);
  for (std::uint32_t surface = 0; surface < surfacesWithDispersion().size(); ++surface) {
    int transmitted = 0;
    std::vector<DirectionPair> pairs;  // four for each pair of directions, in one dispatch
    for (std::size_t i = 0; i < first.size(); ++i) {
      const dvec3 wo = directionAt(0.05 + 0.95 * first[i].x, first[i].y);
      const dvec3 wi = directionAt(2 * second[i].x - 1, second[i].y);
      for (std::uint32_t k = 0; k < 4; ++k) {
        pairs.push_back({4 * surface + k, wo, wi, first[i].z < 0.5f, {kThroughputs[i % kThroughputs.size()], 0.5f}});
      }
    }
    const std::vector<ScatterValue> all = leaves.evaluate(pairs);
    for (std::size_t i = 0; i < first.size(); ++i) {
      const vec3& beta = kThroughputs[i % kThroughputs.size()];
      const std::span values = std::span(all).subspan(4 * i, 4);
      const DirectionPair& pair = pairs[4 * i];
      double pdf = 0;
      CAPTURE(surface, pair.wo.z, pair.wi.z, pair.outside);
      for (int c = 0; c < 3; ++c) {
        const ScatterValue& channel = values[static_cast<std::size_t>(c) + 1];
        pdf += beta[c] / sumOf(beta) * channel.pdf;
        CHECK(values[0].f[c] == Approx(channel.f[c]).epsilon(3000 * kRounding).margin(1e-6));
      }
      CHECK(values[0].pdf == Approx(pdf).epsilon(3000 * kRounding).margin(1e-6));
      transmitted += pair.wi.z < 0 && pdf > 1e-3 ? 1 : 0;
    }
    CHECK(transmitted > 80);
  }
}

TEST_CASE("the mean weight of samples over the choice of the channel is the albedo of each channel's own surface",
          "[swiftshader-slow]") {
  const MaterialLeaves leaves(withMonochromes(surfacesWithDispersion()));
  const std::vector<vec3> numbers = latticeNumbers(8192);
  for (std::uint32_t surface = 0; surface < surfacesWithDispersion().size(); ++surface) {
    for (const bool outside : {true, false}) {
      const dvec3 wo = directionAt(0.7, 0.3);
      for (const vec3& beta : kThroughputs) {
        dvec3 mean(0);
        for (int channel = 0; channel < 3; ++channel) {
          if (beta[channel] == 0) continue;
          std::vector<ScatterQuery> queries;
          const ChannelQuery choice{beta, numberOf(beta, channel)};
          for (const vec3& u : numbers) queries.push_back({4 * surface, wo, u, outside, choice});
          mean += beta[channel] / sumOf(beta) * meanWeight(leaves.sample(queries));
        }
        for (int c = 0; c < 3; ++c) {
          if (beta[c] == 0) continue;
          const auto own = scattered(leaves, 4 * surface + static_cast<std::uint32_t>(c) + 1, wo, numbers, outside);
          CAPTURE(surface, outside, c, beta[0], beta[1], beta[2]);
          CHECK(mean[c] == Approx(meanWeight(own)[c]).margin(3e-3));
        }
      }
    }
  }
}

TEST_CASE("the channel is chosen in proportion to the throughput, and refracts by Snell's law with its own index",
          "[swiftshader-slow]") {
  constexpr double kIor = 1.5, kDispersion = 4;
  const MaterialLeaves leaves({materialOf(dispersiveGlass(0, kIor, kDispersion))});
  struct Choice {
    vec3 throughput;
    float number;
    int channel;
  };
  const std::vector<Choice> choices{{{1, 2, 1}, 0.2f, 0},   {{1, 2, 1}, 0.3f, 1},  {{1, 2, 1}, 0.7f, 1},
                                    {{1, 2, 1}, 0.8f, 2},   {{0, 0, 5}, 0, 2},     {{4, 0, 0}, 0.99f, 0},
                                    {{1, 0, 1}, 0.4f, 0},   {{1, 0, 1}, 0.6f, 2},  {{1, 1, 0}, 0.9999f, 1},
                                    {{0, 0, 0}, 0.001f, 1}, {{0, 0, 0}, 0.999f, 1}};
  for (const Choice& choice : choices) {
    const dvec3 wo = directionAt(0.8, 0.125);
    std::vector<ScatterQuery> queries;  // of 1,000 microfacets, whose slopes cancel
    for (const vec3& u : latticeNumbers(1000)) {
      queries.push_back({0, wo, {0.999f, u.y, u.z} /* transmits */, true, {choice.throughput, choice.number}});
    }
    dvec3 direction(0);
    for (const Scattered& sample : leaves.sample(queries)) {
      if (sample.lobe == render::Lobe::refract) direction += sample.wi;
    }
    const double expected = 0.6 / iorOf(kIor, kDispersion, choice.channel);  // sine of the refracted direction
    const double sine = std::hypot(direction.x, direction.y) / length(direction);
    CAPTURE(choice.number, choice.channel);
    CHECK(sine == Approx(expected).margin(2e-4));
    CHECK(expected != Approx(0.6 / iorOf(kIor, kDispersion, (choice.channel + 1) % 3)).margin(0.01));
  }
}

TEST_CASE("a prism shows each channel the light in the direction of its own deviation", "[swiftshader-slow]") {
  // Light enters a prism of 40 degrees at an angle of 50 degrees, in the plane y = 0.
  constexpr double kDegree = std::numbers::pi / 180, kApex = 40 * kDegree, kEntry = 50 * kDegree;
  constexpr double kIor = 1.5, kDispersion = 5, kDistance = 100;
  const dvec3 entryNormal(-std::cos(kApex / 2), 0, std::sin(kApex / 2));
  const dvec3 exitNormal(std::cos(kApex / 2), 0, std::sin(kApex / 2));
  const auto turned = [](const dvec3& v, double angle) {  // in the plane, from z towards x
    return dvec3(v.x * std::cos(angle) + v.z * std::sin(angle), 0, v.z * std::cos(angle) - v.x * std::sin(angle));
  };
  const dvec3 direction = turned(-entryNormal, -kEntry);  // from below, so that it is bent towards the base
  const auto deviation = [&](int channel) {
    const double n = iorOf(kIor, kDispersion, channel);
    const double inside = std::asin(std::sin(kEntry) / n);
    return kEntry + std::asin(n * std::sin(kApex - inside)) - kApex;
  };
  const auto schlick = [](double n, double cosine) {
    const double r = (n - 1) / (n + 1);
    return r * r + (1 - r * r) * std::pow(1 - cosine, 5);
  };
  for (int lit = 0; lit < 3; ++lit) {
    SceneBuilder b;
    b.material(materialOf(dispersiveGlass(0, kIor, kDispersion)));
    const vec3 top(0, 0, 1), left(-std::tan(kApex / 2), 0, 0), right(std::tan(kApex / 2), 0, 0), deep(0, 2, 0);
    b.quad(left - deep, top - deep, top + deep, left + deep).quad(right + deep, top + deep, top - deep, right - deep);
    b.quad(left + deep, right + deep, right - deep, left - deep);
    b.triangle(left - deep, right - deep, top - deep).triangle(left + deep, top + deep, right + deep);
    const dvec3 entry = 0.5 * dvec3(left + top), exit(0.5 * dvec3(right + top));
    const dvec3 out = turned(direction, deviation(lit));
    b.material(test::diffuseMaterial(vec3(0), vec3(1))).sphere(vec3(exit + kDistance * out), 0.6f);
    b.view(vec3(entry - 3.0 * direction), vec3(entry), {0, 1, 0}, 1e-3f);
    const dvec3 shown = test::meanOf(renderScene(b.scene, dispersionSettings(16, 256)).film);
    for (int channel = 0; channel < 3; ++channel) {
      const double n = iorOf(kIor, kDispersion, channel), last = deviation(channel) + kApex - kEntry;
      const double passing = (1 - schlick(n, std::cos(kEntry))) * (1 - schlick(n, std::cos(last)));
      CAPTURE(lit, channel, deviation(channel) / kDegree);
      CHECK(dot(out, exitNormal) > 0);
      CHECK(shown[channel] == Approx(channel == lit ? passing : 0).margin(0.03));
    }
  }
}

TEST_CASE("bodies of white glass with dispersion absorb nothing in any channel", "[swiftshader-slow]") {
  for (const float roughness : {0.0f, 0.3f}) {
    SceneBuilder b;
    b.material(materialOf(dispersiveGlass(roughness, 1.5f, 4))).sphere({0, 0, 0}, 1);
    b.scene.background = vec3(1);
    b.view({0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 11);
    const dvec3 mean = test::meanOf(renderScene(b.scene, dispersionSettings(16, 2048)).film);
    for (int c = 0; c < 3; ++c) {
      CAPTURE(roughness, c, mean[c]);
      CHECK(mean[c] >= 0.99);
      CHECK(mean[c] <= 1.008);  // 1.001, and more than three times the noise of disjoint lobes
    }
  }
}

TEST_CASE("a picture with dispersion is in each channel that of the channel's index without dispersion",
          "[swiftshader-slow]") {
  for (const float roughness : {0.05f, 0.25f}) {
    const SurfaceParameters glass = dispersiveGlass(roughness, 1.6f, 3);
    const auto shown = [&](const SurfaceParameters& surface, std::uint32_t seed) {
      SceneBuilder b;
      b.material(materialOf(surface)).sphere({0, 0, 1}, 1);
      b.material(test::diffuseMaterial({0.8f, 0.7f, 0.6f})).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      b.material(test::diffuseMaterial(vec3(0), {4, 5, 6})).quad({2, -1, 4}, {2, 1, 4}, {4, 1, 3}, {4, -1, 3});
      b.scene.background = {0.2f, 0.4f, 0.8f};
      b.view({0, -5, 1.5f}, {0, 0, 0.9f}, {0, 0, 1}, 30);
      render::RenderSettings settings = dispersionSettings(8, 2048);
      settings.image.seed = seed;
      return test::meanOf(renderScene(b.scene, settings).film);
    };
    const dvec3 spread = shown(glass, 1);
    for (int c = 0; c < 3; ++c) {
      const double own = shown(monochrome(glass, c), 2 + static_cast<std::uint32_t>(c))[c];
      CAPTURE(roughness, c);
      CHECK(spread[c] == Approx(own).epsilon(0.01));
    }
  }
}

TEST_CASE("thin walls, an index of 1 and a scale of 0 do not disperse: the film keeps its bits", "[swiftshader-slow]") {
  const auto filmOf = [&](const SurfaceParameters& surface, float hidden) {
    SceneBuilder b;
    b.material(materialOf(surface)).sphere({0, 0, 0}, 1);
    b.material(test::diffuseMaterial(vec3(0.5f))).plane({0, 0, -1}, {1, 0, -1}, {0, 1, -1});
    b.box({-1, -1, -9}, {1, 1, -5});  // hides what is in it below the plane
    b.material(materialOf(dispersiveGlass(0.1f, 1.5f, hidden))).sphere({0, 0, -7}, 0.5f);
    b.scene.background = {0.5f, 0.7f, 0.9f};
    b.view({0, -5, 1}, {0, 0, 0}, {0, 0, 1}, 30);
    return renderScene(b.scene, dispersionSettings(16, 16)).film;
  };
  SurfaceParameters thin = dispersiveGlass(0.1f, 1.5f, 5);
  thin.isThinWalled = true;
  SurfaceParameters air = dispersiveGlass(0.1f, 1, 5);
  for (SurfaceParameters surface : {thin, air, dispersiveGlass(0.1f, 1.5f, 0)}) {
    const image::Film with = filmOf(surface, 5);
    surface.transmissionDispersionScale = 0;
    const image::Film without = filmOf(surface, 0);
    CAPTURE(surface.ior, surface.isThinWalled);
    for (std::uint32_t y = 0; y < with.height(); ++y) {
      for (std::uint32_t x = 0; x < with.width(); ++x) REQUIRE(with.mean(x, y) == without.mean(x, y));
    }
  }
  CHECK(filmOf(dispersiveGlass(0.1f, 1.5f, 5), 0).mean(8, 8) != filmOf(dispersiveGlass(0.1f, 1.5f, 0), 0).mean(8, 8));
}
