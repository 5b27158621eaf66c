// The choice of lights by a tree: docs/light-transport.md section 6.1.
#include <algorithm>
#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>

#include "tests/trace/light_tree_scenes.h"
#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"

using namespace candela;
using namespace candela::proof;
using glm::vec3;
using test::diffuseMaterial;
using test::SceneBuilder;

namespace {

constexpr std::uint32_t kChoices = 200000;

// About `count` emitters, and instances of a mesh that emits.
scene::Scene emitters(std::uint32_t count, std::uint64_t seed, std::uint32_t instances = 0) {
  scene::Scene scene = test::lampsAndInstances(2 * count, instances, seed);
  scene.punctualLights.clear();
  return scene;
}

// The indices of the primitives that emit.
std::vector<std::uint32_t> emittersOf(const scene::Scene& scene) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    if (isEmissive(scene.materials[scene.primitives[i].material])) found.push_back(i);
  }
  return found;
}

std::vector<ReceiverQuery> receivers(std::size_t count, std::uint32_t seed) {
  std::vector<ReceiverQuery> queries;
  const std::vector<dvec3> normals = latticeDirections(count);
  for (const vec3& number : randomNumbers(count, seed)) {
    const std::size_t i = queries.size();
    queries.push_back({30.0 * (dvec3(number) - 0.5), normals[i], i % 3 == 0});
  }
  return queries;
}

bool hasArea(const scene::Triangle& triangle) {
  return glm::cross(dvec3(triangle.p[1] - triangle.p[0]), dvec3(triangle.p[2] - triangle.p[0])) != dvec3(0);
}

bool isInFront(const dvec3& point, const scene::Triangle& triangle) {
  const dvec3 corner(triangle.p[0]);
  return dot(cross(dvec3(triangle.p[1]) - corner, dvec3(triangle.p[2]) - corner), point - corner) > 0;
}

// Returns the probabilities of the only two lights of a scene.
std::pair<double, double> ofTwo(const scene::Scene& scene, const ReceiverQuery& receiver) {
  const std::vector<double> both = LightTreeLeaves(scene).probabilities(receiver, emittersOf(scene));
  REQUIRE(both.size() == 2);
  return {both[0], both[1]};
}

}  // namespace

TEST_CASE("the probabilities of a light tree sum to 1") {
  const scene::Scene scene = GENERATE(emitters(200, 11), emitters(20, 13, 12));
  const LightTreeLeaves leaves(scene);
  const std::vector<std::uint32_t> lamps = emittersOf(scene);
  for (const ReceiverQuery& receiver : receivers(100, 12)) {
    const std::vector<double> parts = leaves.probabilities(receiver, lamps);
    CHECK(std::accumulate(parts.begin(), parts.end(), 0.0) == Approx(1).margin(1e-5));
  }
}

TEST_CASE("a light tree chooses lights with the probabilities that it states") {
  const scene::Scene scene = GENERATE(emitters(120, 21), emitters(10, 23, 4));
  const LightTreeLeaves leaves(scene);
  const std::vector<std::uint32_t> lamps = emittersOf(scene);
  for (const ReceiverQuery& receiver : receivers(5, 22)) {
    std::vector<double> expected = leaves.probabilities(receiver, lamps);
    std::vector<double> observed(lamps.size());
    for (const ChosenLight& chosen : leaves.choose(receiver, kChoices)) {
      const auto lamp = static_cast<std::size_t>(std::ranges::lower_bound(lamps, chosen.primitive) - lamps.begin());
      REQUIRE(chosen.probability > 0);
      REQUIRE(chosen.probability == Approx(expected.at(lamp)).epsilon(1e-5));
      ++observed[lamp];
    }
    for (double& count : expected) count *= kChoices;
    checkCounts(observed, expected);
  }
}

TEST_CASE("of two spheres of one power, a light tree prefers the nearer one by the square of the distance") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(3))).sphere({0, 0, 1}, 0.001f).sphere({0, 0, 3}, 0.001f);
  const auto [near, far] = ofTwo(b.scene, {});
  CHECK(near == Approx(0.9).epsilon(1e-5));
  CHECK(far == Approx(0.1).epsilon(1e-4));
}

TEST_CASE("a light tree prefers lights by intensity, and by the cosine at the receiver") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(1))).sphere({0, 0, 2}, 0.001f);
  b.material(diffuseMaterial(vec3(1), vec3(4))).sphere({1.6f, 0, 1.2f}, 0.001f);
  const double slack = 0x1p-11, first = 1 + slack, second = 4 * (0.6 + slack);
  CHECK(ofTwo(b.scene, {}).second == Approx(second / (first + second)).epsilon(1e-3));
}

TEST_CASE("a light behind an opaque receiver has probability 0, and behind one that transmits half of two") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(3))).sphere({0, 0, 2}, 0.001f).sphere({0, 0, -2}, 0.001f);
  const auto [front, behind] = ofTwo(b.scene, {});
  CHECK(front == 1);
  CHECK(behind == 0);
  const auto [here, there] = ofTwo(b.scene, {dvec3(0), dvec3(0, 0, 1), true});
  CHECK(here == Approx(0.5).epsilon(1e-5));
  CHECK(there == Approx(0.5).epsilon(1e-5));
}

TEST_CASE("a triangle that is seen from the edge has less probability by its cosine") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(3)));
  b.triangle({0, 0, 4}, {0.001f, 0, 4}, {0, 0.001f, 4});                // faces the receiver
  b.triangle({0, 0, -4}, {0.001f, 0, -4}, {0, 0.0005f, -3.99913397f});  // turned by 60 degrees
  // The transmitting receiver sees both at the same distance, so that only the cosines at the lights differ.
  const auto [facing, turned] = ofTwo(b.scene, {dvec3(0), dvec3(0, 0, 1), true});
  CHECK(turned / facing == Approx(0.5).epsilon(5e-3));
}

TEST_CASE("a receiver within the sphere of a light, or touching it, can be lit by it") {
  SceneBuilder b;
  b.material(diffuseMaterial(vec3(1), vec3(3)));
  b.triangle({-1, -1, 0}, {1, -1, 0}, {0, 2, 0}).triangle({8, 0, 5}, {9, 0, 5}, {8, 1, 5});
  for (const dvec3& position : {dvec3(0, 0, 0.25), dvec3(1, -1, 0), dvec3(3, 3, 0.1)}) {
    CAPTURE(position.x);
    CHECK(ofTwo(b.scene, {position, dvec3(-0.6, -0.8, 0)}).first > 0.1);
  }
}

TEST_CASE("of two spot lights, a light tree chooses the one that shines on the receiver") {
  SceneBuilder b;
  scene::PunctualLight spot{.kind = scene::PunctualLight::Kind::spot, .position = {0, 0, 3}, .direction = {0, 0, -1}};
  spot.versineOuter = 0.1f;
  b.scene.punctualLights = {spot, spot};
  b.scene.punctualLights[0].direction = {0, 0, 1};
  for (const ChosenLight& chosen : LightTreeLeaves(b.scene).choose({dvec3(0.5, 0, 0)}, 1000)) {
    REQUIRE(chosen.entry == 1);
    REQUIRE(chosen.probability == 1);
  }
}

TEST_CASE("a map that preserves angles changes no probability in the tree of a mesh") {
  const auto instanceAt = [](const glm::dmat4& map) {
    scene::Scene scene;
    const std::uint32_t stored = test::storeBoth(scene, test::unevenBall());
    scene.materials.push_back(diffuseMaterial(vec3(1), vec3(3)));
    test::addInstance(scene, map, stored, 0);
    return scene;
  };
  glm::dmat4 map = glm::rotate(glm::translate(glm::dmat4(1), {3, -1, 2}), 0.7, dvec3(1, 2, -1));
  map = glm::scale(map, GENERATE(dvec3(8), dvec3(0.25), dvec3(-2, 2, 2)));
  const scene::Scene placed = instanceAt(map), unmoved = instanceAt(glm::dmat4(1));
  const std::vector<std::uint32_t> lamps = emittersOf(placed);
  const LightTreeLeaves ofPlaced(placed), ofUnmoved(unmoved);
  for (ReceiverQuery receiver : receivers(40, 41)) {
    receiver.position /= 8.0;
    const std::vector<double> expected = ofUnmoved.probabilities(receiver, lamps);
    receiver.position = dvec3(map * glm::dvec4(receiver.position, 1));
    receiver.normal = normalize(glm::dmat3(map) * receiver.normal);
    const std::vector<double> found = ofPlaced.probabilities(receiver, lamps);
    for (std::size_t i = 0; i < lamps.size(); ++i) CHECK(found[i] == Approx(expected[i]).epsilon(0.05).margin(1e-3));
  }
}

// The light of a point on a triangle reaches the receiver wherever it is above both planes.
TEST_CASE("no light that could contribute has probability 0 in a light tree") {
  const scene::Scene scene = GENERATE(emitters(300, 31), emitters(0, 33, 10));
  const bool oneSided = GENERATE(false, true);
  const LightTreeLeaves leaves(scene, oneSided);
  const std::vector<std::uint32_t> lamps = emittersOf(scene);
  std::size_t tested = 0;
  for (const ReceiverQuery& receiver : receivers(200, 32)) {
    const std::vector<double> parts = leaves.probabilities(receiver, emittersOf(scene));
    for (std::size_t k = 0; k < lamps.size(); ++k) {
      const scene::Primitive lamp = scene.primitives[lamps[k]];
      if (lamp.kind != scene::PrimitiveKind::triangle || !hasArea(triangleOf(scene, lamp))) continue;
      for (const vec3& corner : triangleOf(scene, lamp).p) {
        const dvec3 towards = dvec3(corner) - receiver.position;
        const bool isAbove = dot(receiver.normal, towards) > 0;
        if (!receiver.transmits && !isAbove) continue;
        if (oneSided && !isInFront(receiver.position, triangleOf(scene, lamp))) continue;
        ++tested;
        REQUIRE(parts[k] > 0);
      }
    }
  }
  CHECK(tested > 20000);
}
