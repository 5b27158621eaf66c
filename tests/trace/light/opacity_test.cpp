// Opacity on both tracers: the same pixels at equal seeds with every structure and kernel, and closed forms for rays of
// the camera, of paths, and shadow rays.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

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

void add(SceneBuilder& b, scene::Material material, const scene::Opacity& opacity, scene::Mesh mesh) {
  material.opacity = opacity;
  b.material(material);
  addMesh(b.scene, std::move(mesh), static_cast<std::uint32_t>(b.scene.materials.size() - 1));
}

// Sheets of each kind behind and above each other, in the light of an emitter and a point light: with a
// factor, a texture that blends, a mask, a mask of nearest texels with vertex normals, and vertex colours.
scene::Scene sheets() {
  SceneBuilder b;
  std::mt19937 random(5);
  scene::TextureImage image{"", 6, 6, {}};
  for (int i = 0; i < 36; ++i) image.texels.push_back(static_cast<std::uint32_t>(random()));
  b.scene.images = {image};
  b.material(diffuseMaterial(vec3(0.7f))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  b.material(diffuseMaterial({0.8f, 0.6f, 0.4f})).sphere({0, 1, 0.8f}, 0.8f);
  b.material(diffuseMaterial(vec3(0), vec3(4))).quad({-1, -1, 4}, {-1, 1, 4}, {1, 1, 4}, {1, -1, 4});
  b.pointLight({3, -4, 3}, vec3(0.5f));
  const scene::Material red = diffuseMaterial({0.8f, 0.2f, 0.2f});
  add(b, red, {.factor = 0.4f}, parallelogram({-2, -1, 0.1f}, {4, 0, 0}, {0, 0, 1}));
  add(b, red, {.texture = scene::TextureReference{}}, parallelogram({-2, -1.5f, 0.6f}, {4, 0, 0}, {0, 0, 1}));
  add(b, red, {.cutoff = 0.5f, .texture = scene::TextureReference{}},
      parallelogram({-1.5f, -1.5f, 2}, {3, 0, 0}, {0, 3, 0}));
  scene::Mesh smooth = parallelogram({-2, 2.2f, 0}, {4, 0, 0}, {0, 0, 2.5f});
  smooth.normals.assign(4, {0, -1, 0});
  const scene::TextureReference nearest{.filter = scene::TextureFilter::nearest, .rowS = {2, 0, 0}};
  add(b, red, {.factor = 0.9f, .cutoff = 0.25f, .texture = nearest}, smooth);
  scene::Mesh coloured = parallelogram({-2.5f, -2, 0}, {1, -0.5f, 0}, {0, 0, 2});
  coloured.colours = {{1, 0, 0, 0}, {0, 1, 0, 1}, {0, 0, 1, 0.5f}, {1, 1, 1, 0.25f}};
  add(b, diffuseMaterial(vec3(1)), {}, coloured);
  scene::Mesh glowing = parallelogram({1.5f, -2, 0}, {1, 0.5f, 0}, {0, 0, 2});
  add(b, diffuseMaterial(vec3(0), vec3(0.8f)), {.factor = 0.7f, .texture = scene::TextureReference{}}, glowing);
  b.scene.background = vec3(0.05f);
  b.view({0, -8, 2.5f}, {0, 0, 1.2f}, {0, 0, 1}, 40);
  b.scene.name = "sheets";
  return b.scene;
}

// A wall of radiance 1 that fills the view, and sheets in front of it that absorb.
SceneBuilder wallBehind(const std::vector<scene::Opacity>& opacities) {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(0), vec3(1))).quad({-9, -9, -1}, {9, -9, -1}, {9, 9, -1}, {-9, 9, -1});
  float height = 0;
  for (const scene::Opacity& opacity : opacities) {
    add(b, diffuseMaterial(vec3(0)), opacity, parallelogram({-1, -1, height}, {2, 0, 0}, {0, 2, 0}));
    height += 0.1f;
  }
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 20);
  return b;
}

}  // namespace

TEST_CASE("transparent triangles have the reference's pixels at equal seeds") {
  for (const std::uint32_t seed : {0u, 1u, 2u}) {
    render::RenderSettings settings = squareSettings(96, 1);
    settings.image.seed = seed;
    checkPixelsAgree(sheets(), settings);
  }
}

TEST_CASE("every structure and kernel decides the same transparent triangles", "[swiftshader-slow]") {
  const scene::Scene scene = sheets();
  const render::RenderSettings plain = squareSettings(48, 4);
  const std::uint64_t expected = renderOnDevice(scene, plain).film.hash();
  std::vector<render::RenderSettings> others(4, plain);
  others[0].structure.accel = render::AccelKind::grid;
  others[1].structure.accel = render::AccelKind::none;
  others[2].structure.bvhLayout = render::BvhLayout::cwbvh;
  others[3].execution.kernel = render::KernelKind::wavefront;
  for (std::size_t i = 0; i < others.size(); ++i) {
    CAPTURE(i);
    CHECK(renderOnDevice(scene, others[i]).film.hash() == expected);
  }
}

TEST_CASE("views see through transparent triangles as paths do", "[swiftshader-slow]") {
  for (const render::Integrator view :
       {render::Integrator::ao, render::Integrator::albedo, render::Integrator::depth}) {
    render::RenderSettings settings = squareSettings(64, 1);
    settings.image.integrator = view;
    checkPixelsAgree(sheets(), settings);
  }
}

TEST_CASE("surfaces behind sheets are attenuated by the product of their transmittances") {
  onBothTracers([](const RenderFunction& render) {
    const std::vector<scene::Opacity> opacities{{.factor = 0.25f}, {.factor = 0.5f}, {.factor = 0.125f}};
    const double mean = meanLuminance(render(wallBehind(opacities).scene, squareSettings(16, 256)).film);
    CHECK(mean == Approx(0.75 * 0.5 * 0.875).epsilon(0.01));
  });
}

TEST_CASE("a sheet lets shadow rays pass with probability 1 - alpha") {
  onBothTracers([](const RenderFunction& render) {
    const auto lit = [&](bool covered) {
      SceneBuilder b;
      b.material(diffuseMaterial(vec3(1))).plane({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
      if (covered)
        add(b, diffuseMaterial(vec3(0)), {.factor = 0.3f}, parallelogram({-9, -9, 5}, {18, 0, 0}, {0, 18, 0}));
      b.pointLight({0, 0, 6}, vec3(1));
      b.view({0, -2, 3}, {0, 0, 0}, {0, 0, 1}, 20);
      return meanLuminance(render(b.scene, squareSettings(16, 256)).film);
    };
    CHECK(lit(true) / lit(false) == Approx(0.7).epsilon(0.01));
  });
}

TEST_CASE("a mask cuts where interpolated alpha reaches the cutoff") {
  const scene::TextureReference clamped{.wrapS = scene::TextureWrap::clampToEdge,
                                        .wrapT = scene::TextureWrap::clampToEdge};
  SceneBuilder b = wallBehind({{.factor = 0.8f, .cutoff = 0.3f, .texture = clamped}});
  b.scene.images = {{"", 2, 1, {0x00ffffffu, 0xffffffffu}}};
  b.view({0, 0, 5}, {0, 0, 0}, {0, 1, 0}, 0.02f);
  onBothTracers([&](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(1, 1);
    settings.image.integrator = render::Integrator::id;
    settings.image.size = {512, 1};
    const image::Image seen = image::toImage(render(b.scene, settings).film);
    int passed = 0;
    for (std::uint32_t x = 0; x < 512; ++x) passed += seen.at(x, 0) == seen.at(0, 0);
    // Alpha is 0.8 s' with s' from 0 at s = 1/4 to 1 at s = 3/4: the cutoff is at s = 1/4 + 0.375 / 2.
    const double half = 5 * std::tan(glm::radians(0.01)) * 512;  // of the width of the view
    const double edge = 2 * (0.25 + 0.375 / 2) - 1;
    CHECK(passed == Approx(256 + edge / half * 256).margin(1.5));
  });
}

TEST_CASE("a mask whose alpha equals the cutoff is opaque, and one just below is not there") {
  onBothTracers([](const RenderFunction& render) {
    const auto seen = [&](float alpha) {
      return meanLuminance(render(wallBehind({{.factor = alpha, .cutoff = 0.5f}}).scene, squareSettings(8, 1)).film);
    };
    CHECK(seen(0.5f) == 0);
    CHECK(seen(std::nextafter(0.5f, 0.0f)) == Approx(1));
  });
}

TEST_CASE("light sampling of a transparent emitter has the mean of paths without it", "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    render::RenderSettings settings = squareSettings(24, 1024);
    const double sampled = meanLuminance(render(sheets(), settings).film);
    settings.image.nextEventEstimation = false;
    settings.image.sampleCount = 4096;
    scene::Scene scene = sheets();
    scene.pointLights.clear();
    const double found = meanLuminance(render(scene, settings).film);
    settings.image.nextEventEstimation = true;
    settings.image.sampleCount = 1024;
    CHECK(meanLuminance(render(scene, settings).film) == Approx(found).epsilon(0.02));
    CHECK(sampled > found);
  });
}
