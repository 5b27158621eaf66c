// Normal maps of the reference, compared with values computed by hand.
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/trace/reference/normal_map.h"
#include "host/trace/reference/sampling.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;

namespace {

// A triangle that faces up, with tangents along y and handedness -1, and one texel.
scene::Scene mappedTriangle(std::uint32_t texel, float scale) {
  scene::Scene scene;
  scene.images = {{"", 1, 1, {texel}}};
  scene::Material material;
  material.surface.emplace();
  material.textures[static_cast<std::size_t>(scene::TextureSlot::normal)].emplace();
  material.normalScale = scale;
  scene.materials = {material};
  scene::Mesh mesh;
  mesh.positions = {{-4, -4, 0}, {4, -4, 0}, {0, 4, 0}};
  mesh.texCoords[0] = {{0, 0}, {1, 0}, {0, 1}};
  mesh.tangents.assign(3, {0, 1, 0, -1});
  addMesh(scene, mesh, 0);
  return scene;
}

Surface surfaceOf(const scene::Scene& scene, double height) {
  const Ray ray{{0, -1, height}, {0, 0, height > 0 ? -1 : 1}};
  Arithmetic exact;
  Surface surface = surfaceAt(scene, ray, {std::abs(height), 0});
  applyNormalMap({scene, exact}, scene::TextureSlot::normal, ray.direction, surface);
  return surface;
}

constexpr std::uint32_t kTexel = 0xff0000ffu | 204u << 8 | 230u << 16;  // 255 204 230: 1, 0.6, 0.8039...

}  // namespace

TEST_CASE("a normal map turns the normal towards tangent and bitangent") {
  const Surface surface = surfaceOf(mappedTriangle(kTexel, 0.5f), 3);
  // T = (0 1 0), B = -(0 0 1) x (0 1 0) = (1 0 0)
  const dvec3 expected = normalize(dvec3(0.5 * 0.6, 0.5 * 1, 230 / 127.5 - 1));
  CHECK(surface.isMapped);
  CHECK(length(surface.shadingNormal - expected) < 1e-12);
  CHECK(surface.facingNormal == dvec3(0, 0, 1));
}

TEST_CASE("the other side of a surface has the opposite of the mapped normal") {
  const scene::Scene scene = mappedTriangle(kTexel, 1);
  CHECK(length(surfaceOf(scene, 3).shadingNormal + surfaceOf(scene, -3).shadingNormal) < 1e-12);
}

TEST_CASE("a mapped normal below the surface is mirrored at it") {
  const Surface surface = surfaceOf(mappedTriangle(0xff0080ffu, 1), 3);  // z = -1
  CHECK(surface.shadingNormal.z == Approx(1 / std::sqrt(2 + std::pow(128 / 127.5 - 1, 2))));
  CHECK(surface.shadingNormal.y > 0.7);
}

TEST_CASE("without tangents a normal map has no effect") {
  scene::Scene scene = mappedTriangle(kTexel, 1);
  scene.meshes[0].tangents.clear();
  CHECK_FALSE(surfaceOf(scene, 3).isMapped);
}

TEST_CASE("facets are seen in proportion to their projected areas") {
  // A facet that is tilted by 45 degrees to the right.
  const double half = std::sqrt(0.5);
  const NormalMapFacets facets(dvec3(-half, 0, half));  // the geometric normal in the facet's frame
  const auto local = [&](double angle) {                // from the geometric normal to the right
    return dvec3(std::sin(angle - 0.25 * 3.14159265358979), 0, std::cos(angle - 0.25 * 3.14159265358979));
  };
  CHECK(facets.directProbability(local(0)) == Approx(1));
  CHECK(facets.directProbability(local(0.5)) == 1);
  CHECK(facets.directProbability(local(-0.25 * 3.14159265358979)) == Approx(0).margin(1e-12));
  // The facet's length is sqrt 2, its neighbour's 1: seen from -0.3, they are sqrt 2 cos(pi/4 + 0.3) and sin 0.3 wide.
  const double direct = std::sqrt(2.0) * std::cos(0.25 * 3.14159265358979 + 0.3);
  CHECK(facets.directProbability(local(-0.3)) == Approx(direct / (direct + std::sin(0.3))));
  CHECK(length(facets.seenByReflection(local(-0.3)) - local(0.3)) < 1e-12);
  CHECK(length(facets.mirrored(local(2)) - local(3.14159265358979 - 2)) < 1e-12);
}

TEST_CASE("directions below the surface are scattered again by the cosine to its normal") {
  // Uniform points of the disc about the facet that are below the surface become uniform points of the disc about it:
  // each of 4 rings of equal area and 4 quarters has a sixteenth of them.
  const dvec3 geometric = normalize(GENERATE(dvec3(-0.6, 0, 0.8), dvec3(0.3, -0.8, 0.4)));
  const NormalMapFacets facets(geometric);
  const dvec3 x = normalize(cross(geometric, dvec3(0.2, 0.9, 0.1))), y = cross(geometric, x);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit;
  std::array<int, 16> counts{};
  constexpr int kCount = 32000;
  for (int found = 0; found < kCount;) {
    const dvec3 w = sampleCosineHemisphere({unit(random), unit(random)});
    if (facets.isOn(Side::reflection, w)) continue;
    ++found;
    const dvec3 again = facets.scatteredAgain(w);
    REQUIRE(length(again) == Approx(1));
    REQUIRE(facets.isOn(Side::reflection, again));
    const double cosine = dot(again, geometric);
    const auto ring = static_cast<std::size_t>(4 * std::min(1 - cosine * cosine, 0.9999999));
    const std::size_t quarter = (dot(again, x) > 0 ? 2 : 0) + (dot(again, y) > 0 ? 1 : 0);
    ++counts[4 * ring + quarter];
  }
  for (const int count : counts) CHECK(std::abs(count - kCount / 16) < 5 * std::sqrt(kCount / 16));
}

TEST_CASE("directions at the horizon stay, and deeper ones rise on the way to the opposite horizon") {
  const NormalMapFacets facets(normalize(dvec3(-0.6, 0, 0.8)));
  // Below the horizon, at 0.8 0 0.6 in the facet's frame, by an angle; the facet's own horizon is 36.87 degrees deep.
  const auto again = [&](double angle) {
    const double rise = std::asin(0.6) - angle;
    return facets.scatteredAgain({std::cos(rise), 0, std::sin(rise)});
  };
  CHECK(length(again(0) - dvec3(0.8, 0, 0.6)) < 1e-7);
  CHECK(length(again(std::asin(0.6)) - dvec3(-0.8, 0, -0.6)) < 1e-7);
  CHECK(again(0.01).x > again(0.1).x);
  CHECK(dot(again(0.1), dvec3(-0.6, 0, 0.8)) > 0.5);
}
