// The box type.
#include "host/trace/accel/bounds.h"

#include <catch2/catch.hpp>

using candela::accel::Aabb;

TEST_CASE("a box starts empty, without area, and inside every other") {
  const Aabb empty;
  CHECK(empty.isEmpty());
  CHECK(empty.surfaceArea() == 0);
  CHECK(Aabb{{0, 0, 0}, {1, 1, 1}}.contains(empty));
}

TEST_CASE("a box grows to contain points and boxes") {
  Aabb box;
  box.extend(glm::vec3(1, 2, 3));
  CHECK(box == Aabb{{1, 2, 3}, {1, 2, 3}});
  CHECK_FALSE(box.isEmpty());
  box.extend(Aabb{{-1, 4, 3}, {0, 5, 4}});
  CHECK(box == Aabb{{-1, 2, 3}, {1, 5, 4}});
  CHECK(box.surfaceArea() == 2 * (2 * 3 + 3 * 1 + 1 * 2));
}

TEST_CASE("a box contains boxes and points that touch it from inside, and nothing that extends beyond it") {
  const Aabb box{{0, 0, 0}, {2, 2, 2}};
  CHECK(box.contains(box));
  CHECK(box.contains(Aabb{{0, 1, 1}, {2, 1, 1}}));
  CHECK_FALSE(box.contains(Aabb{{0, 1, 1}, {2.0000002f, 1, 1}}));
  CHECK_FALSE(box.contains(Aabb{{0, 0, -1e-30f}, {1, 1, 1}}));
}

TEST_CASE("the largest finite box has a finite area") {
  const float most = std::numeric_limits<float>::max();
  CHECK(Aabb{glm::vec3(-most), glm::vec3(most)}.surfaceArea() == Approx(24 * double{most} * double{most}));
}
