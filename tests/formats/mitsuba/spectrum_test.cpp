// Spectra of Mitsuba as colours.
#include "host/formats/mitsuba/spectrum.h"

#include "host/formats/mitsuba/materials.h"
#include "tests/formats/mitsuba/mitsuba_file.h"

namespace candela::mitsuba {
namespace {

glm::vec3 reflectanceOf(const std::string& value) {
  return materialOf("<bsdf type=\"diffuse\">" + value + "</bsdf>").diffuse->colour;
}

glm::vec3 radianceOf(const std::string& value) {
  return xmlSceneOf("<emitter type=\"constant\">" + value + "</emitter>").background;
}

}  // namespace

TEST_CASE("Numbers and colours of Mitsuba are linear") {
  CHECK(reflectanceOf(R"(<rgb name="reflectance" value="0.1, 0.2 0.3"/>)") == glm::vec3(0.1f, 0.2f, 0.3f));
  CHECK(reflectanceOf(R"(<rgb name="reflectance" value=".7"/>)") == glm::vec3(0.7f));
  CHECK(reflectanceOf(R"(<float name="reflectance" value="0.25"/>)") == glm::vec3(0.25f));
  CHECK(reflectanceOf(R"(<spectrum name="reflectance" value="0.25"/>)") == glm::vec3(0.25f));
  CHECK(
      reflectanceOf(R"(<spectrum type="uniform" name="reflectance"><float name="value" value="0.125"/></spectrum>)") ==
      glm::vec3(0.125f));
  CHECK(radianceOf(R"(<rgb name="radiance" value="3 2 1"/>)") == glm::vec3(3, 2, 1));
}

// The matrix from XYZ to sRGB times (1, 1, 1); the matching functions integrate to (1, 1, 1) but for their tabulation.
TEST_CASE("A constant spectrum of an emitter is reddish in sRGB, and one of a surface is grey") {
  CHECK(near(radianceOf(R"(<spectrum name="radiance" value="2"/>)"), 2.0 * glm::dvec3(1.204794, 0.948291, 0.908916)));
  const glm::dvec3 emission = rgbOf({{{360, 1}, {830, 1}}}, ColourUse::emission);
  CHECK(near(glm::vec3(emission), {1.204794, 0.948291, 0.908916}, 2e-3));
  const glm::dvec3 reflectance = rgbOf({{{360, 0.5}, {830, 0.5}}}, ColourUse::reflectance);
  CHECK(near(glm::vec3(reflectance), glm::dvec3(0.5), 2e-3));
}

TEST_CASE("Spectra are interpolated between their wavelengths, and 0 beyond them") {
  const glm::dvec3 red = rgbOf({{{600, 1}, {830, 1}}}, ColourUse::reflectance);
  CHECK(red.x > 0.8);
  CHECK(red.y == 0);  // limited: sRGB has no such red
  const glm::dvec3 whole = rgbOf({{{360, 0}, {595, 1}, {830, 0}}}, ColourUse::emission);
  const glm::dvec3 left = rgbOf({{{360, 0}, {595, 1}}}, ColourUse::emission);
  const glm::dvec3 right = rgbOf({{{595.0000001, 1}, {830, 0}}}, ColourUse::emission);
  CHECK(whole.x == Approx(left.x + right.x).epsilon(1e-3));
}

// 6504 K is the temperature of D65, whose chromaticity is near that of a black body.
TEST_CASE("A black body has the radiance of Planck's law, and the colour of its temperature") {
  const auto at = [&](const char* kelvin) {
    return radianceOf(std::string(R"(<spectrum type="blackbody" name="radiance"><float name="temperature" value=")") +
                      kelvin + "\"/></spectrum>");
  };
  const glm::vec3 day = at("6504"), lamp = at("2856");
  CHECK(day.x / day.y == Approx(1).margin(0.08));
  CHECK(day.z / day.y == Approx(1).margin(0.08));
  CHECK(lamp.x > 3 * lamp.z);
  // The luminous efficacy of the radiation of illuminant A is known: 683 lm/W times Y over sigma T^4 / pi is 15.4 lm/W
  // (Y here is the integral over the observer divided by 106.75 nm).
  const double y = 0.2126 * lamp.x + 0.7152 * lamp.y + 0.0722 * lamp.z;
  CHECK(683 * 106.75026 * y / (5.670374e-8 * std::pow(2856.0, 4) / 3.14159265) == Approx(16).margin(1));
}

TEST_CASE("Conductors of Mitsuba have the indices of refraction of their material") {
  const scene::Material copper = materialOf(R"(<bsdf type="conductor"><string name="material" value="Cu"/></bsdf>)");
  REQUIRE(copper.surface);
  REQUIRE(copper.surface->conductor);
  CHECK(near(copper.surface->conductor->ior, {0.20101, 0.92375, 1.1022}));
  CHECK(near(copper.surface->conductor->extinction, {3.9133, 2.453, 2.1421}));
  CHECK(copper.surface->metalness == 1);
  CHECK(copper.surface->roughness == 0);
  CHECK(copper.surface->baseColour == glm::vec3(1));
  CHECK(materialOf(R"(<bsdf type="conductor"/>)").mirror == scene::MirrorLobe{glm::vec3(1)});
  CHECK(materialOf(R"(<bsdf type="conductor"/>)", "0.6.0").surface->conductor == copper.surface->conductor);
  const scene::Material stated = materialOf(
      R"(<bsdf type="conductor"><rgb name="eta" value="0 1 2"/><float name="k" value="4"/></bsdf>)");
  CHECK(stated.surface->conductor == scene::Conductor{{kMinIor, 1, 2}, glm::vec3(4)});
  CHECK(xmlErrorsOf(withBsdf(R"(<bsdf type="conductor"><string name="material" value="Kupfer"/></bsdf>)"))
            .find("2:48: no material has the name \"Kupfer\"") != std::string::npos);
}

}  // namespace candela::mitsuba
