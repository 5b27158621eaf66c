// Escaping, templates, and bytes as text.
#include "host/judge/report/html.h"

#include <catch2/catch.hpp>

#include "host/base/errors.h"
#include "host/judge/report/base64.h"

namespace candela::report {
namespace {

std::string encoded(const std::string& text) { return base64(std::as_bytes(std::span(text))); }

TEST_CASE("escaped text can neither open a tag nor end an attribute") {
  CHECK(escapeHtml("<script>\"'&amp;") == "&lt;script&gt;&quot;&#39;&amp;amp;");
  CHECK(escapeHtml("a\nb\tc \xc3\xa9") == "a\nb\tc \xc3\xa9");
  CHECK(escapeHtml(std::string("a\0b\x1b[0m\x7f", 8)) ==
        "a\xef\xbf\xbd"
        "b\xef\xbf\xbd[0m\xef\xbf\xbd");
}

TEST_CASE("a template inserts each value unchanged, and does not search inserted values") {
  CHECK(fillTemplate("<{{a}}|{{b}}|{{a}}>", {{"a", "{{b}}"}, {"b", "}}{{"}}) == "<{{b}}|}}{{|{{b}}>");
  CHECK(fillTemplate("{ {{", {}) == "{ {{");
  CHECK_THROWS_AS(fillTemplate("{{c}}", {{"a", ""}}), InternalError);
}

TEST_CASE("base64 gives the vectors of RFC 4648") {
  CHECK(encoded("") == "");
  CHECK(encoded("f") == "Zg==");
  CHECK(encoded("fo") == "Zm8=");
  CHECK(encoded("foo") == "Zm9v");
  CHECK(encoded("foobar") == "Zm9vYmFy");
  CHECK(encoded("\xfb\xff") == "+/8=");
}

TEST_CASE("pixel values are encoded as binary32, little-endian") {
  image::Image image;
  image.width = image.height = 1;
  image.rgb = {glm::vec3(1, -2, 0.5f)};  // 3f800000 c0000000 3f000000
  CHECK(floatText(image) == "AACAPwAAAMAAAAA/");
}

}  // namespace
}  // namespace candela::report
