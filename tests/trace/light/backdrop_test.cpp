// Backdrops on both tracers: the backdrop does not change the light, and alpha is the exact count of the samples
// that hit.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "host/base/errors.h"
#include "host/judge/verify/agreement.h"
#include "host/scene/environment/placement.h"
#include "host/scene/environment/weights.h"
#include "tests/trace/reference/scene_builder.h"
#include "tests/trace/render/both_tracers.h"

using namespace candela;
using namespace candela::device;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

constexpr std::uint64_t kOne = std::uint64_t{1} << 40;  // of the film's sums

std::uint64_t wordsOf(const image::FixedSum& sum) { return std::uint64_t{sum[1]} << 32 | sum[0]; }

// A diffuse ball, a glass ball, a mirror, a sheet that blends, and nothing around, under light of radiance 1.
SceneBuilder objectsBeforeNothing() {
  SceneBuilder b;
  b.material(diffuseMaterial({0.7f, 0.5f, 0.3f})).sphere({-1, 0, 0}, 0.8f);
  b.material(test::glassMaterial(vec3(0.9f), 1.5f)).sphere({1, 0, 0}, 0.7f);
  b.material(test::mirrorMaterial(vec3(0.9f))).quad({-1, -2, 0}, {1, -2, 0}, {1, -1, -1}, {-1, -1, -1});
  scene::Material sheet = diffuseMaterial(vec3(0.4f));
  sheet.opacity = scene::Opacity{.factor = 0.25f};
  b.material(sheet).quad({-2, 1, 0}, {2, 1, 0}, {2, 2, 0}, {-2, 2, 0});
  b.view({0, 0, 9}, {0, 0, 0}, {0, 1, 0}, 40);
  b.scene.background = vec3(1);
  b.scene.name = "before nothing";
  return b;
}

scene::Environment whiteMap(const vec3& radiance) {
  scene::Environment map{.name = "white", .width = 4, .height = 2, .texels = std::vector(8, radiance), .weights = {}};
  environment::setWeights(map);
  environment::place(map, {0, 1, 0}, 0);
  return map;
}

render::RenderSettings backdropSettings(render::Backdrop backdrop, std::uint32_t samples = 8) {
  render::RenderSettings settings = squareSettings(32, samples);
  settings.image.backdrop = backdrop;
  return settings;
}

// The sums of a pixel differ by those of camera rays that miss: `radiance` for each.
void requireMissesAdded(const image::Film& with, const image::Film& without, double radiance) {
  int partly = 0;
  for (std::size_t i = 0; i < with.pixels().size(); ++i) {
    const image::FilmPixel& hidden = without.pixels()[i];
    REQUIRE(hidden.hitCount <= hidden.sampleCount);
    const std::uint64_t misses = hidden.sampleCount - hidden.hitCount;
    partly += misses > 0 && hidden.hitCount > 0;
    REQUIRE(wordsOf(with.pixels()[i].red) - wordsOf(hidden.red) ==
            misses * static_cast<std::uint64_t>(radiance * static_cast<double>(kOne)));
    REQUIRE(with.pixels()[i].hitCount == 0);
  }
  CHECK(partly > 20);
}

}  // namespace

TEST_CASE("a hidden background takes its radiance from the samples that miss, and from no other",
          "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b = objectsBeforeNothing();
    for (const bool hasMap : {false, true}) {
      if (hasMap) b.scene.environment = whiteMap(vec3(1));
      const image::Film seen = render(b.scene, backdropSettings(render::Backdrop::environment)).film;
      const image::Film hidden = render(b.scene, backdropSettings(render::Backdrop::none)).film;
      requireMissesAdded(seen, hidden, 1);
      if (!hasMap) continue;
      b.scene.background = vec3(0.25f, 0.5f, 0.75f);
      const image::Film coloured = render(b.scene, backdropSettings(render::Backdrop::colour)).film;
      requireMissesAdded(coloured, hidden, 0.25);
    }
  });
}

TEST_CASE("alpha is the part of a pixel that is covered: of a ball, and of a sheet that blends", "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    SceneBuilder b;
    b.material(test::glassMaterial(vec3(0.9f), 1.5f))
        .sphere({0, 0, 0}, 1);  // the refracted background is not a backdrop
    b.view({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 60);
    const auto meanAlpha = [&](const scene::Scene& scene, std::uint32_t maxDepth = 64) {
      render::RenderSettings settings = backdropSettings(render::Backdrop::none, 64);
      settings.image.maxDepth = maxDepth;
      const image::Film film = render(scene, settings).film;
      double sum = 0;
      for (std::uint32_t y = 0; y < 32; ++y) {
        for (std::uint32_t x = 0; x < 32; ++x) sum += film.alpha(x, y);
      }
      return sum / (32 * 32);
    };
    // The cone of the ball has the sine 1/4, and meets the plane at distance 4 in a circle; the view is 8 tan(30) wide.
    const double radius = 4 * std::tan(std::asin(0.25));
    const double side = 8 / std::sqrt(3.0);
    CHECK(meanAlpha(b.scene) == Approx(std::numbers::pi * radius * radius / (side * side)).epsilon(2e-3));
    CHECK(meanAlpha(b.scene, 1) == meanAlpha(b.scene));  // paths that end where they first hit count, too
    SceneBuilder covered;
    covered.view({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 60);
    scene::Material sheet = diffuseMaterial(vec3(0.4f));
    sheet.opacity = scene::Opacity{.factor = 0.375f};
    covered.material(sheet).quad({-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0});
    CHECK(meanAlpha(covered.scene) == Approx(0.375).epsilon(0.01));
  });
}

TEST_CASE("backdrops have the reference's pixels, and the wavefront the megakernel's film", "[swiftshader-slow]") {
  SceneBuilder b = objectsBeforeNothing();
  b.scene.environment = whiteMap({0.75f, 1, 0.5f});
  b.scene.background = vec3(0.125f, 0.25f, 0.5f);
  for (const auto backdrop : {render::Backdrop::none, render::Backdrop::colour}) {
    render::RenderSettings settings = backdropSettings(backdrop, 1);
    settings.image.size = {64, 64};
    const render::RenderResult onDevice = renderOnDevice(b.scene, settings);
    const render::RenderResult onReference = renderOnReference(b.scene, settings);
    const verify::PixelAgreement pixels = verify::comparePixels(onDevice, onReference);
    CAPTURE(pixels.equalFraction(), pixels.litEqualFraction(), pixels.lit);
    CHECK(pixels.lit > pixels.pixels / 10);
    CHECK(pixels.equalFraction() >= kRequiredEqualFraction);
    CHECK(pixels.litEqualFraction() >= kRequiredLitEqualFraction);
    const image::Film& device = onDevice.film;
    const image::Film& reference = onReference.film;
    std::size_t otherHits = 0;
    for (std::size_t i = 0; i < device.pixels().size(); ++i) {
      otherHits += device.pixels()[i].hitCount != reference.pixels()[i].hitCount;
    }
    CHECK(otherHits <= 2);  // rays within rounding of a silhouette

    settings.image.sampleCount = 4;
    for (const bool isTransparent : {true, false}) {
      scene::Scene scene = b.scene;
      if (!isTransparent) scene.materials.back().opacity.reset();
      settings.execution.kernel = render::KernelKind::megakernel;
      const image::Film film = renderOnDevice(scene, settings).film;
      settings.execution.kernel = render::KernelKind::wavefront;
      CHECK(renderOnDevice(scene, settings).film.hash() == film.hash());
    }
  }
}

TEST_CASE("other integrators have no backdrop", "[swiftshader-slow]") {
  onBothTracers([](const RenderFunction& render) {
    render::RenderSettings settings = backdropSettings(render::Backdrop::none);
    settings.image.integrator = render::Integrator::depth;
    CHECK_THROWS_AS(render(objectsBeforeNothing().scene, settings), UsageError);
  });
}
