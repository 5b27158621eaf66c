// Every structure finds exactly the hit that brute force finds: its distance, bit for bit, and the lower index for
// equal distances.
#include <catch2/catch.hpp>

#include "tests/trace/accel/searches.h"
#include "tests/trace/accel/test_rays.h"
#include "tests/trace/accel/test_scenes.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

struct Structures {
  explicit Structures(const std::vector<Aabb>& boxes)
      : trees{buildBvh(boxes, {.maxLeafSize = 8}), buildBvh(boxes, {.rule = SplitRule::midpoint, .maxLeafSize = 2}),
              buildBvh(boxes, {.rule = SplitRule::coarseSah, .maxLeafSize = 8}),
              buildBvh(boxes, {.reinsertion = Reinsertion::all, .maxLeafSize = kMaxWideLeaf})},
        wide{collapse(buildBvh(boxes, {.maxLeafSize = kMaxWideLeaf})), collapse(trees[1]), collapse(trees[3])},
        grids{buildGrid(boxes), buildGrid(boxes, {.density = 1}), buildGrid(boxes, {.density = 5})} {}

  std::array<Bvh, 4> trees;
  std::array<WideBvh, 3> wide;
  std::array<Grid, 3> grids;
};

using Counts = std::array<int, 10>;

struct Outcome {
  int hits = 0;
  int ties = 0;        ///< if counted
  Counts differing{};  ///< by structure, in the order of Structures
};

// Rays are of single precision; T is that of all tests and searches.
template <class T>
Outcome searchAll(const scene::Scene& scene, int rayCount, std::uint64_t seed, bool countTies = false) {
  Searcher<T> searcher(scene);
  const Structures structures(searcher.boxes());
  RayMaker rays(structures.grids[0].shape, seed);
  glm::vec3 surfacePoint(0);
  Outcome outcome;
  for (int i = 0; i < rayCount; ++i) {
    const Ray<float> single = rays.next(surfacePoint);
    const Ray<T> ray{Vec<T>(single.origin), Vec<T>(single.direction)};
    const Hit<T> expected = searcher.bruteForce(ray);
    std::size_t place = 0;
    for (const Bvh& bvh : structures.trees) outcome.differing[place++] += searcher.throughTree(ray, bvh) != expected;
    for (const WideBvh& wide : structures.wide)
      outcome.differing[place++] += searcher.throughWideTree(ray, wide) != expected;
    for (const Grid& grid : structures.grids) outcome.differing[place++] += searcher.throughGrid(ray, grid) != expected;
    if (expected.primitive == ~0u) continue;
    ++outcome.hits;
    outcome.ties += countTies && searcher.isTie(ray, expected);
    surfacePoint = glm::vec3(ray.origin + expected.t * ray.direction);
  }
  return outcome;
}

void requireEqual(const NamedScene& named, int rayCount, std::uint64_t seed) {
  INFO(named.name);
  const bool hasFinite = !boundPrimitives(named.scene).finite.empty();
  const Outcome single = searchAll<float>(named.scene, rayCount, seed);
  CHECK(single.differing == Counts{});
  CHECK(single.hits >= (hasFinite ? rayCount / 100 : 0));
  const Outcome exact = searchAll<double>(named.scene, rayCount / 4, seed);
  CHECK(exact.differing == Counts{});
}

}  // namespace

TEST_CASE("BVHs and grids give the hits of brute force in every scene") {
  for (const NamedScene& named : sceneFiles()) requireEqual(named, 5000, 1);
}

TEST_CASE("BVHs and grids give the hits of brute force in extreme scenes") {
  for (const NamedScene& named : edgeScenes()) requireEqual(named, 10000, 2);
}

TEST_CASE("at equal distances the lower primitive index is hit in every structure") {
  for (const NamedScene& named : edgeScenes()) {
    if (named.name != "mixed") continue;  // the scene contains half of its primitives twice
    constexpr int kRays = 5000;
    const Outcome outcome = searchAll<float>(named.scene, kRays, 7, true);
    CHECK(outcome.differing == Counts{});
    CHECK(outcome.ties > kRays / 5);
  }
}

TEST_CASE("BVHs and grids give the hits of brute force for a million rays in every scene", "[slow]") {
  for (const NamedScene& named : sceneFiles()) requireEqual(named, 1000000, 3);
}

TEST_CASE("BVHs and grids give the hits of brute force for a million rays in extreme scenes", "[slow]") {
  for (const NamedScene& named : edgeScenes()) requireEqual(named, 1000000, 4);
}

TEST_CASE("BVHs and grids give the hits of brute force among a million objects", "[slow]") {
  requireEqual({"a million objects", largeScene(1000000)}, 1000, 5);
}

TEST_CASE("BVHs and grids save nearly all primitive tests of brute force") {
  const scene::Scene scene = largeScene(20000);
  Searcher<float> searcher(scene);
  const Structures structures(searcher.boxes());
  Random random(6);
  std::vector<std::uint64_t> steps(structures.trees.size() + structures.wide.size() + structures.grids.size());
  constexpr int kRays = 500;
  for (int i = 0; i < kRays; ++i) {
    const Ray<float> ray{glm::vec3(random.inCube(-20, 120)), glm::vec3(random.direction())};
    std::size_t place = 0;
    const auto count = [&](auto&& search) {
      searcher.steps = 0;
      search();
      steps[place++] += searcher.steps;
    };
    for (const Bvh& bvh : structures.trees) count([&] { searcher.throughTree(ray, bvh); });
    for (const WideBvh& wide : structures.wide) count([&] { searcher.throughWideTree(ray, wide); });
    for (const Grid& grid : structures.grids) count([&] { searcher.throughGrid(ray, grid); });
  }
  for (const std::uint64_t count : steps) CHECK(count < kRays * scene.primitives.size() / 50);
}
