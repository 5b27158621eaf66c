// Camera rays and the background, compared with values computed by hand.
#include <catch2/catch.hpp>
#include <cmath>

#include "host/trace/reference/background.h"
#include "host/trace/reference/camera.h"
#include "host/trace/reference/sampling.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;

namespace {

scene::Camera lookingAtOrigin() {
  scene::Camera camera;
  camera.from = {0, 0, 4};
  camera.angle = 90;  // the view plane is 8 high
  camera.width = 100;
  camera.height = 50;
  return camera;
}

// Returns the point at which a ray crosses the plane at the height `z`.
dvec2 crossing(const Ray& ray, double z) { return dvec2(ray.at((z - ray.origin.z) / ray.direction.z)); }

Ray generate(const scene::Camera& camera, const render::RenderSettings& settings, std::uint32_t x, std::uint32_t y,
             std::uint32_t sample = 0) {
  const Sampler sampler(render::SamplerKind::independent, 0, 1);
  SampleNumbers numbers(sampler, x, y, sample);
  return CameraRays(camera, settings.image).generate(x, y, numbers);
}

}  // namespace

TEST_CASE("the rays of a pixel cross the view plane within the pixel, and row 0 is at the top") {
  const render::RenderSettings settings = test::settingsOf(80, 40, 1);  // pixels of 8 / 40
  for (std::uint32_t sample = 0; sample < 100; ++sample) {
    const dvec2 at = crossing(generate(lookingAtOrigin(), settings, 79, 0, sample), 0);
    CHECK(at.x >= 8 - 0.2);
    CHECK(at.x <= 8);
    CHECK(at.y >= 4 - 0.2);
    CHECK(at.y <= 4);
  }
}

TEST_CASE("the tent filter reaches one pixel to every side of the pixel's centre") {
  render::RenderSettings settings = test::settingsOf(80, 40, 1);
  settings.image.filter.kind = render::FilterKind::tent;
  double least = 9, most = -9;
  for (std::uint32_t sample = 0; sample < 2000; ++sample) {
    const double x = crossing(generate(lookingAtOrigin(), settings, 40, 20, sample), 0).x / 0.2;
    least = std::min(least, x);
    most = std::max(most, x);
  }
  CHECK(least > -0.5);
  CHECK(least < -0.4);
  CHECK(most < 1.5);
  CHECK(most > 1.4);
}

TEST_CASE("rays without jitter pass through pixels' centres, or through the corners of a grid of one pixel less") {
  render::RenderSettings settings = test::settingsOf(5, 3, 1);
  settings.image.integrator = render::Integrator::whitted;
  const auto at = [&](std::uint32_t x, std::uint32_t y) {
    return crossing(generate(lookingAtOrigin(), settings, x, y), 0);
  };
  const auto isNear = [](const dvec2& a, const dvec2& b) { return length(a - b) < 1e-12; };
  // The view is 8 high; centres are 8 / 3 apart, corners 8 / 2.
  CHECK(isNear(at(2, 1), {0, 0}));
  CHECK(isNear(at(4, 0), {2 * 8.0 / 3, 8.0 / 3}));
  settings.image.pixelOrigin = render::PixelOrigin::corner;
  CHECK(isNear(at(2, 1), {0, 0}));
  CHECK(isNear(at(0, 0), {-8, 4}));
  CHECK(isNear(at(4, 2), {8, -4}));
  settings.image.size = {1, 3};  // a single column has its ray at the centre
  CHECK(isNear(at(0, 0), {0, 4}));
}

TEST_CASE("jittered rays are distributed around the corners of pixels") {
  render::RenderSettings settings = test::settingsOf(5, 3, 1);
  settings.image.pixelOrigin = render::PixelOrigin::corner;
  double most = 0;
  for (std::uint32_t sample = 0; sample < 200; ++sample) {
    const dvec2 offset = crossing(generate(lookingAtOrigin(), settings, 0, 0, sample), 0) - dvec2(-8, 4);
    most = std::max({most, std::abs(offset.x), std::abs(offset.y)});
  }
  CHECK(most <= 2);
  CHECK(most > 1.9);
}

TEST_CASE("a lens leaves the plane in focus sharp, and its radius is in pixels of the stated resolution") {
  scene::Camera camera = lookingAtOrigin();
  camera.aperture = 5;  // 5 * 8 / 50 = 0.8
  camera.focal = 1.5f;  // at z = -2
  for (const render::LensKind lens : {render::LensKind::disc, render::LensKind::square}) {
    render::RenderSettings settings = test::settingsOf(4000, 2000, 1);
    settings.image.lens = lens;
    double farthest = 0, widest = 0;
    for (std::uint32_t sample = 0; sample < 3000; ++sample) {
      const Ray ray = generate(camera, settings, 3000, 500, sample);
      CHECK(ray.origin.z == 4);
      CHECK(length(crossing(ray, -2) - dvec2(6, 3)) < 0.02);
      farthest = std::max(farthest, length(dvec2(ray.origin)));
      widest = std::max(widest, std::abs(ray.origin.x));
    }
    const double corner = lens == render::LensKind::disc ? 0.8 : 0.8 * std::sqrt(2);
    CHECK(farthest <= corner * (1 + 1e-6));
    CHECK(farthest > corner * 0.95);
    CHECK(widest > 0.78);
  }
}

TEST_CASE("the rays of an orthographic camera are parallel, and cross the view plane where those of its height do") {
  scene::Camera camera = lookingAtOrigin();
  camera.orthographicHeight = 6.0f;
  render::RenderSettings settings = test::settingsOf(5, 3, 1);
  settings.image.integrator = render::Integrator::whitted;  // without jitter; pixels are 2 apart
  for (const double z : {4.0, 0.0, -7.0}) {
    const auto at = [&](std::uint32_t x, std::uint32_t y) { return crossing(generate(camera, settings, x, y), z); };
    CHECK(length(at(2, 1) - dvec2(0, 0)) < 1e-12);
    CHECK(length(at(4, 0) - dvec2(4, 2)) < 1e-12);
    CHECK(length(at(0, 2) - dvec2(-4, -2)) < 1e-12);
  }
  const Ray ray = generate(camera, settings, 4, 0);
  CHECK(length(ray.origin - dvec3(4, 2, 4)) < 1e-12);
  CHECK(ray.direction == dvec3(0, 0, -1));
  settings.image.pixelOrigin = render::PixelOrigin::corner;
  CHECK(length(crossing(generate(camera, settings, 0, 0), 1) - dvec2(-6, 3)) < 1e-12);
}

TEST_CASE("a lens blurs an orthographic view equally everywhere, and leaves the plane in focus sharp") {
  scene::Camera camera = lookingAtOrigin();
  camera.orthographicHeight = 8.0f;
  camera.aperture = 5;  // 5 * 8 / 50 = 0.8
  camera.focal = 1.5f;  // at z = -2
  const render::RenderSettings settings = test::settingsOf(4000, 2000, 1);
  for (const std::uint32_t column : {100u, 3000u}) {
    const double x = (column + 0.5 - 2000) * 8 / 2000;
    double farthest = 0;
    for (std::uint32_t sample = 0; sample < 3000; ++sample) {
      const Ray ray = generate(camera, settings, column, 500, sample);
      CHECK(length(crossing(ray, -2) - dvec2(x, 1.998)) < 0.01);
      farthest = std::max(farthest, length(crossing(ray, 4) - dvec2(x, 1.998)));
    }
    CHECK(farthest < 0.81);
    CHECK(farthest > 0.76);
  }
}

TEST_CASE("each face of the sky is seen in its direction, the right way up") {
  scene::Scene scene;
  scene.sky.emplace();
  for (std::uint8_t face = 0; face < 6; ++face) {
    // 2 x 2 texels: 40 * face, +10 in the right column, +20 in the lower row.
    std::vector<std::uint8_t> rgb;
    for (std::uint8_t i = 0; i < 4; ++i) rgb.insert(rgb.end(), 3, std::uint8_t(40 * face + 10 * i));
    scene.sky->faces[face] = {2, 2, rgb};
  }
  const Background background(scene);
  const auto valueOf = [](int srgb) {
    const double v = srgb / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  // Directions through a texel's centre, half way to the face's edges.
  const auto seen = [&](double x, double y, double z) { return background.radiance(normalize(dvec3(x, y, z))).y; };
  CHECK(seen(1, 0.5, 0.5) == Approx(valueOf(0)));  // right: its left is +z, top +y
  CHECK(seen(1, -0.5, -0.5) == Approx(valueOf(30)));
  CHECK(seen(-1, 0.5, 0.5) == Approx(valueOf(40 + 10)));  // left: its right is +z
  CHECK(seen(0.5, 1, -0.5) == Approx(valueOf(80)));       // top: its left is +x, its top -z
  CHECK(seen(-0.5, 1, 0.5) == Approx(valueOf(80 + 30)));
  CHECK(seen(0.5, -1, 0.5) == Approx(valueOf(120)));        // bottom: its left is +x, its top +z
  CHECK(seen(-0.5, 0.5, 1) == Approx(valueOf(160 + 10)));   // front: its right is -x
  CHECK(seen(0.5, -0.5, -1) == Approx(valueOf(200 + 30)));  // back: its right is +x
  // Half way between texels, and beyond the outermost centres.
  CHECK(seen(1, 0.5, 0) == Approx((valueOf(0) + valueOf(10)) / 2));
  CHECK(seen(1, 0.9, 0.9) == Approx(valueOf(0)));
}

TEST_CASE("without a sky the background has its colour everywhere") {
  scene::Scene scene;
  scene.background = {1, 2, 3};
  CHECK(Background(scene).radiance({0, 1, 0}) == dvec3(1, 2, 3));
}
