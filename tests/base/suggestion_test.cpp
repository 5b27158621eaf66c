// Mistyped words get suggestions; other words do not.
#include "host/base/suggestion.h"

#include <catch2/catch.hpp>

namespace candela::scene {

TEST_CASE("edit distance counts inserts, deletes, replacements and swaps, in any case") {
  CHECK(editDistance("", "") == 0);
  CHECK(editDistance("mesh", "mesh") == 0);
  CHECK(editDistance("", "box") == 3);
  CHECK(editDistance("mseh", "mesh") == 1);
  CHECK(editDistance("mes", "mesh") == 1);
  CHECK(editDistance("meshs", "mesh") == 1);
  CHECK(editDistance("mash", "mesh") == 1);
  CHECK(editDistance("MESH", "mesh") == 0);
  CHECK(editDistance("kitten", "sitting") == 3);
}

TEST_CASE("only similar words are suggested, the most similar first") {
  const std::vector<Spelling> spellings{{"s", "s"}, {"sphere", "s"}, {"spp", "spp"}, {"mesh", "mesh"}};
  CHECK(suggest("spehre", spellings) == "s");
  CHECK(suggest("mseh", spellings) == "mesh");
  CHECK(suggest("S", spellings) == "s");
  CHECK_FALSE(suggest("x", spellings));
  CHECK_FALSE(suggest("ab", spellings));
  CHECK_FALSE(suggest("unrelated", spellings));
  CHECK_FALSE(suggest(std::string(5000, 's'), spellings));
}

TEST_CASE("the only word that begins as the mistyped one comes before similar words") {
  const std::vector<Spelling> spellings{{"time", "time"}, {"tonemap", "tonemap"}, {"tonemaps", "tonemap"}};
  CHECK(suggest("tone", spellings) == "tonemap");
  CHECK(suggest("TONE", spellings) == "tonemap");
  CHECK(suggest("tim", spellings) == "time");
  CHECK_FALSE(suggest("to", spellings));
  const std::vector<Spelling> several{{"timex", "timex"}, {"timeyes", "timeyes"}, {"dime", "dime"}};
  CHECK(suggest("time", several) == "timex");
}

}  // namespace candela::scene
