// Suggestions for mistyped words.
#include <array>
#include <catch2/catch.hpp>

#include "host/core/suggest.h"

namespace candela {
namespace {

const std::array<std::string, 5> kWords{"--spp", "--seed", "--size", "--sampler", "--stats"};

}  // namespace

TEST_CASE("a slip of the finger is recognised") {
  CHECK(nearestWord("--sp", kWords) == "--spp");
  CHECK(nearestWord("--psp", kWords) == "--spp");
  CHECK(nearestWord("--sede", kWords) == "--seed");
  CHECK(nearestWord("--smapler", kWords) == "--sampler");
  CHECK(nearestWord("--sizes", kWords) == "--size");
}

TEST_CASE("a word like none gets no suggestion") {
  CHECK_FALSE(nearestWord("--colour", kWords));
  CHECK_FALSE(nearestWord("", kWords));
  CHECK_FALSE(nearestWord(std::string(1'000'000, 'x'), kWords));
}

}  // namespace candela
