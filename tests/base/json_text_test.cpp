// JSON as text: places of errors, depths, bytes that are not UTF-8.
#include "host/base/json_text.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candela {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

JsonSyntaxError errorOf(const std::string& text) {
  try {
    parseJson(text);
  } catch (const JsonSyntaxError& error) {
    return error;
  }
  FAIL("the text was parsed");
  return {"", 0, ""};
}

}  // namespace

TEST_CASE("an error of syntax states the line and the column at which it is noticed") {
  const JsonSyntaxError error = errorOf("{\"a\": 1,\n \"b\" 2}");
  CHECK(error.line == 2);
  CHECK(error.column == 6);
  CHECK(std::string(error.what()).starts_with("not valid JSON: syntax error while parsing object separator"));
  CHECK(errorOf("").line == 1);
  CHECK(errorOf("").column == 1);
}

TEST_CASE("the message of an error is a line of ASCII whatever the text contains") {
  const std::string message = errorOf("{\"a\": \"\xff\x1b[31m\n\"}").what();
  for (const char c : message) CHECK((c >= 0x20 && c <= 0x7e));
}

TEST_CASE("a number beyond double precision is an error at its place") {
  const JsonSyntaxError error = errorOf("[1,\n  1e999]");
  CHECK(error.line == 2);
  CHECK(error.column == 3);
  CHECK(std::string(error.what()) == "not valid JSON: number overflow");
}

TEST_CASE("256 levels of brackets are permitted, and brackets in strings do not count") {
  const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  CHECK_NOTHROW(parseJson(nested(256)));
  const JsonSyntaxError error = errorOf(nested(257));
  CHECK(error.column == 257);
  CHECK(std::string(error.what()) == "JSON is nested more than 256 levels deep");
  CHECK(parseJson("[\"" + std::string(300, '[') + "\\\"[\"]")[0].get<std::string>().size() == 302);
}

TEST_CASE("texts are one line or indented, and bytes that are not UTF-8 become U+FFFD") {
  const ordered_json value{{"b", 1}, {"a", "Ger\xe4t \u00e4"}};
  CHECK(jsonText(value) == "{\"b\":1,\"a\":\"Ger\xef\xbf\xbdt \u00e4\"}");
  CHECK(jsonText(json(value)) == "{\"a\":\"Ger\xef\xbf\xbdt \u00e4\",\"b\":1}");
  CHECK(jsonText(ordered_json{{"b", 1}}, 2) == "{\n  \"b\": 1\n}");
  CHECK(asciiJsonText(value) == "{\"b\":1,\"a\":\"Ger\\ufffdt \\u00e4\"}");
}

}  // namespace candela
