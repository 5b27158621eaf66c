// The choice of lights by a tree: docs/light-transport.md section 6.1.
#include <catch2/catch.hpp>
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

// About `count` emitters.
scene::Scene emitters(std::uint32_t count, std::uint64_t seed) {
  scene::Scene scene = test::mixedLamps(2 * count, seed);
  scene.punctualLights.clear();
  return scene;
}

// The primitives that emit, in the order of the light table.
std::vector<scene::Primitive> emittersOf(const scene::Scene& scene) {
  std::vector<scene::Primitive> found;
  for (const scene::Primitive& primitive : scene.primitives) {
    if (isEmissive(scene.materials[primitive.material])) found.push_back(primitive);
  }
  return found;
}

std::vector<std::uint32_t> allEntries(const scene::Scene& scene) {
  std::vector<std::uint32_t> entries(emittersOf(scene).size());
  std::iota(entries.begin(), entries.end(), 0u);
  return entries;
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

// Returns the probabilities of the only two lights of a scene.
std::pair<double, double> ofTwo(const scene::Scene& scene, const ReceiverQuery& receiver) {
  const std::vector<double> both = LightTreeLeaves(scene).probabilities(receiver, allEntries(scene));
  REQUIRE(both.size() == 2);
  return {both[0], both[1]};
}

}  // namespace

TEST_CASE("the probabilities of a light tree sum to 1") {
  const scene::Scene scene = emitters(200, 11);
  const LightTreeLeaves leaves(scene);
  const std::vector<std::uint32_t> entries = allEntries(scene);
  for (const ReceiverQuery& receiver : receivers(100, 12)) {
    const std::vector<double> parts = leaves.probabilities(receiver, entries);
    CHECK(std::accumulate(parts.begin(), parts.end(), 0.0) == Approx(1).margin(1e-5));
  }
}

TEST_CASE("a light tree chooses lights with the probabilities that it states") {
  const scene::Scene scene = emitters(120, 21);
  const LightTreeLeaves leaves(scene);
  const std::vector<std::uint32_t> entries = allEntries(scene);
  for (const ReceiverQuery& receiver : receivers(5, 22)) {
    std::vector<double> expected = leaves.probabilities(receiver, entries);
    std::vector<double> observed(entries.size());
    for (const ChosenLight& chosen : leaves.choose(receiver, kChoices)) {
      REQUIRE(chosen.probability > 0);
      REQUIRE(chosen.probability == Approx(expected[chosen.entry]).epsilon(1e-5));
      ++observed[chosen.entry];
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

// The light of a point on a triangle reaches the receiver wherever it is above both planes.
TEST_CASE("no light that could contribute has probability 0 in a light tree") {
  const scene::Scene scene = emitters(300, 31);
  const LightTreeLeaves leaves(scene);
  const std::vector<scene::Primitive> lamps = emittersOf(scene);
  std::size_t tested = 0;
  for (const ReceiverQuery& receiver : receivers(200, 32)) {
    const std::vector<double> parts = leaves.probabilities(receiver, allEntries(scene));
    for (std::size_t k = 0; k < lamps.size(); ++k) {
      if (lamps[k].kind != scene::PrimitiveKind::triangle) continue;
      for (const vec3& corner : triangleOf(scene, lamps[k]).p) {
        const dvec3 towards = dvec3(corner) - receiver.position;
        const bool isAbove = dot(receiver.normal, towards) > 0;
        if (!receiver.transmits && !isAbove) continue;
        ++tested;
        REQUIRE(parts[k] > 0);
      }
    }
  }
  CHECK(tested > 50000);
}
