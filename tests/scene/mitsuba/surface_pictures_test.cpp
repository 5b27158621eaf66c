// Colours, materials, textures and environments of Mitsuba, whose pixels have values of a closed form.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "host/image/colour_transfer.h"
#include "tests/scene/mitsuba/mitsuba_scenes.h"

namespace candela::mitsuba {
namespace {

using glm::dvec3;

/// The colour of three bytes that are encoded in sRGB.
dvec3 bytes(int r, int g, int b) {
  return {image::srgbDecode(r / 255.0), image::srgbDecode(g / 255.0), image::srgbDecode(b / 255.0)};
}

/// The reflectance of a conductor at normal incidence.
dvec3 normalReflectance(const dvec3& n, const dvec3& k) {
  return ((n - 1.0) * (n - 1.0) + k * k) / ((n + 1.0) * (n + 1.0) + k * k);
}

/// The light that passes a slab or a pane in the direction of its normal, with all reflections inside of it.
double slabTransmittance(double ior) {
  const double r = std::pow((ior - 1) / (ior + 1), 2);
  return (1 - r) / (1 + r);
}

// The primaries of sRGB times the white of equal energy.
const dvec3 kEqualEnergy(1.204794, 0.948291, 0.908916);

// An eighth of 2856 K, CIE's illuminant A: its white point (1.0985, 1, 0.35585), with the luminance of Planck's law by
// the function of Wyman, Sloan and Shirley, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions"
// (2013).
const dvec3 kLamp(62.464, 27.965, 7.899);

}  // namespace

TEST_CASE("Every kind of spectrum is an emitter's radiance") {
  checkRow("spectra_of_emitters.xml",
           {{3, 2, 1},
            dvec3(0.5),
            2.0 * kEqualEnergy,
            dvec3(0.75),
            {0.1, 0.2, 0.3},
            dvec3(4),
            dvec3(1.5),
            kEqualEnergy,
            kEqualEnergy,
            kEqualEnergy,
            kLamp,
            {4, 2, 1}},
           {}, 5e-3);
}

TEST_CASE("Every kind of spectrum is a reflectance") {
  checkRow(
      "spectra_of_reflectances.xml",
      {{0.9, 0.5, 0.1}, dvec3(0.25), dvec3(0.75), dvec3(0.125), {0.1, 0.2, 0.3}, dvec3(0.5), dvec3(0.25), dvec3(0.5)},
      {}, 2e-3);
}

TEST_CASE("A scene of Mitsuba 0.6 has its colours and its textures") {
  checkRow("mitsuba_0_6.xml", {bytes(255, 128, 0), bytes(0, 128, 255), {0.25, 0.5, 0.75}, kLamp, bytes(0, 204, 102)},
           {}, 5e-3);
}

TEST_CASE("Textures show the texels that their transforms and wrap modes select") {
  const dvec3 first = bytes(255, 51, 0), second = bytes(0, 204, 102), third = bytes(51, 102, 255);
  checkRow("textures.xml", {first,
                            second,
                            third,
                            {1, 0.2, 0},
                            first,
                            second,
                            second,
                            (first + second + third + 1.0) / 4.0,
                            {0.1, 0.2, 0.3},
                            {0.7, 0.8, 0.9},
                            dvec3(0.75)});
}

TEST_CASE(
    "A principal point that is not in the centre, and a sensor that mirrors, show another part of the view plane") {
  const dvec3 first = bytes(255, 51, 0), second = bytes(0, 204, 102), third = bytes(51, 102, 255);
  const auto check = [](const char* x, const char* y, const dvec3& expected, const char* mirror = "1") {
    checkRow("principal_point.xml", {expected},
             {{}, {std::string("x=") + x, std::string("y=") + y, std::string("mirror=") + mirror}});
  };
  check("0", "0", first);
  check("1", "0", second);
  check("-1", "0", first);
  check("0.5", "0", (first + second) / 2.0);
  check("0", "-1", third);
  check("0", "1", first);
  check("0", "-0.25", 0.75 * first + 0.25 * third);
  check("1", "-1", dvec3(1));
  check("1", "0", first, "-1");
  check("-1", "0", second, "-1");
  check("-0.25", "-1", 0.75 * third + 0.25, "-1");
}

TEST_CASE("Materials reflect a light at normal incidence by their indices of refraction") {
  const dvec3 metal = normalReflectance({0.2, 0.9, 1.5}, {4, 2.5, 2});
  checkRow("reflections.xml",
           {dvec3(1), dvec3(0.9, 0.5, 0.1), metal, normalReflectance({0.143, 0.375, 1.442}, {3.983, 2.386, 1.603}),
            metal, dvec3(0.04), dvec3(0.04), dvec3(0.5), dvec3(0.25), dvec3(0)},
           {}, 3e-3);
}

// The eye sees the plates along their normals, so that the masking of its direction is 1. Half vectors have the cosine
// 0.6 sqrt(2.5) and the square 1/9 of their tangent.
TEST_CASE("Materials scatter light that arrives at an angle by their models") {
  constexpr double kCosine = 0.8, kTangent = 0.75;
  const double cosH = 0.6 * std::sqrt(2.5);
  const auto ggx = [&](double alpha) {
    const double d = 1 / (alpha * alpha * std::pow(cosH, 4) * std::pow(1 + 1 / (9 * alpha * alpha), 2));
    return d * 2 / (1 + std::sqrt(1 + std::pow(alpha * kTangent, 2))) / 4;
  };
  const auto beckmann = [&](double along, double across) {
    const double q = 1 / (along * kTangent);
    const double masking = q >= 1.6 ? 1 : (3.535 * q + 2.181 * q * q) / (1 + 2.276 * q + 2.577 * q * q);
    return std::exp(-1 / (9 * along * along)) / (along * across * std::pow(cosH, 4)) * masking / 4;
  };
  const double cosT = std::sqrt(1 - (1 - cosH * cosH) / 2.25);
  const double s = (cosH - 1.5 * cosT) / (cosH + 1.5 * cosT), p = (cosT - 1.5 * cosH) / (cosT + 1.5 * cosH);
  const dvec3 light(0.6, 0, kCosine), tilted = glm::normalize(dvec3(204, 128, 230) / 127.5 - 1.0);
  const dvec3 slope = glm::normalize(dvec3(-0.64, 0, 1));  // heights rise by 2 (0.36 - 0.04) over half of the width 2
  const auto mapped = [&](const dvec3& normal) {           // with the shadows of bumps
    const double steepness = std::min((1 / (normal.z * normal.z) - 1) / 8, 1.0);
    return 0.5 * dot(normal, light) * 2 / (1 + std::sqrt(1 + steepness * kTangent * kTangent));
  };
  checkRow("scattering.xml",
           {dvec3(ggx(0.5)), dvec3(beckmann(0.5, 0.5)), dvec3(beckmann(0.5, 0.2)), dvec3((ggx(0.04) + ggx(0.36)) / 2),
            dvec3(0.75 * (s * s + p * p) / 2 * beckmann(0.5, 0.5)), dvec3(mapped(tilted)),
            dvec3((mapped({0, 0, 1}) + mapped(slope)) / 2), dvec3(0.35 * kCosine), dvec3(0.75 * 0.8 * kCosine),
            dvec3(0.8 * kCosine), dvec3(0), dvec3((beckmann(0.5, 0.2) + beckmann(0.2, 0.5)) / 2),
            dvec3((beckmann(0.04, 0.2) + beckmann(0.36, 0.2)) / 2)},
           {}, 2e-3);
}

TEST_CASE("Slabs, panes and holes transmit a light at normal incidence") {
  const double glass = slabTransmittance(1.5);
  checkRow("transmissions.xml",
           {dvec3(glass), dvec3(slabTransmittance(2.419)), dvec3(glass), glass * dvec3(0.9, 0.5, 0.1), dvec3(0.75),
            dvec3(1)},
           {}, 3e-3);
}

// A ball of radius 0.95 covers the fraction 0.95^2 pi/4 of its pixel.
TEST_CASE("Balls that do not absorb cannot be seen in a constant environment") {
  const dvec3 light(0.5, 1, 2);
  const double covered = 0.95 * 0.95 * std::numbers::pi / 4;
  checkRow("furnace.xml", {light, (1 - covered / 2) * light, light, light, light, light}, {}, 2e-3);
}

// The rows of a map of two rows are the poles. Halfway to the horizon, the near one has the weight 3/4.
TEST_CASE("An environment map has Mitsuba's directions and scale") {
  const dvec3 first(3.75, 0, 0), second(0, 3.75, 0), third(0, 0, 5.25), fourth(5.25, 5.25, 0);
  const std::vector<std::string> turned{"angle=90"};
  checkRow("environment.xml", {first}, {"first"});
  checkRow("environment.xml", {second}, {"second"});
  checkRow("environment.xml", {third}, {"third"});
  checkRow("environment.xml", {fourth}, {"fourth"});
  checkRow("environment.xml", {second}, {"first", turned});
  checkRow("environment.xml", {fourth}, {"third", turned});
}

TEST_CASE("Attributes of meshes colour their vertices and their faces") {
  checkRow("mesh_attributes.xml", {{0.1, 0.2, 0.3},
                                   {0.9, 0.5, 0.1},
                                   bytes(255, 51, 0),
                                   bytes(0, 204, 102),
                                   dvec3(0.125),
                                   dvec3(0.375),
                                   {0.25, 0.5, 0.75},
                                   {0.75, 0.5, 0.25},
                                   dvec3(0.5),
                                   dvec3(0.5)});
}

}  // namespace candela::mitsuba
