// Exact Fresnel reflectance on the device and in the reference, compared with closed forms that neither computes. (Some
// programs divide integers to compute the reflectance at normal incidence, so that their glass never reflects; these
// cases would detect it.)
#include "host/trace/reference/fresnel.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

#include "spirv/fresnel_leaf.h"
#include "tests/trace/device/run_leaf.h"

using namespace candela;
using namespace candela::device;

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// A ray that hits a boundary; `index` is the index of refraction on its far side divided by that on the near side.
struct Incidence {
  double angle;
  double index;
};

std::vector<double> onDevice(const std::vector<Incidence>& rays) {
  std::vector<glm::vec2> inputs;
  for (const Incidence& ray : rays) inputs.push_back({std::cos(ray.angle), ray.index});
  const auto outputs = runLeaf<glm::vec2>(spirv::fresnel_leaf, inputs, rays.size(),
                                          {static_cast<std::uint32_t>(rays.size()), 0});
  std::vector<double> values;
  for (const glm::vec2& output : outputs) values.push_back(output.x);
  return values;
}

std::vector<double> onReference(const std::vector<Incidence>& rays) {
  std::vector<double> values;
  for (const Incidence& ray : rays)
    values.push_back(reference::fresnel(std::cos(ray.angle), 1 / ray.index).reflectance);
  return values;
}

using Evaluate = std::function<std::vector<double>(const std::vector<Incidence>&)>;

void onBothSides(const std::function<void(const Evaluate&)>& body) {
  SECTION("device") { body(onDevice); }
  SECTION("reference") { body(onReference); }
}

// Fresnel's original form, by angles; not for normal incidence.
double byAngles(const Incidence& ray) {
  const double refracted = std::asin(std::sin(ray.angle) / ray.index);
  const double sine = std::sin(ray.angle - refracted) / std::sin(ray.angle + refracted);
  const double tangent = std::tan(ray.angle - refracted) / std::tan(ray.angle + refracted);
  return (sine * sine + tangent * tangent) / 2;
}

}  // namespace

TEST_CASE("at normal incidence glass reflects ((n - 1) / (n + 1))^2") {
  onBothSides([](const Evaluate& evaluate) {
    const auto values = evaluate({{0, 1.5}, {0, 1 / 1.5}, {0, 1.1}, {0, 2.4}});
    CHECK(values[0] == Approx(0.04).epsilon(1e-5));
    CHECK(values[1] == Approx(0.04).epsilon(1e-5));
    CHECK(values[2] == Approx(1.0 / 441).epsilon(1e-5));
    CHECK(values[3] == Approx(std::pow(1.4 / 3.4, 2)).epsilon(1e-5));
  });
}

TEST_CASE("at Brewster's angle only perpendicularly polarised light is reflected") {
  onBothSides([](const Evaluate& evaluate) {
    for (const double n : {1.5, 1 / 1.5, 1.1, 2.4}) {
      const double expected = std::pow((n * n - 1) / (n * n + 1), 2) / 2;
      CHECK(evaluate({{std::atan(n), n}})[0] == Approx(expected).epsilon(1e-5));
    }
  });
}

TEST_CASE("everything is reflected at grazing incidence and beyond the critical angle, but not below it") {
  onBothSides([](const Evaluate& evaluate) {
    const double critical = std::asin(1 / 1.5);
    const auto values = evaluate(
        {{89.999 * kDegree, 1.5}, {critical + 1e-3, 1 / 1.5}, {60 * kDegree, 1 / 1.5}, {critical - 1e-3, 1 / 1.5}});
    CHECK(values[0] == Approx(1).margin(1e-3));
    CHECK(values[1] == 1);
    CHECK(values[2] == 1);
    CHECK(values[3] < 0.9);
    CHECK(values[3] == Approx(byAngles({critical - 1e-3, 1 / 1.5})).epsilon(1e-3));
  });
}

TEST_CASE("a boundary with a relative index of 1 reflects nothing") {
  onBothSides([](const Evaluate& evaluate) {
    for (const double value : evaluate({{0, 1}, {30 * kDegree, 1}, {89 * kDegree, 1}})) CHECK(value == 0);
  });
}

TEST_CASE("the reflectance at other angles is that of Fresnel's form by angles, into and out of glass") {
  std::vector<Incidence> rays;
  for (const double index : {1.1, 1.33, 1.5, 2.4, 1 / 1.1, 1 / 1.5}) {
    for (double angle = 1; angle < 89; angle += 2.5) {
      if (std::sin(angle * kDegree) < 0.99 * index) rays.push_back({angle * kDegree, index});
    }
  }
  REQUIRE(rays.size() > 150);
  onBothSides([&](const Evaluate& evaluate) {
    const auto values = evaluate(rays);
    for (std::size_t i = 0; i < rays.size(); ++i) {
      CAPTURE(rays[i].angle, rays[i].index);
      CHECK(values[i] == Approx(byAngles(rays[i])).epsilon(2e-5).margin(1e-7));
    }
  });
}
