// The rule for cells, invariants, bounds of memory and repeatability of grids.
#include "host/trace/accel/grid.h"

#include <catch2/catch.hpp>
#include <limits>

#include "host/base/errors.h"
#include "tests/trace/accel/inputs.h"

using namespace candela;
using namespace candela::accel;
using namespace candela::test;

namespace {

// Returns the cells of a grid over `count` primitives in a box of this extent around `place`.
glm::uvec3 sidesOf(const glm::dvec3& extent, std::size_t count, double density,
                   const glm::dvec3& place = glm::dvec3(0)) {
  return gridShape(boxAround(place, extent / 2.0), count, density).sides;
}

}  // namespace

TEST_CASE("an axis of a grid has trunc(m w s) + 1 cells") {
  // s = (1000 / (10 * 10 * 10))^(1/3) = 1.
  CHECK(sidesOf({10, 10, 10}, 1000, 2.05) == glm::uvec3(21));
  // s = (24 / (8 * 4 * 0.75))^(1/3) = 1.
  CHECK(sidesOf({8, 4, 0.75}, 24, 1.1) == glm::uvec3(9, 5, 1));
  CHECK(sidesOf({8, 4, 0.75}, 24, 3.1) == glm::uvec3(25, 13, 3));
}

TEST_CASE("axes without extent have one cell, and the density applies to the others") {
  // s = sqrt(100 / (10 * 40)) = 1/2.
  CHECK(sidesOf({10, 40, 0}, 100, 2.1) == glm::uvec3(11, 43, 1));
  CHECK(sidesOf({0, 40, 10}, 100, 2.1) == glm::uvec3(1, 43, 11));
  // s = 100 / 50 = 2.
  CHECK(sidesOf({0, 0, 50}, 100, 2.005) == glm::uvec3(1, 1, 201));
  CHECK(sidesOf({0, 0, 0}, 100, 2) == glm::uvec3(1));
  // An extent that is no larger than the padding of boxes counts as 0.
  CHECK(sidesOf({10, 40, 1e-5}, 100, 2.1) == glm::uvec3(11, 43, 1));
}

TEST_CASE("no cell is thinner than the padding of boxes permits") {
  const double thinnest = kThinnestCell * 1001;
  CHECK(sidesOf({2, 2, 2}, 1000000, 5, {1000, 0, 0}) == glm::uvec3(static_cast<std::uint32_t>(2 / thinnest)));
  CHECK(sidesOf({2, 2, 2}, 1000000, 5, {1e6, 0, 0}) == glm::uvec3(1));
}

TEST_CASE("no axis has more cells than allowed") {
  const std::vector<Aabb> boxes = randomBoxes(1000);
  const Grid grid = buildGrid(boxes, {.maxSide = 8});
  CHECK(grid.shape.sides[grid.shape.outermostAxis()] <= 8);
  CHECK(quality(grid).cellCount >= 6 * 6 * 6);  // and not many fewer
  CHECK(grid.density < 2);
  CHECK(validate(grid, boxes).value_or("") == "");
  CHECK(buildGrid(boxes, {.maxSide = 1}).shape.cellCount() == 1);
}

TEST_CASE("every input gives a valid grid within the limits of memory, for any density") {
  for (const auto& [name, boxes] : builderInputs()) {
    for (const double density : {0.0625, 1.0, 2.0, 5.0, 64.0}) {
      INFO(name << ", density " << density);
      const Grid grid = buildGrid(boxes, {.density = density});
      CHECK(validate(grid, boxes).value_or("") == "");
      CHECK(grid.density <= density);
      const GridQuality q = quality(grid);
      CHECK(q.cellCount <= maxGridCells(boxes.size()));
      CHECK(q.referenceCount <= maxGridReferences(boxes.size()));
    }
  }
}

TEST_CASE("overlapping boxes make the grid coarser instead of exhausting memory") {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 3000; ++i) boxes.push_back(boxAround({0, 0, 0}, glm::dvec3(1 + 1e-4 * i)));
  const Grid grid = buildGrid(boxes, {.density = 4});
  CHECK(grid.density < 1);
  CHECK(validate(grid, boxes).value_or("") == "");
  CHECK(quality(grid).referenceCount > 3000);  // but no coarser than it must be: one cell would hold each box once
}

TEST_CASE("a long thin box around few primitives has a limited number of cells") {
  const std::vector<Aabb> boxes{boxAround({0, 0, 0}, {5000, 1, 1})};
  const Grid grid = buildGrid(boxes, {.density = 64});
  CHECK(quality(grid).cellCount <= maxGridCells(1));
  CHECK(grid.shape.sides.x > 100);
}

TEST_CASE("a grid without primitives has no cells") {
  const Grid grid = buildGrid({});
  CHECK(grid.starts.empty());
  CHECK(grid.items.empty());
  CHECK_FALSE(validate(grid, {}).has_value());
  CHECK(quality(grid).cellCount == 0);
}

TEST_CASE("the grid is the same for any number of threads") {
  for (const std::vector<Aabb>& boxes : {randomBoxes(100000), builderInputs()[3].boxes}) {
    const Grid one = buildGrid(boxes, {.threads = 1});
    for (std::uint32_t threads : {2u, 3u, 7u}) CHECK(buildGrid(boxes, {.threads = threads}) == one);
    CHECK(quality(one).referenceCount > boxes.size());
  }
}

TEST_CASE("the grid is valid whichever axis is the longest") {
  for (int longest = 0; longest < 3; ++longest) {
    glm::dvec3 extent(3, 3, 3);
    extent[longest] = 30;
    Random random(3);
    std::vector<Aabb> boxes(400);
    for (Aabb& box : boxes) box = boxAround(extent * random.inCube(0, 1), glm::dvec3(0.1));
    const Grid grid = buildGrid(boxes);
    CHECK(grid.shape.outermostAxis() == longest);
    CHECK(validate(grid, boxes).value_or("") == "");
  }
  // Two axes of the same length, and a flat one.
  Random random(4);
  std::vector<Aabb> square{boxAround({0, 0, 0}, {0, 0, 0}), boxAround({10, 10, 0}, {0, 0, 0})};
  for (int i = 0; i < 100; ++i) square.push_back(boxAround({random.real(0, 10), random.real(0, 10), 0}, {0.1, 0.1, 0}));
  CHECK(validate(buildGrid(square), square).value_or("") == "");
}

TEST_CASE("cell indices are monotonic, and coordinates outside belong to the outermost cells") {
  const GridShape shape = gridShape({{-3, 5, 0}, {7, 6, 0}}, 1000, 2);
  std::uint32_t before = 0;
  for (float x = -4; x < 8; x = std::nextafter(x, 100.0f) + 1e-4f) {
    const std::uint32_t cell = shape.cellAt(0, x);
    REQUIRE(cell >= before);
    before = cell;
  }
  CHECK(shape.cellAt(0, -1e30f) == 0);
  CHECK(shape.cellAt(0, 1e30f) == shape.sides.x - 1);
  CHECK(shape.cellAt(2, 123) == 0);
}

TEST_CASE("the quality of a grid equals that computed by hand") {
  Grid grid;
  grid.shape.sides = {2, 2, 1};
  grid.starts = {0, 2, 2, 5, 6};
  grid.items = {0, 1, 0, 1, 2, 2};
  const GridQuality q = quality(grid);
  CHECK(q.cellCount == 4);
  CHECK(q.referenceCount == 6);
  CHECK(q.occupiedFraction == 0.75);
  CHECK(q.averageItems == 2);
  CHECK(q.maxItems == 3);
}

TEST_CASE("boxes and options of grids that are out of range are refused, and the message states their values") {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto refused = [](const Aabb& box) {
    CHECK_THROWS_WITH(buildGrid(std::vector{Aabb{{0, 0, 0}, {1, 1, 1}}, box}), Catch::StartsWith("grid box 1 is ("));
  };
  refused({{0, nan, 0}, {1, 1, 1}});
  refused(Aabb{});
  refused({{0, 0, 0}, {1, 1, 2e30f}});
  const std::vector<Aabb> boxes = randomBoxes(10);
  CHECK_THROWS_AS(buildGrid(boxes, {.density = 0}), InternalError);
  CHECK_THROWS_AS(buildGrid(boxes, {.density = std::numeric_limits<double>::quiet_NaN()}), InternalError);
  CHECK_THROWS_AS(buildGrid(boxes, {.maxSide = 0}), InternalError);
}

TEST_CASE("validate reports the errors of a grid") {
  const std::vector<Aabb> boxes = randomBoxes(40);
  const Grid good = buildGrid(boxes);
  REQUIRE_FALSE(validate(good, boxes).has_value());
  const auto cell = [&](std::uint32_t count) {
    std::size_t c = 0;
    while (good.starts.at(c + 1) - good.starts[c] != count) ++c;
    return c;
  };
  const std::size_t single = cell(1), pair = cell(2);
  const auto complaint = [&](auto&& damage) {
    Grid bad = good;
    damage(bad);
    return validate(bad, boxes).value_or("nothing");
  };
  using Catch::Contains;
  CHECK_THAT(complaint([](Grid& g) { g.starts.pop_back(); }), Contains("starts of"));
  CHECK_THAT(complaint([](Grid& g) { g.starts.clear(); }), Contains("0 starts of"));
  CHECK_THAT(complaint([](Grid& g) { g.starts[0] = 1; }), Contains("cell 0 starts at 1"));
  CHECK_THAT(complaint([](Grid& g) { g.starts[5] = ~0u; }), Contains("ends before it starts"));
  CHECK_THAT(complaint([](Grid& g) { g.items.push_back(0); }), Contains("the last cell ends at"));
  CHECK_THAT(complaint([](Grid& g) { g.items[3] = 40; }), Contains("names primitive 40"));
  CHECK_THAT(complaint([&](Grid& g) { std::swap(g.items[g.starts[pair]], g.items[g.starts[pair] + 1]); }),
             Contains("do not ascend"));
  CHECK_THAT(complaint([&](Grid& g) { g.items[g.starts[single]] = (g.items[g.starts[single]] + 1) % 40; }),
             Contains("is not in cell"));
  CHECK_THAT(complaint([&](Grid& g) {
               // One primitive more in a cell that it does not touch.
               const std::size_t empty = cell(0);
               g.items.insert(g.items.begin() + g.starts[empty], 7);
               for (std::size_t c = empty + 1; c < g.starts.size(); ++c) ++g.starts[c];
             }),
             Contains("boxes touch cells"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.sides.y = 0; }), Contains("0 cells along axis 1"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.sides.x += 1; }), Contains("strides"));
  CHECK_THAT(complaint([](Grid& g) {
               g.shape.sides = glm::uvec3(65535), g.shape.strides = {1, 65535, 65535u * 65535u};
             }),
             Contains("starts of"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.strides.z += 1; }), Contains("strides"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.scale.z = 0; }), Contains("scale 0"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.scale.z *= std::numeric_limits<float>::infinity(); }),
             Contains("scale inf"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.scale.z *= 1.5f; }), Contains("is not in cell"));
  CHECK_THAT(complaint([](Grid& g) { g.shape.bounds.max.x -= 1; }), Contains("reaches out of the grid"));
  CHECK_THAT(validate(good, {}).value_or(""), Contains("for no primitives"));
  CHECK_THAT(validate(Grid{}, boxes).value_or(""), Contains("0 cells along axis 0"));
}
