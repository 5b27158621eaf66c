// Differences between two variants, in words.
#include "host/drivers/conformance/observation.h"

#include <catch2/catch.hpp>

namespace candela::conformance {

using Catch::Contains;

TEST_CASE("variants: a difference of films names the first pixel and quantity") {
  image::Film plain(4, 3), other(4, 3);
  for (image::Film* const film : {&plain, &other}) film->addSample(1, 1, {0.5, 0.25, 1}, 0);
  other.at(2, 1).hitCount = 7;
  other.addSample(3, 2, {1, 1, 1}, 0);
  CHECK(differenceBetween({"a", "", plain}, {"a", "", plain}, "O").empty());
  CHECK(differenceBetween({"a", "", plain}, {"b", "", other}, "O") ==
        "the films of plain and O differ in 2 of 12 pixels, first in 2,1: number of hits is 0 and 7");
  other.at(1, 1).green[0] += 1;
  CHECK_THAT(differenceBetween({"a", "", plain}, {"b", "", other}, "O"),
             Contains("3 of 12 pixels, first in 1,1: sum of green is 0.25 and 0.25000000000"));
}

TEST_CASE("variants: a difference of results has both texts") {
  CHECK(differenceBetween({"Pass"}, {"Fail", "word 3"}, "Os") == "plain and Os differ: Pass and Fail, word 3");
}

}  // namespace candela::conformance
