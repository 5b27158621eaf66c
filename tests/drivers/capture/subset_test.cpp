// The search for a small part of a list.
#include "host/drivers/capture/subset.h"

#include <algorithm>
#include <catch2/catch.hpp>

namespace candela::capture {
namespace {

bool neverStop() { return false; }

bool hasAll(const Subset& subset, const Subset& wanted) { return std::ranges::includes(subset, wanted); }

}  // namespace

TEST_CASE("The smallest subset has what is needed and nothing else") {
  for (const Subset& wanted : std::vector<Subset>{{}, {0}, {99}, {0, 99}, {3, 4, 5, 50, 51, 98}}) {
    const auto has = [&](const Subset& subset) { return hasAll(subset, wanted); };
    CHECK(smallestSubset(100, has, neverStop) == wanted);
  }
}

TEST_CASE("The smallest subset of one and of no index") {
  const auto always = [](const Subset&) { return true; };
  const auto ifWhole = [](const Subset& subset) { return subset.size() == 1; };
  CHECK(smallestSubset(1, always, neverStop).empty());
  CHECK(smallestSubset(0, always, neverStop).empty());
  CHECK(smallestSubset(1, ifWhole, neverStop) == Subset{0});
}

TEST_CASE("A search needs few tests if little remains, and either of two indices suffices") {
  std::size_t tests = 0;
  const auto hasOneOfTwo = [&](const Subset& subset) {
    ++tests;
    return std::ranges::binary_search(subset, 17u) || std::ranges::binary_search(subset, 900u);
  };
  CHECK(smallestSubset(1000, hasOneOfTwo, neverStop).size() == 1);
  CHECK(tests < 60);
}

TEST_CASE("A search that is stopped returns a subset that has the property") {
  std::size_t tests = 0;
  const auto has = [&](const Subset& subset) {
    ++tests;
    return hasAll(subset, {1, 2, 3});
  };
  const Subset found = smallestSubset(1000, has, [&] { return tests >= 5; });
  CHECK(hasAll(found, {1, 2, 3}));
  CHECK(found.size() < 1000);
  CHECK(found.size() > 3);
}

}  // namespace candela::capture
