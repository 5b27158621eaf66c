// Samples of lights, compared with their densities: docs/light-transport.md section 6.
#include <catch2/catch.hpp>

#include "host/image/film.h"
#include "tests/formats/loading/triangles.h"
#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

constexpr std::size_t kLightSamples = 1000000;
constexpr int kLightSide = 32;

const std::vector<glm::vec3>& manyNumbers() {
  static const std::vector<glm::vec3> numbers = randomNumbers(kLightSamples, 301);
  return numbers;
}

// Two axes across a direction.
std::pair<dvec3, dvec3> axesAcross(const dvec3& axis) {
  const dvec3 first = normalize(cross(axis, std::abs(axis.x) < 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
  return {first, cross(axis, first)};
}

// Returns the normal whose length is the triangle's area.
dvec3 areaNormalOf(const scene::Triangle& triangle) {
  const dvec3 origin(triangle.p[0]);
  return cross(dvec3(triangle.p[1]) - origin, dvec3(triangle.p[2]) - origin) / 2.0;
}

// Maps the weights of a triangle to the unit square: see the proof of the warp.
dvec2 placeInTriangle(const dvec3& point, const scene::Triangle& triangle) {
  const dvec3 origin(triangle.p[0]), edge1 = dvec3(triangle.p[1]) - origin, edge2 = dvec3(triangle.p[2]) - origin;
  const dvec3 normal = cross(edge1, edge2), across = point - origin;
  const double b1 = dot(cross(across, edge2), normal) / dot(normal, normal);
  const double b2 = dot(cross(edge1, across), normal) / dot(normal, normal);
  return {(b1 + b2) * (b1 + b2), b2 / (b1 + b2)};
}

// A sphere far off, one nearly touched, and two triangles, one behind the other's plane. The origin sees them all.
const scene::Scene& lamps() {
  static const scene::Scene scene = [] {
    SceneBuilder b;
    b.material(diffuseMaterial(vec3(1), vec3(2, 3, 4)));
    b.sphere({1, 2, 3}, 0.5f).sphere({-2, 0.5f, -1}, 2.25f);
    b.triangle({0, 1, -2}, {2, 0.5f, -2.5f}, {1, 2, -1}).triangle({3, -1, 0.5f}, {3, -1, 2}, {3.5f, -3, 1});
    return b.scene;
  }();
  return scene;
}

double probabilityOf(std::uint32_t entry) {
  std::vector<double> weights;
  for (const scene::Sphere& sphere : lamps().spheres)
    weights.push_back(4 * std::numbers::pi * sphere.radius * sphere.radius);
  for (const scene::Triangle& triangle : trianglesOf(lamps())) weights.push_back(length(areaNormalOf(triangle)));
  return weights[entry] / (weights[0] + weights[1] + weights[2] + weights[3]);
}

// Relative error that a density may have: rounding, and the table's probabilities, which are multiples of 2^-24.
double densityTolerance(std::uint32_t entry) { return 30 * kRounding + 0x1p-24 / probabilityOf(entry); }

}  // namespace

TEST_CASE("samples of a sphere are uniform in the cap of directions that it subtends") {
  const LightLeaves lights(lamps());
  for (const std::uint32_t entry : {0u, 1u}) {
    CAPTURE(entry);
    const dvec3 centre(lamps().spheres[entry].centre);
    const double radius = lamps().spheres[entry].radius;
    const double height = 1 - std::sqrt(1 - radius * radius / dot(centre, centre));
    const auto [right, up] = axesAcross(normalize(centre));
    const double expectedPdf = probabilityOf(entry) / (2 * std::numbers::pi * height);
    Cells cells(kLightSide, kLightSide);
    double worstPdf = 0, worstPoint = 0;
    for (const LitPoint& lit : lights.sample(entry, {}, manyNumbers())) {
      if (lit.pdf == 0) {  // rounding at the silhouette
        cells.addOutside();
        continue;
      }
      cells.add({(1 - dot(lit.wi, normalize(centre))) / height, turns(dot(lit.wi, right), dot(lit.wi, up))});
      worstPdf = std::max(worstPdf, std::abs(lit.pdf / expectedPdf - 1));
      worstPoint = std::max(worstPoint, std::abs(length(lit.distance * lit.wi - centre) / radius - 1));
    }
    std::vector<double> expected = uniformCounts(kLightSide, kLightSide, kLightSamples);
    CHECK(cells.counts().back() <= kLightSamples * kRounding);  // lost at the silhouette, without effect on the test
    expected[0] -= cells.counts().back();
    expected.back() += cells.counts().back();
    checkCounts(cells.counts(), expected);
    CHECK(worstPdf < densityTolerance(entry));
    CHECK(worstPoint < 1e-3);  // grazing rays hit it near the expected point
  }
}

TEST_CASE("all directions are sampled uniformly from inside a sphere and from its own surface") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1))).sphere({0, 0, 3}, 1);
  const LightLeaves lights(b.scene);
  for (const bool onLight : {false, true}) {
    CAPTURE(onLight);
    const Viewpoint from{onLight ? dvec3(0, 0, 2) : dvec3(0.25, 0.5, 3.25), onLight};
    Cells cells(kLightSide, kLightSide);
    for (const LitPoint& lit : lights.sample(0, from, manyNumbers())) {
      if (lit.pdf == 0) {
        cells.addOutside();
        continue;
      }
      REQUIRE(lit.pdf == Approx(1 / (4 * std::numbers::pi)));
      REQUIRE(length(from.position + lit.distance * lit.wi - dvec3(0, 0, 3)) == Approx(1).margin(kRounding));
      cells.add({(1 + lit.wi.z) / 2, turns(lit.wi.x, lit.wi.y)});
    }
    // From the lowest point of the surface, only directions that point up hit the sphere.
    std::vector<double> expected = uniformCounts(kLightSide, kLightSide, kLightSamples);
    for (std::size_t i = 0; onLight && i < kLightSide * kLightSide / 2; ++i) {
      expected.back() += expected[i];
      expected[i] = 0;
    }
    checkCounts(cells.counts(), expected);
  }
}

TEST_CASE("samples of a triangle are uniform on it, seen from the front and from behind", "[swiftshader-slow]") {
  const LightLeaves lights(lamps());
  for (const std::uint32_t entry : {2u, 3u}) {
    const scene::Triangle triangle = trianglesOf(lamps()).at(entry - 2);
    const dvec3 areaNormal = areaNormalOf(triangle);
    for (const dvec3& from : {dvec3(0), dvec3(4, 3, 5)}) {
      CAPTURE(entry, from.x);
      Cells cells(kLightSide, kLightSide);
      double worstPdf = 0;
      for (const LitPoint& lit : lights.sample(entry, {from}, manyNumbers())) {
        REQUIRE(lit.pdf > 0);
        cells.add(placeInTriangle(from + lit.distance * lit.wi, triangle));
        // Per solid angle: distance^2 / (area cos).
        const double expected = probabilityOf(entry) * lit.distance * lit.distance / std::abs(dot(areaNormal, lit.wi));
        worstPdf = std::max(worstPdf, std::abs(lit.pdf / expected - 1));
      }
      checkCounts(cells.counts(), uniformCounts(kLightSide, kLightSide, kLightSamples));
      CHECK(worstPdf < densityTolerance(entry));
    }
  }
}

TEST_CASE("the densities of light sampling integrate to the probability of choosing the light") {
  const LightLeaves lights(lamps());
  const std::vector<dvec3> directions = latticeDirections(kLightSamples);
  for (std::uint32_t entry = 0; entry < 4; ++entry) {
    double integral = 0;
    for (const FoundLight& found : lights.find(entry, {}, directions)) integral += found.pdf;
    integral *= 4 * std::numbers::pi / static_cast<double>(directions.size());
    CAPTURE(entry);
    CHECK(integral == Approx(probabilityOf(entry)).epsilon(2e-3));
  }
}

TEST_CASE("a light that is hit in the direction of a sample has the density and the distance of the sample") {
  const LightLeaves lights(lamps());
  for (std::uint32_t entry = 0; entry < 4; ++entry) {
    const std::vector<LitPoint> samples = lights.sample(entry, {}, randomNumbers(20000, 305));
    std::vector<dvec3> directions;
    for (const LitPoint& lit : samples) directions.push_back(lit.wi);
    const std::vector<FoundLight> found = lights.find(entry, {}, directions);
    int lost = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (found[i].pdf == 0 || samples[i].pdf == 0) {  // at the silhouette
        ++lost;
        continue;
      }
      CAPTURE(entry, i);
      REQUIRE(found[i].pdf == Approx(samples[i].pdf).epsilon(100 * kRounding));
      REQUIRE(found[i].distance == Approx(samples[i].distance).epsilon(1e-3));
      REQUIRE(length(samples[i].emission - dvec3(2, 3, 4)) == 0);
    }
    CHECK(lost <= 2);
  }
}

TEST_CASE("lights are chosen by power, emitters or point lights by flux, and never one of weight 0") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1, 2, 3))).sphere({0, 0, 0}, 0.5f);
  b.material(diffuseMaterial(vec3(1), vec3(9, 1, 0.5f)));
  b.triangle({0, 0, 1}, {1, 0, 1}, {0, 3, 1}).triangle({0, 0, 2}, {1, 0, 2}, {0, 0.125f, 2});
  b.pointLight({0, 0, 5}, {0.2f, 0.2f, 0.2f}).pointLight({0, 0, 6}, vec3(0)).pointLight({0, 0, 7}, {0, 0, 1});
  const double first = image::luminance({1, 2, 3}), second = image::luminance({9, 1, 0.5});
  const double emitters[] = {std::numbers::pi * first, 1.5 * second, 0.0625 * second}, points[] = {0.2, 0, 0.0722};
  const double emitterSum = emitters[0] + emitters[1] + emitters[2], pointSum = points[0] + points[2];
  const double squaredRadius = (1.5 * 1.5 + 3.5 * 3.5 + 2.5 * 2.5) / 4;  // of the box from -1/2 to (1, 3, 2)
  const double pointFlux = std::numbers::pi * squaredRadius * pointSum;
  const double ofPoints = 0.2 + 0.6 * pointFlux / (emitterSum + pointFlux);
  std::vector<double> shares;
  for (const double weight : emitters) shares.push_back(weight / emitterSum * (1 - ofPoints));
  for (const double weight : points) shares.push_back(weight / pointSum * ofPoints);

  std::vector<std::uint32_t> words;
  for (const glm::vec3& u : manyNumbers()) words.push_back(static_cast<std::uint32_t>(u.x * 0x1p24f) << 8 | 0xabu);
  std::vector<double> counts(shares.size()), expected;
  for (const double share : shares) expected.push_back(share * static_cast<double>(words.size()));
  for (const ChosenLight& chosen : LightLeaves(b.scene).choose(words)) {
    REQUIRE(chosen.entry < shares.size());
    REQUIRE(chosen.probability == Approx(shares[chosen.entry]).margin(0x1p-23));
    ++counts[chosen.entry];
  }
  checkCounts(counts, expected);
}
