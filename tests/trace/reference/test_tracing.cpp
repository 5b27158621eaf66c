// Acceleration structures of the reference, compared with brute force, and their rules.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "host/trace/reference/tracing.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using glm::vec3;
using test::SceneBuilder;

namespace {

render::RenderSettings withAccel(render::AccelKind accel) {
  render::RenderSettings settings = render::defaultSettings();
  settings.structure.accel = accel;
  return settings;
}

render::RenderSettings withMidpoints() {
  render::RenderSettings settings = render::defaultSettings();
  settings.structure.bvhSplit = render::BvhSplit::midpoint;
  return settings;
}

render::RenderSettings withGrid(float density) {
  render::RenderSettings settings = withAccel(render::AccelKind::grid);
  settings.structure.gridDensity = density;
  return settings;
}

class RandomScene {
 public:
  scene::Scene make(int perKind) {
    b_.material(test::diffuseMaterial(vec3(0.5f)));
    for (int i = 0; i < perKind; ++i) {
      const vec3 p = 10.0f * point();
      b_.sphere(p, 0.5f * uniform());
      b_.triangle(p, p + point(), p + point());
      b_.triangle(p, p, p);  // without area
      const vec3 q = 10.0f * point();
      b_.box(q, q + glm::abs(point()) * vec3(1, 1, i % 2 == 0 ? 0 : 1));
      b_.cone(p, std::abs(uniform()), p + point(), std::abs(uniform()));
      if (i % 20 == 0) b_.sphere(p, 0.3f).sphere(p, 0.3f);                          // equal spheres tie
      if (i % 20 == 1) b_.box(q, q + vec3(1)).box(q - vec3(1, 1, 0), q + vec3(1));  // faces in one plane tie
    }
    b_.plane({0, -12, 0}, {0, -12, 1}, {1, -12, 0}).plane({0, -12, 0}, {0, -12, 1}, {1, -12, 0});
    return b_.scene;
  }
  float uniform() { return uniform_(random_); }
  vec3 point() { return {uniform(), uniform(), uniform()}; }

  // From within, from a surface, from far away (sometimes too far for a grid), or along an axis.
  Ray ray(int number, const Tracing& brute, Counters& work) {
    Ray ray{dvec3(12.0f * point()), normalize(dvec3(point()))};
    if (number % 10 == 0) ray.direction = dvec3(0, number % 20 == 0 ? 1 : -1, 0);
    if (number % 10 == 3) {
      const dvec3 target(10.0f * point());
      ray.origin = std::exp2(4 + 8.0 * uniform()) * dvec3(point());
      ray.direction = normalize(target - ray.origin);
    }
    if (number % 10 == 5) ray.direction = normalize(ray.direction * dvec3(1, 0, 1));
    if (number % 10 == 7) ray.origin = glm::round(ray.origin);
    if (number % 3 == 0) {
      const Hit start = brute.closest(ray, work);
      if (start) ray = {ray.at(start.distance), normalize(dvec3(point())), start.primitive, -ray.direction};
    }
    return ray;
  }

 private:
  SceneBuilder b_;
  std::mt19937 random_{17};
  std::uniform_real_distribution<float> uniform_{-1, 1};
};

}  // namespace

TEST_CASE("every structure gives the hits of brute force in scenes of all kinds and with ties") {
  RandomScene random;
  const scene::Scene scene = random.make(100);
  const Tracing brute(scene, withAccel(render::AccelKind::none));
  REQUIRE_FALSE(brute.hasHierarchy());
  REQUIRE_FALSE(brute.hasGrid());
  std::vector<Tracing> structures;
  for (const render::RenderSettings& settings :
       {withAccel(render::AccelKind::bvh), withMidpoints(), withGrid(1), withGrid(2), withGrid(5)}) {
    structures.emplace_back(scene, settings);
    REQUIRE(structures.back().hasHierarchy() == (settings.structure.accel == render::AccelKind::bvh));
    REQUIRE(structures.back().hasGrid() == (settings.structure.accel == render::AccelKind::grid));
  }

  Counters bruteWork, setupWork;
  std::vector<Counters> work(structures.size());
  int hits = 0, ties = 0, occlusions = 0;
  for (int i = 0; i < 8000; ++i) {
    const Ray ray = random.ray(i, brute, setupWork);
    const Hit expected = brute.closest(ray, bruteWork);
    hits += expected.primitive != kNoPrimitive;
    if (expected) {
      // The winner of a tie is the lower index: without it, the other one is hit at the same distance.
      ties += brute.isOccluded(ray, {std::nextafter(expected.distance, kNoHit), expected.primitive}, setupWork);
    }
    for (std::size_t s = 0; s < structures.size(); ++s) {
      const Hit found = structures[s].closest(ray, work[s]);
      REQUIRE(found.primitive == expected.primitive);
      REQUIRE(found.distance == expected.distance);
    }
    for (const double distance : {0.5, 5.0, 50.0}) {
      const bool occluded = brute.isOccluded(ray, {distance, 7}, bruteWork);
      occlusions += occluded;
      for (std::size_t s = 0; s < structures.size(); ++s) {
        REQUIRE(structures[s].isOccluded(ray, {distance, 7}, work[s]) == occluded);
      }
    }
  }
  CHECK(hits > 3000);
  CHECK(ties > 100);
  CHECK(occlusions > 1000);
  for (const Counters& counters : work) CHECK(counters.traversalSteps * 3 < bruteWork.traversalSteps);
}

TEST_CASE("every structure of the reference gives the hits of brute force in extreme scenes") {
  std::vector<scene::Scene> scenes;
  const auto add = [&](auto&& fill) {
    SceneBuilder b;
    b.material(test::diffuseMaterial(vec3(1)));
    fill(b);
    scenes.push_back(b.scene);
  };
  add([](SceneBuilder&) {});
  add([](SceneBuilder& b) { b.sphere({1, 2, 3}, 0.5f); });
  add([](SceneBuilder& b) { b.box({0, 0, 0}, {0, 0, 0}); });
  add([](SceneBuilder& b) { b.plane({0, -12, 0}, {0, -12, 1}, {1, -12, 0}); });
  add([](SceneBuilder& b) {  // around one another
    for (int i = 1; i < 60; ++i) b.sphere({0, 0, 0}, 0.1f * static_cast<float>(i));
  });
  add([](SceneBuilder& b) {  // all in one plane
    for (int i = 0; i < 60; ++i) {
      const vec3 corner(i % 8, i / 8, 0);
      b.triangle(corner, corner + vec3(1, 0, 0), corner + vec3(0, 1, 0)).box(corner, corner + vec3(0.5f, 0.5f, 0));
    }
  });
  add([](SceneBuilder& b) {  // coincident
    for (int i = 0; i < 300; ++i) b.box({1, 1, 1}, {2, 2, 2});
  });
  add([](SceneBuilder& b) {  // small ones beside huge ones
    for (int i = 0; i < 60; ++i) b.sphere({0.1f * static_cast<float>(i), 0, 0}, 0.03f);
    b.sphere({0, 1e5f + 3, 0}, 1e5f).cone({0, 0, -1e4f}, 2, {0, 0, 1e4f}, 1);
  });
  int hits = 0;
  for (const scene::Scene& scene : scenes) {
    RandomScene random;
    Counters work;
    const Tracing brute(scene, withAccel(render::AccelKind::none));
    for (const render::RenderSettings& settings :
         {withAccel(render::AccelKind::bvh), withMidpoints(), withGrid(2), withGrid(64)}) {
      const Tracing structure(scene, settings);
      for (int i = 0; i < 2000; ++i) {
        const Ray ray = random.ray(i, brute, work);
        const Hit expected = brute.closest(ray, work), found = structure.closest(ray, work);
        REQUIRE(found.primitive == expected.primitive);
        REQUIRE(found.distance == expected.distance);
        hits += expected.primitive != kNoPrimitive;
      }
    }
  }
  CHECK(hits > 5000);
}

TEST_CASE("every primitive is in exactly one leaf, within the leaf's box") {
  RandomScene random;
  const scene::Scene scene = random.make(60);
  std::vector<Bounds> boxes;
  for (const scene::Primitive& primitive : scene.primitives) {
    if (const auto bounds = boundsOf(scene, primitive)) boxes.push_back(*bounds);
  }
  for (const render::BvhSplit split : {render::BvhSplit::sah, render::BvhSplit::midpoint}) {
    const Hierarchy hierarchy = buildHierarchy(boxes, split);
    std::vector<int> seen(boxes.size());
    for (const Node& node : hierarchy.nodes) {
      CHECK(node.count <= (split == render::BvhSplit::midpoint ? Hierarchy::kMidpointLeafSize : Hierarchy::kLeafSize));
      for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
        const std::uint32_t item = hierarchy.order[i];
        ++seen[item];
        CHECK(glm::all(glm::lessThanEqual(node.bounds.min, boxes[item].min)));
        CHECK(glm::all(glm::greaterThanEqual(node.bounds.max, boxes[item].max)));
      }
    }
    CHECK(std::count(seen.begin(), seen.end(), 1) == static_cast<std::ptrdiff_t>(boxes.size()));
  }
}

TEST_CASE("midpoint splits are at the centre, else at the mean of the centres, else after two items") {
  const auto point = [](double x) { return Bounds{dvec3(x, 0, 0), dvec3(x, 0, 0)}; };
  // The first child follows its parent; the second is at `first`.
  const auto leftLeaf = [](const Hierarchy& hierarchy) {
    const Node& left = hierarchy.nodes[1];
    std::vector<std::uint32_t> items(hierarchy.order.begin() + left.first,
                                     hierarchy.order.begin() + left.first + left.count);
    std::sort(items.begin(), items.end());
    return items;
  };
  const std::vector<Bounds> centre{point(0), point(10), point(4.9), point(5.1)};
  CHECK(leftLeaf(buildHierarchy(centre, render::BvhSplit::midpoint)) == std::vector<std::uint32_t>{0, 2});
  // The last fills the node, so that no centre is left of 5; the mean is 7.5.
  const std::vector<Bounds> mean{point(10), point(9), point(6), Bounds{dvec3(0), dvec3(10, 0, 0)}};
  CHECK(leftLeaf(buildHierarchy(mean, render::BvhSplit::midpoint)) == std::vector<std::uint32_t>{2, 3});
  const std::vector<Bounds> coincident(100000, point(7));
  const Hierarchy rest = buildHierarchy(coincident, render::BvhSplit::midpoint);
  CHECK(leftLeaf(rest).size() == 2);
  CHECK(rest.nodes[rest.nodes[0].first + 1].count == 2);
}

TEST_CASE("a grid's cells contain the boxes that touch them, and its size is limited by the number of boxes") {
  RandomScene random;
  const scene::Scene scene = random.make(20);
  std::vector<Bounds> boxes;
  for (const scene::Primitive& primitive : scene.primitives) {
    if (const auto bounds = boundsOf(scene, primitive)) boxes.push_back(*bounds);
  }
  for (const double density : {0.1, 2.0, 64.0}) {
    const Grid grid = buildGrid(boxes, density);
    std::size_t missing = 0, items = 0;
    CellNumbers cell;
    for (cell[2] = 0; cell[2] < grid.sides[2]; ++cell[2]) {
      for (cell[1] = 0; cell[1] < grid.sides[1]; ++cell[1]) {
        for (cell[0] = 0; cell[0] < grid.sides[0]; ++cell[0]) {
          const dvec3 low = grid.bounds.min + grid.cellSize * dvec3(cell[0], cell[1], cell[2]);
          const auto held = grid.itemsOf(cell);
          items += held.size();
          for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            const bool touches = glm::all(glm::lessThanEqual(boxes[i].min, low + grid.cellSize)) &&
                                 glm::all(glm::greaterThanEqual(boxes[i].max, low));
            missing += touches && !std::binary_search(held.begin(), held.end(), i);
          }
        }
      }
    }
    CHECK(missing == 0);
    CHECK(items == grid.items.size());
    CHECK(grid.items.size() <= 64 * boxes.size() + 1000);
    CHECK(grid.starts.size() <= 64 * boxes.size() + 1001);
  }
  CHECK(buildGrid(boxes, 2).starts.size() > buildGrid(boxes, 1).starts.size());
}
