// Materials that are choices on both tracers: the same pixels at equal seeds, and films that are those of their
// materials.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/image/image.h"
#include "tests/trace/light/parallelogram.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"
#include "tests/trace/render/pixel_agreement.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::parallelogram;
using test::SceneBuilder;

namespace {

const vec3 kRed(0.8f, 0.2f, 0.1f), kBlue(0.1f, 0.3f, 0.9f);

// Adds two materials, and a choice between them, which the next primitives have.
std::uint32_t choose(SceneBuilder& b, const scene::Material& first, const scene::Material& second,
                     std::optional<float> weight) {
  const auto index = static_cast<std::uint32_t>(b.scene.materials.size());
  scene::Material either;
  either.choice = scene::MaterialChoice{index, index + 1, weight};
  either.emission = first.emission;
  b.material(first).material(second).material(either);
  return index + 2;
}

// A view of the origin from above or from below, in the light of a background.
SceneBuilder skyAbove(bool isSeenFromBehind) {
  SceneBuilder b;
  b.scene.background = vec3(1);
  b.view({0, 0, isSeenFromBehind ? -5.0f : 5.0f}, {0, 0, 0}, {0, 1, 0}, 20);
  return b;
}

std::uint64_t hashOf(const RenderFunction& render, const SceneBuilder& b, std::uint32_t samples = 4) {
  return render(b.scene, squareSettings(16, samples)).film.hash();
}

scene::Material roughMetal() {
  scene::Material metal;
  metal.surface = scene::SurfaceParameters{.baseColour = {0.9f, 0.7f, 0.4f}, .metalness = 1, .roughness = 0.4f};
  return metal;
}

// Blends of lobes and of surfaces on balls, a blend by a texture whose materials have textures, sheets with different
// sides, one of them with a blend as its back, a blend that transmits light, and one that emits.
scene::Scene choices() {
  SceneBuilder b;
  b.scene.images = {{"", 2, 2, {0x20ff8040u, 0xe04080ffu, 0xa0ffffffu, 0x60c0c0c0u}}};
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  choose(b, diffuseMaterial(kRed), test::mirrorMaterial(vec3(0.9f)), 0.4f);
  b.sphere({-2.4f, 0, 0.8f}, 0.8f);
  choose(b, diffuseMaterial(kBlue), roughMetal(), 0.5f);
  b.sphere({-0.8f, 0, 0.8f}, 0.8f);
  choose(b, test::glassMaterial(vec3(1), 1.5f), diffuseMaterial(kRed), 0.3f);
  b.sphere({0.8f, 0, 0.8f}, 0.8f);
  choose(b, diffuseMaterial(vec3(0.4f), vec3(1)), test::mirrorMaterial(vec3(0.5f)), 0.5f);
  b.scene.materials[b.scene.materials.size() - 2].emission = vec3(1);
  b.sphere({2.4f, 0, 0.8f}, 0.6f);
  scene::Material mapped = diffuseMaterial(vec3(1));
  mapped.textures[0] = scene::TextureReference{.rowS = {3, 0, 0}};
  const std::uint32_t textured = choose(b, mapped, roughMetal(), 0.9f);
  b.scene.materials[textured].textures[0] = scene::TextureReference{};
  addMesh(b.scene, parallelogram({-3, 1.5f, 0}, {3, 0, 0}, {0, 0, 2.5f}), textured);
  scene::Material sides;
  sides.choice = scene::MaterialChoice{0, textured, std::nullopt};
  b.material(sides);
  addMesh(b.scene, parallelogram({3, 1.5f, 0}, {-3, 0, 0}, {0, 0, 2.5f}), static_cast<std::uint32_t>(textured + 1));
  b.pointLight({-1, -4, 4}, vec3(1));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 1.8f}, {0, 0, 1}, {0, 0, 1}, 45);
  b.scene.name = "choices";
  return b.scene;
}

}  // namespace

TEST_CASE("choices of materials have the reference's pixels at equal seeds") {
  const scene::Scene scene = choices();
  for (const std::uint32_t seed : {0u, 1u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(scene, settings);
  }
}

TEST_CASE("the wavefront takes the choices of the megakernel", "[swiftshader-slow]") {
  render::RenderSettings settings = squareSettings(48, 4);
  const std::uint64_t expected = renderOnDevice(choices(), settings).film.hash();
  settings.execution.kernel = render::KernelKind::wavefront;
  CHECK(renderOnDevice(choices(), settings).film.hash() == expected);
}

TEST_CASE("views show the materials that are chosen", "[swiftshader-slow]") {
  for (const render::Integrator view : {render::Integrator::albedo, render::Integrator::normal}) {
    render::RenderSettings settings = squareSettings(64, 1);
    settings.image.integrator = view;
    checkPixelsAgree(choices(), settings);
  }
}

TEST_CASE("a choice of weight 0 or 1 has the film of its material") {
  onBothTracers([](const RenderFunction& render) {
    for (const float weight : {0.0f, 1.0f}) {
      SceneBuilder chosen = skyAbove(false), single = skyAbove(false);
      choose(chosen, diffuseMaterial(kRed), roughMetal(), weight);
      single.material(weight == 0 ? diffuseMaterial(kRed) : roughMetal());
      for (SceneBuilder* b : {&chosen, &single}) b->quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
      CHECK(hashOf(render, chosen) == hashOf(render, single));
    }
  });
}

TEST_CASE("a choice by side has the first material in front and the second one behind") {
  onBothTracers([](const RenderFunction& render) {
    for (const bool isSeenFromBehind : {false, true}) {
      SceneBuilder chosen = skyAbove(isSeenFromBehind), single = skyAbove(isSeenFromBehind);
      choose(chosen, diffuseMaterial(kRed), diffuseMaterial(kBlue), std::nullopt);
      single.material(diffuseMaterial(isSeenFromBehind ? kBlue : kRed));
      for (SceneBuilder* b : {&chosen, &single}) b->quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
      CHECK(hashOf(render, chosen) == hashOf(render, single));
    }
  });
}

TEST_CASE("a choice by side is that of a sphere's own side") {
  onBothTracers([](const RenderFunction& render) {
    for (const bool isInside : {false, true}) {
      SceneBuilder chosen, single;
      choose(chosen, diffuseMaterial(vec3(0), vec3(0)), diffuseMaterial(kBlue), std::nullopt);
      single.material(diffuseMaterial(isInside ? kBlue : vec3(0)));
      for (SceneBuilder* b : {&chosen, &single}) {
        b->sphere({0, 0, 0}, 2);
        b->pointLight({0, 0.5f, isInside ? 1.0f : 3.0f}, vec3(1));
        b->view({0, 0, isInside ? 0.0f : 5.0f}, {0, 0, isInside ? 1.0f : 0.0f}, {0, 1, 0}, 20);
      }
      CHECK(hashOf(render, chosen) == hashOf(render, single));
    }
  });
}

TEST_CASE("the albedo of a blend is the mean of its albedos by weight") {
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b = skyAbove(false);
    choose(b, diffuseMaterial(vec3(0.2f)), diffuseMaterial(vec3(0.8f)), 0.25f);
    b.quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const double mean = meanLuminance(render(b.scene, squareSettings(16, 1024)).film);
    const double deviation = 0.6 * std::sqrt(0.25 * 0.75 / (256 * 1024));
    CHECK(std::abs(mean - (0.75 * 0.2 + 0.25 * 0.8)) < 5 * deviation);
  });
}

TEST_CASE("the weight of a blend is its factor times the alpha of its texture") {
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b = skyAbove(false);
    const std::uint32_t either = choose(b, diffuseMaterial(vec3(0)), diffuseMaterial(vec3(1)), 0.5f);
    const scene::TextureReference nearest{.filter = scene::TextureFilter::nearest};
    b.scene.materials[either].textures[0] = nearest;
    b.scene.images = {{"", 2, 1, {0x00ffffffu, 0xff000000u}}};
    addMesh(b.scene, parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), either);
    const image::Image seen = image::toImage(render(b.scene, squareSettings(16, 1024)).film);
    double left = 0, right = 0;
    for (std::uint32_t y = 0; y < 16; ++y) {
      for (std::uint32_t x = 0; x < 7; ++x) {
        left += double{seen.at(x, y).x};
        right += double{seen.at(15 - x, y).x} / 112;
      }
    }
    CHECK(left == 0);
    CHECK(std::abs(right - 0.5) < 5 * 0.5 / std::sqrt(112.0 * 1024));
  });
}

TEST_CASE(
    "the weight of a blend is also scaled by the alpha of vertex colours, whose colour is that of both materials") {
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b = skyAbove(false);
    const std::uint32_t either = choose(b, diffuseMaterial(vec3(0)), diffuseMaterial(vec3(1)), 0.5f);
    scene::Mesh mesh = parallelogram({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    mesh.colours.assign(4, {0.5f, 0.5f, 0.5f, 0.25f});
    addMesh(b.scene, std::move(mesh), either);
    const double mean = meanLuminance(render(b.scene, squareSettings(16, 1024)).film);
    CHECK(std::abs(mean - 0.5 * 0.125) < 5 * 0.5 * std::sqrt(0.125 * 0.875 / (256 * 1024)));
  });
}

TEST_CASE("a blend that emits is found by light sampling and by paths") {
  onBothTracers([](const RenderFunction& render) {
    const auto lit = [&](bool isBlend, bool samplesLights) {
      SceneBuilder b;
      b.material(diffuseMaterial(vec3(0.5f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      const scene::Material lamp = diffuseMaterial(vec3(0), vec3(3));
      if (isBlend) {
        choose(b, lamp, lamp, 0.5f);
      } else {
        b.material(lamp);
      }
      b.sphere({0, 0, 2}, 1);
      b.view({0, -2, 3}, {0, 0, 0}, {0, 0, 1}, 20);
      render::RenderSettings settings = squareSettings(8, 64);
      settings.image.nextEventEstimation = samplesLights;
      return render(b.scene, settings).film.hash();
    };
    for (const bool samplesLights : {false, true}) CHECK(lit(true, samplesLights) == lit(false, samplesLights));
  });
}
