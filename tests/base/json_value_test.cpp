// Checked JSON values: the pointers in errors, the ranges of numbers, members that are absent.
#include "host/base/json_value.h"

#include <catch2/catch.hpp>

namespace candela {
namespace {

using Catch::Contains;
using nlohmann::json;

const json kDocument = json::parse(R"({
  "list": [1, 2.5, "three", -4, 9007199254740993, 1e300],
  "flag": true, "nothing": null, "a/b~c\n": 1
})");

JsonValue root() { return {kDocument, ""}; }

}  // namespace

TEST_CASE("an error names the JSON pointer of the value") {
  const JsonValue list = root().require("list");
  CHECK(list[0].number() == 1);
  CHECK_THROWS_WITH(list[2].number(), "/list/2: expected a number");
  CHECK_THROWS_WITH(list[1].text(), "/list/1: expected a string");
  CHECK_THROWS_WITH(list[6], "/list: expected at least 7 elements");
  CHECK_THROWS_WITH(list.find("x"), "/list: expected an object");
  CHECK_THROWS_WITH(root().size(), "the root: expected an array");
  CHECK_THROWS_WITH(root().require("x"), "the root: the property \"x\" is missing");
  CHECK_THROWS_WITH(list.boolean(), "/list: expected true or false");
  CHECK(root().require("flag").boolean());
}

TEST_CASE("pointers escape keys, and replace control characters") {
  CHECK(root().require("a/b~c\n").pointer() == "/a~1b~0c?");
  const json longKey{{std::string(100, 'k'), 1}};
  CHECK(JsonValue(longKey, "").require(std::string(100, 'k')).pointer() == "/" + std::string(60, 'k') + "...");
}

TEST_CASE("numbers are checked against their range") {
  const JsonValue list = root().require("list");
  CHECK(list[0].whole() == 1);
  CHECK(list[0].whole(1, 1) == 1);
  CHECK_THROWS_WITH(list[0].whole(2, 5), "/list/0: expected a whole number from 2 to 5");
  CHECK_THROWS_WITH(list[0].whole(0, 0), "/list/0: expected a whole number from 0 to 0");
  for (const std::size_t index : {1, 2, 3, 5}) {
    CHECK_THROWS_WITH(list[index].whole(), Contains("expected a whole number, 0 or more"));
    CHECK_THROWS_WITH(list[index].whole(0, 9), Contains("expected a whole number from 0 to 9"));
  }
  CHECK_THROWS_WITH(list[5].number(), "/list/5: the number is too large");
  CHECK(list[0].indexInto("things", 2) == 1);
  CHECK_THROWS_WITH(list[0].indexInto("things", 1), "/list/0: index 1 into \"things\", which has 1 elements");
}

TEST_CASE("absent members are nothing, null or a default, and those of another type are errors") {
  CHECK_FALSE(root().find("x"));
  CHECK(root().findOrNull("x").isNull());
  CHECK(root().findOrNull("x").pointer() == "/x");
  CHECK(root().findOrNull("nothing").isNull());
  CHECK(root().numberOr("x", 7) == 7);
  CHECK(root().textOr("x", "y") == "y");
  CHECK(root().sizeOf("list") == 6);
  CHECK(root().sizeOf("x") == 0);
  CHECK_THROWS_WITH(root().numberOr("flag", 7), "/flag: expected a number");
  CHECK(root().keys() == std::vector<std::string>{"a/b~c\n", "flag", "list", "nothing"});
  CHECK(root().require("list").items().at(3).pointer() == "/list/3");
}

}  // namespace candela
