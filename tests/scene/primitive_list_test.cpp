// The list of primitives: runs, and access by index and by iterators.
#include "host/scene/primitive_list.h"

#include <algorithm>
#include <catch2/catch.hpp>

#include "host/base/errors.h"

namespace candela::scene {
namespace {

constexpr auto kSphere = PrimitiveKind::sphere;
constexpr auto kTriangle = PrimitiveKind::triangle;

TEST_CASE("primitives that differ only in consecutive indices are one run") {
  PrimitiveList list;
  list.append({kTriangle, 4, 1, 2}, 3);
  list.push_back({kTriangle, 7, 1, 2});
  CHECK(list.runs().size() == 1);
  list.push_back({kTriangle, 9, 1, 2});      // skips an index
  list.push_back({kTriangle, 10, 0, 2});     // another material
  list.push_back({kTriangle, 11, 0, 3});     // another mesh
  list.push_back({kTriangle, 12, 0, 3, 0});  // a placement
  list.push_back({kSphere, 13, 0});          // another kind
  list.append({kSphere, 0, 0}, 0);
  CHECK(list.runs().size() == 6);
  CHECK(list.size() == 9);
  CHECK(list[3] == Primitive(kTriangle, 7, 1, 2));
  CHECK(list[4] == Primitive(kTriangle, 9, 1, 2));
  CHECK(list.back() == Primitive(kSphere, 13, 0));
  CHECK(list.countOf(list.runs()[0]) == 4);
  CHECK(list.countOf(list.runs()[5]) == 1);
  CHECK(list.runOf(3).first == 0);
  CHECK(list.runOf(4).first == 4);
}

TEST_CASE("iterators pass all primitives in the order of their indices") {
  PrimitiveList list{{kSphere, 0, 0}, {kSphere, 1, 0}, {kTriangle, 0, 0}, {kSphere, 2, 0}};
  std::size_t index = 0;
  for (const Primitive& primitive : list) CHECK(primitive == list[index++]);
  CHECK(index == list.size());
  CHECK(std::ranges::count(list, kSphere, &Primitive::kind) == 3);
  CHECK(list.begin() != list.end());
  list.clear();
  CHECK(list.begin() == list.end());
  CHECK(list == PrimitiveList());
}

TEST_CASE("a list beyond the range of primitive indices is refused") {
  PrimitiveList list;
  list.append({kTriangle, 0, 0, 0, 0}, PrimitiveList::kMaxSize);
  CHECK(list.size() == 4294967294u);
  CHECK(list[4294967293u].index == 4294967293u);
  CHECK_THROWS_AS(list.push_back({kSphere, 0, 0}), FileError);
}

}  // namespace
}  // namespace candela::scene
