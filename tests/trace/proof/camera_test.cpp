// Images of a point and of an edge: a lens' circle of confusion, and pixel filters.
#include <catch2/catch.hpp>

#include "host/trace/render/setting_names.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

// Settings that show only what camera rays hit.
render::RenderSettings directView(std::uint32_t side, std::uint32_t samples) {
  render::RenderSettings settings = test::settingsOf(side, side, samples);
  settings.image.maxDepth = 1;
  settings.image.nextEventEstimation = false;
  return settings;
}

// The camera at the origin looks along -z at the plane at distance 1.
SceneBuilder cameraOf(float angle) {
  SceneBuilder b;
  b.view({0, 0, 0}, {0, 0, -1}, {0, 1, 0}, angle).material(diffuseMaterial(vec3(0), vec3(1)));
  return b;
}

// A glowing rectangle that faces the camera.
void addRectangle(SceneBuilder& b, const dvec2& low, const dvec2& high, double distance) {
  const auto corner = [&](double x, double y) { return vec3(dvec3(x, y, -distance)); };
  b.quad(corner(low.x, low.y), corner(high.x, low.y), corner(high.x, high.y), corner(low.x, high.y));
}

struct Moments {
  double total = 0;
  dvec2 mean{0};
  double spread = 0;    // mean squared distance from the mean
  double farthest = 0;  // distance from the mean
};

// Returns the moments of an image's light over the positions of its pixel centres.
Moments momentsOf(const image::Film& film) {
  Moments moments;
  const auto forEachPixel = [&](const auto& body) {
    for (std::uint32_t y = 0; y < film.height(); ++y) {
      for (std::uint32_t x = 0; x < film.width(); ++x) body(dvec2(x + 0.5, y + 0.5), film.mean(x, y).y);
    }
  };
  forEachPixel([&](const dvec2& place, double light) {
    moments.total += light;
    moments.mean += light * place;
  });
  moments.mean /= moments.total;
  forEachPixel([&](const dvec2& place, double light) {
    const double distance = length(place - moments.mean);
    moments.spread += light * distance * distance / moments.total;
    if (light > 0) moments.farthest = std::max(moments.farthest, distance);
  });
  return moments;
}

// Distribution functions of the filters, `x` in pixels from the centre.
double boxBelow(double x) { return std::clamp(x + 0.5, 0.0, 1.0); }
double gaussianBelow(double x) {  // of standard deviation 1
  const double inside = std::clamp(x, -4.0, 4.0);
  const auto integral = [](double y) {
    return std::sqrt(std::numbers::pi / 2) * std::erf(y / std::sqrt(2.0)) - y * std::exp(-8.0);
  };
  return 0.5 + integral(inside) / (2 * integral(4));
}
double tentBelow(double x) {
  const double inside = std::clamp(x, -1.0, 1.0);
  return inside < 0 ? (1 + inside) * (1 + inside) / 2 : 1 - (1 - inside) * (1 - inside) / 2;
}

}  // namespace

TEST_CASE("a point out of focus is spread uniformly over its circle of confusion, or over the square of a square lens",
          "[swiftshader-slow]") {
  constexpr std::uint32_t kSide = 64;
  constexpr double kFocus = 2, kDistance = 1.25, kAperture = 40;
  // A point at distance z is spread over the lens' radius times |z - F| / z in the plane in focus, whose pixels are F
  // times as large as those at distance 1, in which the aperture is measured.
  constexpr double kRadius = kAperture * (kFocus - kDistance) / kDistance / kFocus;
  constexpr double kPointSide = 10;  // the point is a square with this side in pixels

  SceneBuilder b = cameraOf(30);
  b.scene.camera->aperture = kAperture;
  b.scene.camera->focal = kFocus;
  b.scene.camera->width = b.scene.camera->height = kSide;
  const double pixel = 2 * std::tan(std::numbers::pi / 12) / kSide * kDistance;  // at the point's distance
  const dvec2 place(7, -4);                                                      // in pixels from the image's centre
  addRectangle(b, pixel * (place - kPointSide / 2), pixel * (place + kPointSide / 2), kDistance);

  for (const render::LensKind lens : {render::LensKind::disc, render::LensKind::square}) {
    render::RenderSettings settings = directView(kSide, 256);
    settings.image.lens = lens;
    const Moments seen = momentsOf(renderScene(b.scene, settings).film);
    const bool disc = lens == render::LensKind::disc;
    CAPTURE(disc);
    // Variances add up: of lens, square point and the pixels that the image is cut into.
    const double ofLens = disc ? kRadius * kRadius / 2 : 2 * kRadius * kRadius / 3;
    CHECK(seen.spread == Approx(ofLens + 2 * kPointSide * kPointSide / 12 + 2.0 / 12).epsilon(0.01));
    CHECK(seen.total == Approx(kPointSide * kPointSide).epsilon(0.01));
    CHECK(seen.mean.x == Approx(kSide / 2 + place.x).margin(0.2));
    CHECK(seen.mean.y == Approx(kSide / 2 - place.y).margin(0.2));
    const double corner = (disc ? kRadius : kRadius * std::sqrt(2)) + kPointSide / std::sqrt(2);
    CHECK(seen.farthest < corner + 1);
    CHECK(seen.farthest > corner - 3);
  }
}

TEST_CASE("the image of an edge is the pixel filter's distribution function, horizontally and vertically",
          "[swiftshader-slow]") {
  constexpr std::uint32_t kSide = 8;
  const dvec2 edge(3.3, 4.6);  // in pixels from the upper left corner
  SceneBuilder b = cameraOf(40);
  const double height = 2 * std::tan(40 * std::numbers::pi / 360);
  const auto onPlane = [&](const dvec2& raster) {
    return height * (dvec2(raster.x, kSide - raster.y) / double{kSide} - 0.5);
  };
  addRectangle(b, onPlane({-8, edge.y}), onPlane({edge.x, -8}), 1);

  const auto below = [](const render::PixelFilter& filter, double x) {
    if (filter.kind == render::FilterKind::gaussian) return gaussianBelow(x / filter.deviation);
    return filter.kind == render::FilterKind::box ? boxBelow(x) : tentBelow(x);
  };
  using enum render::FilterKind;
  for (const render::PixelFilter& filter : {render::PixelFilter{box}, {tent}, {gaussian}, {gaussian, 0.7f}}) {
    render::RenderSettings settings = directView(kSide, 4096);
    settings.image.filter = filter;
    const image::Film film = renderScene(b.scene, settings).film;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        CAPTURE(render::filterText(filter), x, y);
        const double expected = below(filter, edge.x - x - 0.5) * below(filter, edge.y - y - 0.5);
        CHECK(film.mean(x, y).x == Approx(expected).margin(3e-3));
      }
    }
  }
}

TEST_CASE(
    "a shift moves the image of an edge by parts of the width and the height, in all views and their mirror images",
    "[swiftshader-slow]") {
  constexpr std::uint32_t kSide = 8;
  constexpr double kDistance = 2;
  const dvec2 edge(3.3, 4.6), shift(0.25, -0.15);  // in pixels from the upper left corner, and in parts of the picture
  for (const auto& view : {std::pair(false, false), {true, false}, {false, true}, {true, true}}) {
    const bool isParallel = view.first, isMirrored = view.second;
    SceneBuilder b = cameraOf(40);
    b.scene.camera->isMirrored = isMirrored;
    b.scene.camera->shift = glm::vec2(shift);
    double height = 2 * kDistance * std::tan(40 * std::numbers::pi / 360);
    if (isParallel) b.scene.camera->orthographicHeight = static_cast<float>(height = 3);
    const auto onPlane = [&](const dvec2& raster) {
      const dvec2 seen = raster / double{kSide} + shift;
      return height * dvec2((seen.x - 0.5) * (isMirrored ? -1 : 1), 0.5 - seen.y);
    };
    addRectangle(b, onPlane({-8, edge.y}), onPlane({edge.x, -8}), kDistance);
    const image::Film film = renderScene(b.scene, directView(kSide, 4096)).film;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        CAPTURE(isParallel, isMirrored, x, y);
        CHECK(film.mean(x, y).x == Approx(boxBelow(edge.x - x - 0.5) * boxBelow(edge.y - y - 0.5)).margin(3e-3));
      }
    }
  }
}

TEST_CASE("an orthographic view of an edge is the filter's distribution function, however far away the edge is",
          "[swiftshader-slow]") {
  constexpr std::uint32_t kSide = 8;
  constexpr double kHeight = 3;
  const dvec2 edge(3.3, 4.6);  // in pixels from the upper left corner
  const auto onPlane = [&](const dvec2& raster) {
    return kHeight * (dvec2(raster.x, kSide - raster.y) / double{kSide} - 0.5);
  };
  for (const double distance : {0.25, 1.0, 40.0}) {
    SceneBuilder b = cameraOf(40);
    b.scene.camera->orthographicHeight = static_cast<float>(kHeight);
    addRectangle(b, onPlane({-8, edge.y}), onPlane({edge.x, -8}), distance);
    const image::Film film = renderScene(b.scene, directView(kSide, 4096)).film;
    for (std::uint32_t y = 0; y < kSide; ++y) {
      for (std::uint32_t x = 0; x < kSide; ++x) {
        CAPTURE(distance, x, y);
        CHECK(film.mean(x, y).x == Approx(boxBelow(edge.x - x - 0.5) * boxBelow(edge.y - y - 0.5)).margin(3e-3));
      }
    }
  }
}
