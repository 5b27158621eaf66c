// Files of Mitsuba that are wrong: every error has its line and column, and hostile files take neither time nor memory.
#include "tests/formats/mitsuba/mitsuba_file.h"

namespace candela::mitsuba {
namespace {

std::string errorsOfText(const std::string& text) {
  try {
    mitsubaLoader().open({text, "test.xml", "/nonexistent"}, {}, false)->at({});
    return {};
  } catch (const Error& error) {
    return error.what();
  }
}

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

}  // namespace

TEST_CASE("Errors of Mitsuba files have their places") {
  const std::pair<const char*, const char*> cases[]{
      {"<shape type=\"sphere\">\n</shpae>", "test.xml:3:"},
      {"<spere/>", "2:1: unknown element \"spere\""},
      {"<shape/>", "2:1: <shape> has no attribute \"type\""},
      {"<shape type=\"sphere\" typ=\"x\"/>", "2:1: <shape> does not have an attribute \"typ\"; did you mean \"type\"?"},
      {"<shape type=\"sphere\" id=\"a\"/>\n <shape type=\"cube\" id=\"a\"/>", "3:2: the id \"a\" is used twice"},
      {"<shape type=\"sphere\"><ref id=\"b\"/></shape>", "2:22: no object has the id \"b\""},
      {"<shape type=\"sphere\">text</shape>", "2:1: the element <shape> contains the text \"text\""},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"1 2\"/></shape>",
       "2:22: expected a finite number instead of \"1 2\""},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"nan\"/></shape>", "2:22: expected a finite number"},
      {"<shape type=\"sphere\"><integer name=\"radius\" value=\"1.5\"/></shape>",
       "2:22: expected an integer instead of \"1.5\""},
      {"<shape type=\"sphere\"><boolean name=\"flip_normals\" value=\"yes\"/></shape>", "2:22: expected true or false"},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"1\"/><float name=\"radius\" value=\"2\"/></shape>",
       "2:54: \"radius\" of shape \"sphere\" is stated twice"},
      {"<shape type=\"sphere\"><string name=\"radius\" value=\"1\"/></shape>",
       "2:22: \"radius\" of shape \"sphere\" is not a number"},
      {"<shape type=\"sphere\"><float name=\"radius\" value=\"0\"/></shape>",
       "2:1: the radius of a sphere is positive"},
      {"<shape type=\"sphere\"><transform name=\"to_world\"><rotate angle=\"3\"/></transform></shape>",
       "2:49: the axis of <rotate> has no length"},
      {"<shape type=\"sphere\"><transform name=\"to_world\"><matrix value=\"1 2\"/></transform></shape>",
       "2:49: <matrix> has 2 numbers instead of 9 or 16"},
      {"<shape type=\"sphere\"><transform name=\"to_world\"><lookat origin=\"0 0 0\" target=\"0 0 "
       "0\"/></transform></shape>",
       "2:49: origin and target of <lookat> are equal"},
      {"<translate x=\"1\"/>", "2:1: unknown element \"translate\""},
      {"<bsdf type=\"diffuse\" id=\"a\"><ref id=\"a\"/></bsdf>", "2:1: bsdf \"diffuse\" refers to itself"},
      {"<float name=\"x\" value=\"1\"/>", "2:1: scene has no property \"x\""},
      {"<emitter type=\"area\"/>", "2:1: an emitter \"area\" belongs to a shape"},
      {"<integrator type=\"path\"/><integrator type=\"path\"/>", "2:26: the scene has a second integrator"},
      {"<shape type=\"rectangle\"><bsdf type=\"twosided\"/></shape>", "2:25: bsdf \"twosided\" has no nested BSDF"},
      {"<shape type=\"instance\"/>", "2:1: an instance refers to a shape \"shapegroup\""},
      {"<shape type=\"sphere\"><transform name=\"to_world\"><translate x=\"1e39\"/></transform></shape>",
       "2:1: the sphere is placed beyond"},
  };
  for (const auto& [content, message] : cases) {
    CAPTURE(content);
    CHECK_THAT(xmlErrorsOf(content), Catch::Contains(message));
  }
  const std::string several = xmlErrorsOf("<shape type=\"a\"/>\n<shape type=\"b\"/>\n<emitter type=\"c\"/>");
  CHECK_THAT(several, Catch::Contains("2:1: ") && Catch::Contains("3:1: ") && Catch::Contains("4:1: "));
}

TEST_CASE("What is no scene of Mitsuba is refused") {
  CHECK_THAT(errorsOfText("<scene>"), Catch::Contains("test.xml:1:"));
  CHECK_THAT(errorsOfText("<scene></scene>"), Catch::Contains("1:1: <scene> has no attribute \"version\""));
  CHECK_THAT(errorsOfText("<scene version=\"x\"/>"), Catch::Contains("1:1: \"x\" is no version"));
  CHECK_THAT(errorsOfText("<html version=\"3\"/>"), Catch::Contains("1:1: the root element is <html>"));
  CHECK_THAT(errorsOfText("<scene version=\"3\"/><scene version=\"3\"/>"),
             Catch::Contains("1:21: the file has a second root element"));
  CHECK_THAT(errorsOfText("<scene version=\"3\" version=\"3\"/>"),
             Catch::Contains("the attribute \"version\" is stated twice"));
  CHECK_THAT(errorsOfText("<?xml version=\"1.0\"?>\n<!DOCTYPE scene [<!ENTITY a \"b\">]>\n<scene version=\"3\"/>"),
             Catch::Contains("2:1: document type declarations (DOCTYPE) are not read"));
  CHECK_THAT(errorsOfText(std::string("<scene version=\"3\">\0</scene>", 28)),
             Catch::Contains("the file has a byte 0"));
}

TEST_CASE("Hostile files of Mitsuba are refused at once") {
  CHECK_THAT(xmlErrorsOf(repeated("<bsdf type=\"mask\">", 70) + repeated("</bsdf>", 70)),
             Catch::Contains("nested more than 64 deep"));
  CHECK_THAT(xmlErrorsOf("<bsdf type=\"diffuse\" id=\"b0\"/>" +
                         [] {
                           std::string chain;
                           for (int i = 1; i < 40; ++i)
                             chain += "<bsdf type=\"twosided\" id=\"b" + std::to_string(i) + "\"><ref id=\"b" +
                                      std::to_string(i - 1) + "\"/></bsdf>";
                           return chain;
                         }() +
                         withBsdf("<ref id=\"b39\"/>")),
             Catch::Contains("BSDFs are nested more than 16 deep"));
  std::string doubling = "<default name=\"a0\" value=\"xxxxxxxxxxxxxxxx\"/>";
  for (int i = 1; i < 40; ++i)
    doubling += "<default name=\"a" + std::to_string(i) + "\" value=\"$a" + std::to_string(i - 1) + "_$a" +
                std::to_string(i - 1) + "_\"/>";
  CHECK_THAT(xmlErrorsOf(doubling),
             Catch::Contains("values with parameters take more than 64 MiB") || Catch::Contains("has no value"));
  std::string attributes;
  for (int i = 0; i < 100; ++i) attributes += " a" + std::to_string(i) + "=\"\"";
  CHECK_THAT(xmlErrorsOf("<shape" + attributes + "/>"), Catch::Contains("more than 64 attributes"));
  CHECK(xmlErrorsOf(repeated("<shape type=\"wrong\"/>", 200)).find("and 100 more errors") != std::string::npos);
}

TEST_CASE("Files are recognised by their first tag") {
  const auto recognises = [](const std::string& text) { return mitsubaLoader().recognises(text); };
  CHECK(recognises("<scene version=\"3\">"));
  CHECK(recognises("\xef\xbb\xbf<?xml version=\"1.0\"?>\n<!-- a\n -->\n<scene\nversion=\"3\">"));
  CHECK_FALSE(recognises("<scenery/>"));
  CHECK_FALSE(recognises("<svg/>"));
  CHECK_FALSE(recognises("<!-- <scene>"));
  CHECK_FALSE(recognises("v 1 2 3\n"));
}

}  // namespace candela::mitsuba
