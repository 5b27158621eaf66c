// Instances of the same triangles share the primitives that a scene stores.
#include "host/scene/stored_primitives.h"

#include <catch2/catch.hpp>

namespace candela::scene {
namespace {

TEST_CASE("instances of the same triangles are stored once, and all other primitives by themselves") {
  using enum PrimitiveKind;
  PrimitiveList list;
  list.append({triangle, 0, 0, 0}, 5);     // 0 to 4: not an instance
  list.append({triangle, 0, 0, 0, 0}, 5);  // 5 to 9
  list.append({triangle, 0, 0, 1, 1}, 3);  // 10 to 12: another mesh
  list.append({triangle, 0, 7, 0, 2}, 5);  // 13 to 17: as 5 to 9, of another material
  list.append({triangle, 0, 0, 0, 3}, 4);  // 18 to 21: fewer triangles of the mesh
  list.append({sphere, 0, 0}, 2);
  const StoredPrimitives stored(list);
  CHECK(stored.count() == 5 + 5 + 3 + 4 + 2);
  CHECK(stored.indexOf(4) == 4);
  CHECK(stored.indexOf(6) == 6);
  CHECK(stored.indexOf(12) == 12);
  CHECK(stored.indexOf(14) == 6);
  CHECK(stored.indexOf(18) == 13);
  CHECK(stored.indexOf(23) == 18);
  CHECK(stored.primitiveOf(4) == 4);
  CHECK(stored.primitiveOf(6) == 6);
  CHECK(stored.primitiveOf(13) == 18);
  CHECK(stored.primitiveOf(18) == 23);
  CHECK(stored.isFirst(1));
  CHECK_FALSE(stored.isFirst(3));
  CHECK(stored.firstOf(3) == 5);
}

}  // namespace
}  // namespace candela::scene
