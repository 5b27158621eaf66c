// Errors of a scene are reported with their exact position: every keyword and every count of an `f` line.
#include <fmt/format.h>

#include <catch2/catch.hpp>

#include "host/formats/load_scene.h"
#include "tests/formats/nff/scene_text.h"

namespace candela::scene {
namespace {

struct Malformed {
  std::string text;
  std::uint32_t line;
  std::uint32_t column;
  std::string message;  ///< a part of it
};

const std::string kView = "v\nfrom 0 0 1\nat 0 0 0\nup 0 1 0\nangle 45\nhither 0\nresolution 8 8\n";

std::string viewWith(const std::string& name, const std::string& entry) {
  std::string text = kView;
  const std::size_t begin = text.find("\n" + name) + 1;
  return text.replace(begin, text.find('\n', begin) - begin, entry);
}

std::string numbers(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += " 0.5";
  return text;
}

const std::vector<Malformed> kMalformed{
    // Words that are not keywords
    {"spehre 0 0 0 1\n", 1, 1, "unknown keyword \"spehre\"; did you mean \"s\"?"},
    {"\n\n  polygn 3\n", 3, 3, "did you mean \"p\"?"},
    {"mseh 1 1\n", 1, 1, "did you mean \"mesh\"?"},
    {"S 0 0 0 1\n", 1, 1, "did you mean \"s\"?"},
    {"asdabb 0 0 0 1 1 1\n", 1, 1, "did you mean \"aabb\"?"},
    {"bcrl 0 0 0\n", 1, 1, "did you mean \"bclr\"?"},
    {"Wall\n", 1, 1, "comments begin with \"#\", and lenient skips unknown lines"},
    {"/left line\n", 1, 1, "unknown keyword \"/left\""},
    {"From: haines@example.org\n", 1, 1, "unknown keyword \"From:\""},
    {"fire sky\n", 1, 1, "write \"env\""},
    {"tess 4\n", 1, 1, "keyword of another dialect (tessellation)"},
    {"t 1 2\n", 1, 1, "keyword of another dialect (texture)"},
    {"from 0 0 0\n", 1, 1, "outside a view"},
    {"1 2 3\n", 1, 1, "expected a keyword, found \"1\""},
    {"\x1b[31m\n", 1, 1, "unknown keyword \"?[31m\""},
    {"nff\n// comment\n", 1, 1, "WorldToolKit"},
    {"// a model\nnff version 2.1\n", 1, 1, "WorldToolKit"},
    // Numbers
    {"s 0 0 zero 1\n", 1, 7, "expected the centre, found \"zero\"; the form is: s x y z radius"},
    {"s 0 1.2.3 0 1\n", 1, 5, "\"1.2.3\" is not a number"},
    {"s 0 0,5 0 1\n", 1, 5, "write decimals with a point"},
    {"s 0 0 0 nan\n", 1, 9, "\"nan\" is not a finite number"},
    {"s 0 0 0 -inf\n", 1, 9, "\"-inf\" is not a finite number"},
    {"s 1e39 0 0 1\n", 1, 3, "beyond the range of single precision"},
    {"s 1e999 0 0 1\n", 1, 3, "beyond the range of single precision"},
    {"s 0x10 0 0 1\n", 1, 3, "\"0x10\" is not a number"},
    {"s +-1 0 0 1\n", 1, 3, "\"+-1\" is not a number"},
    // View
    {"v\n", 1, 1, "this view lacks \"from\""},
    {viewWith("from", "from 0 0"), 2, 9, "expected the eye's position, found \"at\" on line 3"},
    {viewWith("from", "eye 0 x 1"), 2, 7, "found \"x\"; the form is: eye x y z"},
    {viewWith("at", ""), 1, 1, "this view lacks \"at\""},
    {viewWith("at", "at 0 0 1"), 1, 1, "\"from\" and \"at\" are the same point"},
    {viewWith("at", "att 0 0 0"), 3, 1, "unknown keyword \"att\""},
    {viewWith("up", ""), 1, 1, "this view lacks \"up\""},
    {viewWith("up", "up 0 0 0"), 1, 1, "\"up\" is the zero vector"},
    {viewWith("up", "up 0 0 -2"), 1, 1, "parallel to the direction of view"},
    {viewWith("angle", ""), 1, 1, "this view lacks \"angle\""},
    {viewWith("angle", "angle 0"), 5, 7, "greater than 0 and less than 180"},
    {viewWith("angle", "angle 180"), 5, 7, "greater than 0 and less than 180"},
    {viewWith("angle", "angle -45"), 5, 7, "greater than 0 and less than 180"},
    {viewWith("angle", "angel 45"), 5, 1, "did you mean \"angle\"?"},
    {viewWith("hither", "hither"), 6, 7, "expected the hither distance"},
    {viewWith("resolution", ""), 1, 1, "this view lacks \"resolution\""},
    {viewWith("resolution", "resolution 8"), 7, 13, "expected the height, found the end of the file"},
    {viewWith("resolution", "resolution 0 8"), 7, 12, "whole number from 1 to 65535, not \"0\""},
    {viewWith("resolution", "resolution 8 65536"), 7, 14, "whole number from 1 to 65535"},
    {viewWith("resolution", "resolution 8.5 8"), 7, 12, "whole number"},
    {kView + "aperture -1\n", 8, 10, "the aperture must not be negative"},
    {kView + "apperture\n", 8, 10, "expected the aperture"},
    {kView + "focal 0\n", 8, 7, "the focal ratio must be greater than 0"},
    {kView + "view\n", 8, 5, "expected the view distance"},
    {"camera\neye 0 0 1\n", 1, 1, "this view lacks \"at\""},
    // Background, sky, requests
    {"b 0 0\n", 1, 6, "expected the background's colour, found the end of the file; the form is: b r g b"},
    {"b 0 -1 0\n", 1, 3, "the background's colour must not be negative"},
    {"bclr red\n", 1, 6, "found \"red\"; the form is: bclr r g b"},
    {"env\n", 1, 4, "expected the sky's folder"},
    {"env ../sky\n", 1, 5, "outside the scene's folder"},
    {"env /etc\n", 1, 5, "outside the scene's folder"},
    {"accel 3\n", 1, 7, "whole number from 0 to 2"},
    {"accel octree\n", 1, 7, "expected 0, 1, 2, none, grid or bvh, found \"octree\""},
    {"spp -1\n", 1, 5, "spp must be a whole number"},
    {"spp\n", 1, 4, "expected spp"},
    // Materials, by count
    {"f\n", 1, 2, "expected at least 8 numbers"},
    {"f 1 1 1 1 0 1 0\ns 0 0 0 1\n", 1, 16, "expected at least 8 numbers, found \"s\" on line 2"},
    {"f" + numbers(10) + "\n", 1, 42, "a material has 8, 9, 11, 12, 14 or 15 numbers, not 10"},
    {"f" + numbers(13) + "\n", 1, 54, "not 13"},
    {"f" + numbers(16) + "\n", 1, 63, "unexpected number \"0.5\""},
    {"mat 1 1 1 1 0 1 0\n", 1, 18, "expected at least 8 numbers"},
    {"f 1 1 1 1 0 1 0 1 7 7 7 7 7\n1 1 1\n", 1, 28, "not 13"},
    {"f 1 1 1 1 0 1 0 1\n5 5 5\n", 2, 1, "optional numbers must be on the line of their keyword"},
    {"f -1 1 1 1 0 1 0 1\n", 1, 1, "the diffuse colour must not be negative"},
    {"f 1 1 1 -1 0 1 0 1\n", 1, 1, "Kd must not be negative"},
    {"f 1 1 1 1 -1 1 0 1\n", 1, 1, "Ks must not be negative"},
    {"f 1 1 1 1 0 -1 0 1\n", 1, 1, "Shine must not be negative"},
    {"f 1 1 1 1 0 1 -1 1\n", 1, 1, "T must not be negative"},
    {"f 1 1 1 1 0 1 0 -1\n", 1, 1, "ior must not be negative"},
    {"f 1 1 1 1 0 1 0 1 -1\n", 1, 1, "Ka must not be negative"},
    {"f 1 1 1 1 -1 0 0 0 1 0 1\n", 1, 1, "the specular colour must not be negative"},
    {"f 1 1 1 1 0 0 0 0 1 0 1 -1\n", 1, 1, "the roughness must not be negative"},
    {"f 1 1 1 1 0 0 0 0 1 0 1 0 -1 0\n", 1, 1, "the emission must not be negative"},
    {"f 1 1 1 1 0 0 0 0 1 0 1 0 1 -1 0\n", 1, 1, "the emission must not be negative"},
    {"f 1 1 1 1 0 5 0 1 -1 0 0\n", 1, 1, "the emission must not be negative"},
    // Lights
    {"l 0 0\n", 1, 6, "expected the light's position"},
    {"l 0 0 0 1\n", 1, 10, "a light has 3, 6 or 7 numbers, not 4"},
    {"l 0 0 0 1 1\n", 1, 12, "not 5"},
    {"l 0 0 0 1 1 1 1 1\n", 1, 17, "unexpected number"},
    {"l 0 0 0 1 -1 1\n", 1, 9, "the light's colour must not be negative"},
    {"l 0 0 0 1e38 10 1 1\n", 1, 9, "beyond the range of single precision"},
    {"al 0 0 0 1 0 0 0 1 0 1 1\n", 1, 25, "expected the light's colour"},
    {"al 0 0 0 1 0 0 2 0 0 1 1 1\n", 1, 1, "edges are parallel"},
    {"al 3e38 0 0 3e38 0 0 0 1 0 1 1 1\n", 1, 1, "beyond the range of single precision"},
    {"la 0 0 0 1 0 0 0 1\n", 1, 19, "expected the light's second edge"},
    {"la 0 0 0 1 0 0 0 1 0 -1 1 1\n", 1, 22, "must not be negative"},
    {"light spot 0 0 0\n", 1, 7, "expected \"punctual\" or \"quad\", found \"spot\""},
    {"light\n", 1, 6, "expected \"punctual\" or \"quad\""},
    {"light punctual 0 0 0 1 1\n", 1, 25, "expected the light's colour"},
    {"light quad 0 0 0 1 1 1 1 0 0 0 1\n", 1, 33, "expected the light's second edge"},
    // Primitives
    {"s 0 0 0\n", 1, 8, "expected the radius, found the end of the file"},
    {"s 0 0 0\ns 0 0 0 1\n", 1, 8, "found \"s\" on line 2"},
    {"s 0 0 0 0\n", 1, 9, "radius must not be 0"},
    {"s 0 0 0 1 2\n", 1, 11, "unexpected number \"2\"; the form is: s x y z radius"},
    {"ms 0 0 0 1 1 1\n", 1, 15, "expected the radius"},
    {"ms 0 0 0 1 1 1 0\n", 1, 16, "radius must not be 0"},
    {"c 0 0 0 1\n0 0 1\n", 2, 6, "expected the radius at the apex"},
    {"c 0 0 0 1 0 0 0 1\n", 1, 1, "base and apex are the same point"},
    {"c 0 0 0 0 0 0 1 0\n", 1, 1, "both radii of the cone are 0"},
    {"c 0 0 0 -1 0 0 1 0\n", 1, 9, "the radius at the base must not be negative"},
    {"c 0 0 0 1 0 0 1 -2\n", 1, 17, "the radius at the apex must not be negative"},
    {"p\n", 1, 2, "expected the number of vertices"},
    {"p 2\n0 0 0\n1 0 0\n", 1, 3, "whole number from 3 to 16384, not \"2\""},
    {"p -3\n0 0 0 1 0 0 0 1 0\n", 1, 3, "whole number from 3 to 16384"},
    {"p 999999999\n0 0 0\n", 1, 3, "whole number from 3 to 16384"},
    {"p 16384\n0 0 0\n", 1, 3, "the number of vertices 16384 is more than the rest of the file can contain"},
    {"p 3\n0 0 0\n1 0 0\n0 1\n", 4, 4, "expected a vertex, found the end of the file"},
    {"p 3\n0 0 0\n1 x 0\n0 1 0\n", 3, 3, "expected a vertex, found \"x\""},
    {"p 3\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", 5, 1, "expected a keyword"},
    {"pp 3\n0 0 0 0 0 1\n1 0 0 0 0 0\n0 1 0 0 0 1\n", 3, 7, "a vertex normal has length 0"},
    {"pp 3\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0\n", 4, 10, "expected a vertex normal"},
    {"pp 2000\n0 0 0 0 0 1\n", 1, 4, "is more than the rest of the file can contain"},
    {"pl 0 0 0 1 0 0\n", 1, 15, "expected a point of the plane"},
    {"pl 0 0 0 1 1 1 2 2 2\n", 1, 1, "three points lie on a line"},
    {"npl 0 0 0 1\n", 1, 5, "normal has length 0"},
    {"npl 1e-30 0 0 1e30\n", 1, 5, "the plane is beyond the range of single precision"},
    {"npl 0 0 1\n", 1, 10, "expected the distance d"},
    {"box 0 0 0 1 1\n", 1, 14, "expected the maximum corner"},
    {"aabb 0 0 0 1 one 1\n", 1, 14, "found \"one\"; the form is: box"},
    {"mesh 4000000000 1\n0 0 0\n", 1, 6, "is more than the rest of the file can contain"},
    {"mesh 3 4000000000\n0 0 0 1 0 0 0 1 0\n1 2 3\n", 1, 8, "is more than the rest of the file can contain"},
    {"mesh -3 1\n", 1, 6, "the number of vertices must be a whole number"},
    {"mesh 3 -1\n0 0 0 1 0 0 0 1 0\n", 1, 8, "the number of triangles must be a whole number"},
    {"mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 2 4\n", 3, 5, "a vertex index must be a whole number from -3 to 3, not \"4\""},
    {"mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 2 -4\n", 3, 5, "from -3 to 3"},
    {"mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 0 2\n", 3, 3, "vertex index 0: indices count from 1"},
    {"mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 2 1.5\n", 3, 5, "whole number"},
    {"mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 2\n", 3, 4, "expected a vertex index"},
    // Places: tabs count one column, all kinds of line end count one line
    {"\t s 0 0 bad 1\n", 1, 9, "found \"bad\""},
    {"# one\r\n# two\r# three\ns 0 0 0 x", 4, 9, "found \"x\""},
    {"\xef\xbb\xbfs 0 0 0 x\n", 1, 9, "found \"x\""},
};

}  // namespace

TEST_CASE("each malformed scene is refused with line, column and the expected content") {
  REQUIRE(kMalformed.size() >= 70);
  for (const Malformed& malformed : kMalformed) {
    CAPTURE(malformed.text);
    const std::vector<Diagnostic> errors = errorsOf(malformed.text);
    REQUIRE_FALSE(errors.empty());
    CAPTURE(toString(errors[0]));
    CHECK(errors[0].file == "test");
    CHECK(errors[0].line == malformed.line);
    CHECK(errors[0].column == malformed.column);
    CHECK(contains(errors[0].message, malformed.message));
  }
}

TEST_CASE("a single mistake in a scene is reported once") {
  for (const std::string text :
       {"p 3\n0 0 0\n1 x 0\n0 1 0\ns 0 0 0 1\n", "mesh 3 1\n0 0 0 1 0 0 0 1 0\n1 2 4\ns 0 0 0 1\n",
        "v\nfrom 0 0 1\natt 0 0 0\nup 0 1 0\nangle 45\nhither 0\nresolution 8 8\ns 0 0 0 1\n",
        "Q 1 2\n3 4 5\n6\ns 0 0 0 1\n"}) {
    CAPTURE(text);
    CHECK(errorsOf(text).size() == 1);
  }
}

TEST_CASE("all errors of a file are reported, in the order of the file") {
  const auto errors = errorsOf("s 0 0 0\nspehre 1\ns 0 0 0 1\nb 1 x 1\nv\nangle 200\n");
  REQUIRE(errors.size() == 4);
  CHECK(toString(errors[0]) ==
        "test:1:8: expected the radius, found \"spehre\" on line 2; the form is: s x y z radius");
  CHECK(toString(errors[1]) == "test:2:1: unknown keyword \"spehre\"; did you mean \"s\"?");
  CHECK(toString(errors[2]) == "test:4:5: expected the background's colour, found \"x\"; the form is: b r g b");
  CHECK(toString(errors[3]) == "test:6:7: the angle must be greater than 0 and less than 180 degrees");
}

TEST_CASE("all invalid values of a statement are reported") { CHECK(errorsOf("f -1 1 1 1 0 -1 0 -1\n").size() == 3); }

TEST_CASE("a hundred errors are listed and the rest counted") {
  std::string text;
  for (int i = 0; i < 250; ++i) text += "oops\n";
  const auto errors = errorsOf(text);
  REQUIRE(errors.size() == 101);
  CHECK(errors[99].line == 100);
  CHECK(toString(errors[100]) == "test: and 150 more errors");
}

TEST_CASE("reading stops after ten thousand errors") {
  std::string text;
  for (int i = 0; i < 20'000; ++i) text += "oops\n";
  CHECK(errorsOf(text).back().message == "and at least 9900 more errors; reading stopped there");
}

TEST_CASE("what() of a scene error contains every line") {
  const SceneError error({{"a", 1, 2, "first"}, {"a", 0, 0, "second"}});
  CHECK(std::string(error.what()) == "a:1:2: first\na: second");
  CHECK(error.code() == ExitCode::file);
}

TEST_CASE("a missing file is an error that names it") {
  CHECK_THROWS_WITH(formats::loadScene("/nonexistent/scene.p3f"),
                    Catch::Contains("/nonexistent/scene.p3f: cannot open"));
  CHECK_THROWS_AS(formats::loadScene("/"), FileError);
}

}  // namespace candela::scene
