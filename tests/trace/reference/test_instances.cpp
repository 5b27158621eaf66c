// The reference finds in instances what it finds in copies of their mesh: docs/light-transport.md section 4.1.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "host/trace/reference/tracing.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/placed_meshes.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::dmat4;
using glm::vec3;
using test::SceneBuilder;

namespace {

// Adds the triangles of a grid of cells on the square of all c + u x + v y with x and y in [-1, 1].
void addSquare(scene::Mesh& mesh, const vec3& c, const vec3& u, const vec3& v, std::uint32_t cells) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto coordinate = [&](std::uint32_t i) { return 2 * static_cast<float>(i) / static_cast<float>(cells) - 1; };
  for (std::uint32_t y = 0; y <= cells; ++y) {
    for (std::uint32_t x = 0; x <= cells; ++x) {
      mesh.positions.push_back(c + coordinate(x) * u + coordinate(y) * v);
      if (x == cells || y == cells) continue;
      const std::uint32_t at = first + y * (cells + 1) + x;
      mesh.indices.insert(mesh.indices.end(), {at, at + 1, at + cells + 2, at, at + cells + 2, at + cells + 1});
    }
  }
}

scene::Mesh square(std::uint32_t cells) {
  scene::Mesh mesh;
  addSquare(mesh, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, cells);
  return mesh;
}

// A cube, or with its corners moved onto a sphere, a ball.
scene::Mesh body(bool isRound) {
  scene::Mesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      vec3 c(0), u(0), v(0);
      c[axis] = side;
      u[(axis + 1) % 3] = side;
      v[(axis + 2) % 3] = 1;
      addSquare(mesh, c, u, v, 4);
    }
  }
  for (vec3& p : mesh.positions) p = vec3(0.3f, 0.2f, -0.1f) + (isRound ? glm::normalize(p) : p);
  return mesh;
}

// Bodies that overlap, some of them twice at the same place, above a plane and below a lamp; one is 1000 times as large
// as most and contains them, and some are as much smaller. Materials: diffuse, mixed, mirror, glass and one that is
// half transparent.
scene::Scene bodies(std::uint32_t seed) {
  test::RandomMaps random(seed);
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.6f))).plane({0, 0, -2}, {1, 0, -2}, {0, 1, -2});
  b.material(test::diffuseMaterial(vec3(0), vec3(6))).quad({-1, 1, 4}, {-1, -1, 4}, {1, -1, 4}, {1, 1, 4});
  const auto firstLook = static_cast<std::uint32_t>(b.scene.materials.size());
  b.material(test::diffuseMaterial({0.7f, 0.5f, 0.3f})).material(test::mixtureMaterial(0.4f, 0.4f, 30));
  b.material(test::mirrorMaterial(vec3(0.8f))).material(test::glassMaterial(vec3(0.9f), 1.5f));
  b.material(test::diffuseMaterial(vec3(0.5f)));
  b.scene.materials.back().opacity = scene::Opacity{.factor = 0.5f};
  const std::uint32_t cube = test::storeBoth(b.scene, body(false));
  const std::uint32_t ball = test::storeBoth(b.scene, body(true));
  for (std::uint32_t i = 0; i < 30; ++i) {
    const bool isSmall = i % 6 == 5;
    const dvec3 centre = isSmall ? dvec3(0, -6.98, 1) : random.point(3);
    const dmat4 map = random.next(isSmall ? 1e-3 : random.number(0.3, 1.2), centre);
    test::addInstance(b.scene, map, i % 2 == 0 ? cube : ball, firstLook + i % 5);
    if (i % 7 == 0) test::addInstance(b.scene, map, i % 2 == 0 ? cube : ball, firstLook + (i + i / 7) % 5);
    if (i == 14) b.sphere({0, 0, 0}, 0.8f).triangle({-3, 0, 0}, {3, 0, 0}, {0, 0, 3});
  }
  if (seed % 2 == 0) test::addInstance(b.scene, random.next(1000, dvec3(0)), ball, firstLook);
  b.pointLight({-4, -4, 4}, vec3(0.3f));
  b.scene.background = vec3(0.3f);
  b.view({0, -7, 1}, {0, 0, 0}, {0, 0, 1}, 50);
  return b.scene;
}

// Squares that lie in one plane with each other, with a floor and with a lamp, some of them twice or of glass, and a
// ball of glass above them.
scene::Scene stackedSquares(float height) {
  SceneBuilder b;
  b.material(test::diffuseMaterial({0.7f, 0.6f, 0.5f})).plane({0, 0, height}, {1, 0, height}, {0, 1, height});
  b.material(test::diffuseMaterial(vec3(0), vec3(3)));
  b.quad({-0.5f, -0.5f, height}, {0.5f, -0.5f, height}, {0.5f, 0.5f, height}, {-0.5f, 0.5f, height});
  b.material(test::diffuseMaterial({0.2f, 0.5f, 0.8f})).material(test::glassMaterial(vec3(0.9f), 1.5f));
  const std::uint32_t flat = test::storeBoth(b.scene, square(6));
  const std::uint32_t ball = test::storeBoth(b.scene, body(true));
  const auto at = [&](double x, double y, double angle, double size) {
    const dmat4 moved = glm::translate(dmat4(1), dvec3(x, y, height));
    return glm::scale(glm::rotate(moved, angle, dvec3(0, 0, 1)), dvec3(size));
  };
  for (int i = 0; i < 8; ++i) {
    const dmat4 map = at(0.7 * i - 2, 0.3 * i, 0.5 * i, 1.5);
    test::addInstance(b.scene, map, flat, i % 3 == 2 ? 3 : 2);
    if (i % 2 == 0) test::addInstance(b.scene, map, flat, i % 3 == 0 ? 3 : 2);
  }
  test::addInstance(b.scene, at(-1, -1, 1, 0.5), ball, 3);
  test::addInstance(b.scene, at(1, -1, 1, 0.5), ball, 3);
  b.pointLight({-2, -4, height + 4}, vec3(0.5f));
  b.scene.background = vec3(0.2f);
  b.view({0, -6, height + 3}, {0, 0, height}, {0, 0, 1}, 50);
  return b.scene;
}

// Flat squares far from the origin: placed vertices are rounded by much more than the thickness of boxes in the mesh.
scene::Scene distantSquares() {
  test::RandomMaps random(5);
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.5f)));
  const std::uint32_t flat = test::storeBoth(b.scene, square(6));
  for (int i = 0; i < 12; ++i)
    test::addInstance(b.scene, random.next(1, dvec3(1e4, -2e4, 3e4) + random.point(2)), flat, 0);
  return b.scene;
}

render::RenderSettings settingsFor(render::BvhSplit split) {
  render::RenderSettings settings = test::settingsOf(32, 32, 2);
  settings.image.maxDepth = 6;
  settings.structure.bvhSplit = split;
  return settings;
}

std::size_t instanceCount(const scene::Scene& scene) {
  return Tracing(scene, render::defaultSettings()).instances().instances().size();
}

struct Traced {
  std::uint64_t film;
  std::uint64_t steps;
  std::vector<render::Deviation> deviations;
};

Traced trace(const scene::Scene& scene, const render::RenderSettings& settings) {
  const auto session = reference::makeReferenceRenderer()->prepare(scene, settings);
  session->advance({0, settings.image.sampleCount}, {});
  Traced traced{session->film().hash(), session->statistics().traversalSteps, {}};
  if (settings.execution.replicas > 0) traced.deviations = session->replicaSource()->replicas().deviations;
  return traced;
}

// Checks that instances have the film and the replicas of copies.
void requireThoseOfCopies(const scene::Scene& scene, render::RenderSettings settings) {
  const Traced instances = trace(scene, settings);
  settings.structure.copiesInstances = true;
  const Traced copies = trace(scene, settings);
  CHECK(instances.film == copies.film);
  CHECK(instances.steps != copies.steps);  // they take another way
  CHECK(std::ranges::equal(instances.deviations, copies.deviations, [](const auto& a, const auto& b) {
    return a.magnitude == b.magnitude && a.lean == b.lean && a.drift == b.drift && a.undecided == b.undecided;
  }));
}

// Rays towards the middle of a cloud, many of them almost parallel to the surface from which they start. Some cross
// glass, as rays of the path tracer do.
void requireHitsOfBruteForce(const scene::Scene& scene, const dvec3& middle, double size) {
  render::RenderSettings settings = render::defaultSettings();
  settings.structure.accel = render::AccelKind::none;
  const Tracing brute(scene, settings);
  REQUIRE(brute.instances().empty());
  std::vector<Tracing> structures;
  for (const render::BvhSplit split : {render::BvhSplit::sah, render::BvhSplit::midpoint}) {
    structures.emplace_back(scene, settingsFor(split));
    REQUIRE(structures.back().hasHierarchy());
    REQUIRE(structures.back().instances().instances().size() >= 12);
  }
  test::RandomMaps random(1);
  Counters work;
  int hits = 0, occlusions = 0;
  for (std::uint32_t i = 0; i < 3000; ++i) {
    const dvec3 from = middle + random.point(2 * size);
    Ray ray{from, normalize(middle + random.point(0.7 * size) - from)};
    const Hit start = i % 3 == 0 ? Hit() : brute.closest(ray, work);
    if (start) {
      ray = {ray.at(start.distance), normalize(random.point(1)), start.primitive, -ray.direction};
      const scene::Material& material = scene.materials[scene.primitives[start.primitive].material];
      ray.crosses = i % 3 == 1 && material.dielectric;
    }
    const Hit expected = brute.closest(ray, work);
    hits += static_cast<bool>(expected);
    for (const Tracing& structure : structures) {
      const Hit found = structure.closest(ray, work);
      REQUIRE(found.primitive == expected.primitive);
      REQUIRE(found.distance == expected.distance);
    }
    // The light is a point, or the primitive that is hit, beyond which surfaces that coincide may hide it.
    RayEnd end{random.number(0, 2 * size)};
    if (i % 2 == 0 && expected) end = {std::nextafter(expected.distance, kNoHit), expected.primitive};
    const bool occluded = brute.isOccluded(ray, end, work);
    occlusions += occluded;
    for (const Tracing& structure : structures) REQUIRE(structure.isOccluded(ray, end, work) == occluded);
  }
  CHECK(hits > 500);
  CHECK(occlusions > 200);
}

}  // namespace

TEST_CASE("instances of any scale, mirrored and sheared, have the hits of brute force") {
  for (const std::uint32_t seed : {1u, 2u}) requireHitsOfBruteForce(bodies(seed), dvec3(0), 3);
}

TEST_CASE(
    "instances whose vertices are rounded by more than the thickness of their boxes have the hits of brute force") {
  requireHitsOfBruteForce(distantSquares(), dvec3(1e4, -2e4, 3e4), 3);
}

TEST_CASE("instances that coincide with each other and with other surfaces have the hits of brute force") {
  for (const float height : {0.0f, 300.0f}) requireHitsOfBruteForce(stackedSquares(height), dvec3(0, 0, height), 3);
}

TEST_CASE(
    "the reference has the film of copies for instances, with paths and Whitted's tracer, exactly and in replicas") {
  const auto integrator = GENERATE(render::Integrator::path, render::Integrator::whitted);
  const auto replicas = GENERATE(0u, 1u);
  render::RenderSettings settings = settingsFor(render::BvhSplit::sah);
  settings.image.integrator = integrator;
  settings.execution.replicas = replicas;
  for (const std::uint32_t seed : {3u, 4u}) requireThoseOfCopies(bodies(seed), settings);
  for (const float height : {0.0f, 300.0f}) requireThoseOfCopies(stackedSquares(height), settings);
}

TEST_CASE("the reference has the film of copies for one-sided instances and midpoint splits") {
  render::RenderSettings settings = settingsFor(render::BvhSplit::midpoint);
  settings.image.oneSided = true;
  requireThoseOfCopies(bodies(5), settings);
}

TEST_CASE("emitters and meshes of few triangles are copied, and so is everything in grids and lists") {
  SceneBuilder b;
  b.material(test::diffuseMaterial(vec3(0.5f))).material(test::diffuseMaterial(vec3(0), vec3(1)));
  const std::uint32_t large = test::storeBoth(b.scene, square(6));  // 72 triangles
  const std::uint32_t small = test::storeBoth(b.scene, square(5));
  test::addInstance(b.scene, dmat4(1), large, 1);
  test::addInstance(b.scene, dmat4(2), small, 0);
  CHECK(instanceCount(b.scene) == 0);
  test::addInstance(b.scene, glm::translate(dmat4(1), dvec3(0, 0, 1)), large, 0);
  CHECK(instanceCount(b.scene) == 1);
  render::RenderSettings settings = render::defaultSettings();
  for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::grid}) {
    settings.structure.accel = accel;
    CHECK(Tracing(b.scene, settings).instances().empty());
  }
}
