// Sets of samples: equal sets have equal lists, and the missing samples are those that no box has.
#include "host/job/film/sample_boxes.h"

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <random>

#include "host/base/errors.h"

using namespace candela;
using namespace candela::film;

namespace {

// Divides a box repeatedly at random positions along random axes.
std::vector<SampleBox> divided(const SampleBox& whole, std::size_t parts, std::mt19937& random) {
  std::vector<SampleBox> boxes{whole};
  while (boxes.size() < parts) {
    const std::size_t index = random() % boxes.size();
    SampleBox a = boxes[index];
    SampleBox b = a;
    const auto cut = [&](std::uint32_t length) { return 1 + static_cast<std::uint32_t>(random() % (length - 1)); };
    if (const auto axis = random() % 3; axis == 0 && a.window.width > 1) {
      a.window.width = cut(a.window.width);
      b.window.x += a.window.width;
      b.window.width -= a.window.width;
    } else if (axis == 1 && a.window.height > 1) {
      a.window.height = cut(a.window.height);
      b.window.y += a.window.height;
      b.window.height -= a.window.height;
    } else if (a.samples.end - a.samples.first > 1) {
      a.samples.end = a.samples.first + cut(a.samples.end - a.samples.first);
      b.samples.first = a.samples.end;
    } else {
      continue;
    }
    boxes[index] = a;
    boxes.push_back(b);
  }
  std::ranges::shuffle(boxes, random);
  return boxes;
}

std::uint64_t sizeOf(const std::vector<SampleBox>& boxes) {
  std::uint64_t size = 0;
  for (const auto& [window, samples] : boxes) {
    size += std::uint64_t{window.width} * window.height * (samples.end - samples.first);
  }
  return size;
}

const SampleBox kImage{{5, 9, 40, 30}, {2, 66}};

}  // namespace

TEST_CASE("however a box is divided, its parts have the same list: the box") {
  std::mt19937 random(1);
  for (int run = 0; run < 50; ++run) {
    CHECK(canonicalBoxes(divided(kImage, 1 + random() % 40, random)) == std::vector{kImage});
  }
}

TEST_CASE("parts of a set have the same list for any order and any division of the parts") {
  std::mt19937 random(2);
  for (int run = 0; run < 50; ++run) {
    std::vector<SampleBox> boxes = divided(kImage, 30, random);
    boxes.resize(17);
    const std::vector<SampleBox> canonical = canonicalBoxes(boxes);
    CHECK(sizeOf(canonical) == sizeOf(boxes));
    CHECK(canonicalBoxes(canonical) == canonical);
    std::vector<SampleBox> finer;
    for (const SampleBox& box : boxes) {
      const std::uint64_t parts = std::min<std::uint64_t>(3, sizeOf({box}));
      const std::vector<SampleBox> more = divided(box, parts, random);
      finer.insert(finer.end(), more.begin(), more.end());
    }
    std::ranges::shuffle(finer, random);
    CHECK(canonicalBoxes(finer) == canonical);
  }
}

TEST_CASE("the missing samples complete a set, and do not overlap with it") {
  std::mt19937 random(3);
  for (int run = 0; run < 50; ++run) {
    std::vector<SampleBox> boxes = divided(kImage, 30, random);
    boxes.resize(11);
    const std::vector<SampleBox> missing = missingBoxes(boxes, kImage);
    CHECK(sizeOf(missing) + sizeOf(boxes) == sizeOf({kImage}));
    boxes.insert(boxes.end(), missing.begin(), missing.end());
    CHECK(canonicalBoxes(boxes) == std::vector{kImage});
  }
  CHECK(missingBoxes({}, kImage) == std::vector{kImage});
  CHECK(missingBoxes(std::vector{kImage}, kImage).empty());
}

TEST_CASE("missing samples are named as a person would: the ranges of whole windows") {
  const SampleBox image{{0, 0, 64, 48}, {0, 128}};
  const std::vector<SampleBox> missing = missingBoxes(std::vector<SampleBox>{{{0, 0, 64, 48}, {0, 64}}}, image);
  REQUIRE(missing.size() == 1);
  CHECK(boxText(missing[0]) == "samples 64:128 of crop 0,0,64,48");
}

TEST_CASE("boxes that have a sample in common are refused and named, others are not") {
  const SampleBox a{{0, 0, 4, 4}, {0, 8}};
  for (const SampleBox& apart : {SampleBox{{4, 0, 4, 4}, {0, 8}}, {{0, 4, 4, 4}, {0, 8}}, {{0, 0, 4, 4}, {8, 9}}}) {
    CHECK_NOTHROW(requireDisjoint(std::vector{a, apart}));
    CHECK_NOTHROW(canonicalBoxes(std::vector{a, apart}));
  }
  for (const SampleBox& common : {a, SampleBox{{3, 3, 4, 4}, {7, 9}}, {{1, 1, 1, 1}, {0, 1}}}) {
    CHECK_THROWS_AS(requireDisjoint(std::vector{a, common}), OverlapError);
    try {
      canonicalBoxes(std::vector{a, common});
      FAIL("not refused");
    } catch (const OverlapError& error) {
      CHECK(std::ranges::is_permutation(error.boxes, std::array{a, common}));
    }
  }
}

TEST_CASE("a list is canonical if and only if it is what canonicalBoxes() makes of it") {
  std::mt19937 random(4);
  CHECK(isCanonical({}));
  for (int run = 0; run < 50; ++run) {
    std::vector<SampleBox> boxes = divided(kImage, 30, random);
    boxes.resize(17);
    CHECK_FALSE(isCanonical(boxes));
    std::vector<SampleBox> canonical = canonicalBoxes(boxes);
    CHECK(isCanonical(canonical));
    std::swap(canonical.front(), canonical.back());
    CHECK_FALSE(isCanonical(canonical));
  }
  CHECK_FALSE(isCanonical(std::vector<SampleBox>{{{0, 0, 4, 4}, {0, 8}}, {{3, 3, 4, 4}, {7, 9}}}));
}

TEST_CASE("the tiles of 8K are boxes of a film, whichever are missing and however many samples they have") {
  constexpr std::uint32_t kTile = 16;
  const SampleBox image{{0, 0, 7680, 4320}, {0, 1024}};
  std::vector<SampleBox> all, every2nd, uneven, interrupted;
  for (std::uint32_t y = 0; y < image.window.height; y += kTile) {
    for (std::uint32_t x = 0; x < image.window.width; x += kTile) {
      const render::Window tile{x, y, kTile, kTile};
      const std::uint32_t count = 1 + (x / kTile + y / kTile) % 64;
      all.push_back({tile, image.samples});
      if ((x + y) / kTile % 2 == 0) every2nd.push_back({tile, image.samples});
      uneven.push_back({tile, {0, count}});
      interrupted.push_back({tile, {count, count + 1}});
    }
  }
  REQUIRE(all.size() == 129600);
  REQUIRE(all.size() <= kMaxBoxes);
  CHECK(canonicalBoxes(all) == std::vector{image});
  CHECK(isCanonical(every2nd));
  CHECK(canonicalBoxes(every2nd) == every2nd);
  CHECK(missingBoxes(every2nd, image).size() == every2nd.size());
  CHECK(isCanonical(uneven));
  CHECK(missingBoxes(uneven, image).size() == uneven.size());
  uneven.insert(uneven.end(), interrupted.begin(), interrupted.end());
  CHECK_NOTHROW(requireDisjoint(uneven));
}

TEST_CASE("boxes whose list is out of proportion are refused after a bounded number of steps") {
  // Each contains the next one and has a sample of its own, so that n boxes are a list of about n^3 boxes.
  const auto nested = [](std::uint32_t count) {
    std::vector<SampleBox> boxes;
    for (std::uint32_t i = 0; i < count; ++i) {
      boxes.push_back({{i, i, 2 * (count - i), 2 * (count - i)}, {2 * i, 2 * i + 1}});
    }
    return boxes;
  };
  CHECK(canonicalBoxes(nested(10)).size() == 670);  // squares of 1 to 9 twice, and of 10
  const std::vector<SampleBox> boxes = nested(30000);
  CHECK_FALSE(isCanonical(boxes));
  CHECK_THROWS_WITH(canonicalBoxes(boxes), Catch::Contains("divided into"));
  CHECK_THROWS_WITH(missingBoxes(boxes, {{0, 0, 60000, 60000}, {0, 60000}}), Catch::Contains("divided into"));
  CHECK_THROWS_WITH(requireDisjoint(boxes), Catch::Contains("divided into"));
}
