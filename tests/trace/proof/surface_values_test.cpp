// Values of lobes of surfaces in closed form: docs/light-transport.md sections 5.1 to 5.11.
#include <catch2/catch.hpp>
#include <complex>

#include "tests/trace/proof/hemisphere.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/surface_material.h"

using namespace candela;
using namespace candela::proof;

namespace {

double valueAt(const MaterialLeaves& leaves, std::uint32_t material, const dvec3& wo, const dvec3& wi) {
  return leaves.evaluate(std::vector<DirectionPair>{{material, wo, wi}}).front().f.x;
}

// Computed from the formulas of KHR_materials_iridescence to ten digits, with the cosine inside of the film in the path
// difference: cosine, index and thickness of the film, grey reflectance of the base, and the three channels.
struct FilmValue {
  double cosine;
  float ior, thickness, base;
  dvec3 reflectance;
};
const FilmValue kFilmOnDielectric[]{{0.7, 1.3f, 400, 0.04f, {0.0005240861571, 0.01037269638, 0.04155650075}},
                                    {0.3, 1.8f, 250, 0.04f, {0.2194129015, 0.2974542537, 0.2593192126}}};

// Black below the dielectric, which reflects 0.08 at normal incidence and is dimmed to 0.04 by the specular weight.
scene::Material dimmedBelowFilm(const FilmValue& value, float filmWeight, float transmission) {
  return materialOf({.baseColour = {0, 0, 0},
                     .specularColour = {2, 2, 2},
                     .specularWeight = 0.5f,
                     .roughness = 0.6f,
                     .transmissionWeight = transmission,
                     .filmWeight = filmWeight,
                     .filmIor = value.ior,
                     .filmThickness = value.thickness});
}

}  // namespace

TEST_CASE("a highlight's centre has the value of the closed form, with Schlick's reflectance") {
  const float roughness = 0.3f;
  const MaterialLeaves leaves({materialOf({.baseColour = {0, 0, 0}, .roughness = roughness, .ior = 1.5f}),
                               materialOf({.baseColour = {0, 0, 0}, .metalness = 1, .roughness = roughness}),
                               materialOf({.baseColour = {0, 0, 0}, .specularWeight = 0.5f, .roughness = roughness})});
  const double alpha = std::pow(double{roughness}, 2);
  for (const double cosine : {1.0, 0.7, 0.3}) {
    const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
    const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
    const double white = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);  // D V at h = z
    const double grazing = std::pow(1 - cosine, 5), reflectance = 0.04 + 0.96 * grazing;
    const double coated = valueAt(leaves, 0, wo, wi);
    CAPTURE(cosine);
    CHECK(valueAt(leaves, 1, wo, wi) == Approx(white * grazing).epsilon(1e-4).margin(1e-6));
    CHECK(coated >= white * reflectance);  // compensation adds less than 4 percent of the lost light
    CHECK(coated <= white * reflectance * 1.01);
    CHECK(valueAt(leaves, 2, wo, wi) == Approx(coated / 2).epsilon(1e-4));
  }
}

TEST_CASE("sheen has the values of the closed form") {
  // Computed to ten digits from the formulas of KHR_materials_sheen, and for the last the factor 0.25/0.258: roughness,
  // cosines, turn between the azimuths, value.
  struct Value {
    float roughness;
    double cosO, cosI, turn, f;
  };
  const std::vector<Value> values{{0.5f, 0.3, 0.3, 0.0, 0.3272520834},
                                  {0.5f, 0.8, 0.25, 0.2, 0.08603476271},
                                  {1, 0.6, 0.9, 0.4, 0.0455633868},
                                  {0.25f, 0.1, 0.15, 0.02, 1.671900698}};
  std::vector<scene::Material> materials;
  for (const Value& value : values) {
    materials.push_back(materialOf({.baseColour = {0, 0, 0},
                                    .specularWeight = 0,
                                    .sheenColour = {1, 0.5f, 0},
                                    .sheenRoughness = value.roughness}));
  }
  const MaterialLeaves leaves(materials);
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const dvec3 wo = directionAt(values[i].cosO, 0.1), wi = directionAt(values[i].cosI, 0.1 + values[i].turn);
    const dvec3 f = leaves.evaluate(std::vector<DirectionPair>{{i, wo, wi}}).front().f;
    CAPTURE(i);
    CHECK(f.x == Approx(values[i].f).epsilon(100 * kRounding + 1e-6));
    CHECK(f.y == Approx(values[i].f / 2).epsilon(100 * kRounding + 1e-6));
    CHECK(f.z == 0);
  }
}

TEST_CASE("conductors reflect by Fresnel's equations, in complex numbers and with the published values of gold") {
  const float roughness = 0.3f;
  const MaterialLeaves leaves({materialOf({.metalness = 1, .roughness = roughness, .conductor = kGold}),
                               materialOf({.metalness = 1, .roughness = roughness})});
  for (const double cosine : {1.0, 0.8, 0.5, 0.2, 0.05}) {
    const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
    const dvec3 gold = leaves.evaluate(std::vector<DirectionPair>{{0, wo, wi}}).front().f;
    const double white = valueAt(leaves, 1, wo, wi);  // compensated for a reflectance of 1
    for (int channel = 0; channel < 3; ++channel) {
      const std::complex<double> index(kGold.ior[channel], kGold.extinction[channel]);
      const auto reflectance = [&](double x) {
        const std::complex<double> inside = std::sqrt(1.0 - (1 - x * x) / (index * index));
        return (std::norm((x - index * inside) / (x + index * inside)) +
                std::norm((index * x - inside) / (index * x + inside))) /
               2;
      };
      const double normal = reflectance(1), alpha = std::pow(double{roughness}, 2);
      const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
      const double once = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);  // D V at h = z
      const double compensation = 1 + normal * (white / once - 1);
      CAPTURE(cosine, channel);
      CHECK(gold[channel] == Approx(once * compensation * reflectance(cosine)).epsilon(100 * kRounding + 1e-5));
    }
  }
}

TEST_CASE("thin films have the reflectance that the formulas of KHR_materials_iridescence give") {
  const std::vector<FilmValue> values{{1, 1.3f, 400, 0.5f, {0.3411227856, 0.4951023496, 0.3802559227}},
                                      kFilmOnDielectric[0],
                                      kFilmOnDielectric[1],
                                      {0.5, 1.5f, 900, 0.9f, {0.8230353566, 0.8799916314, 0.8673222819}}};
  const float roughness = 0.3f;
  std::vector<scene::Material> materials{materialOf({.metalness = 1, .roughness = roughness})};
  for (const FilmValue& value : values) {
    materials.push_back(materialOf({.baseColour = glm::vec3(value.base),
                                    .metalness = 1,
                                    .roughness = roughness,
                                    .filmWeight = 1,
                                    .filmIor = value.ior,
                                    .filmThickness = value.thickness}));
  }
  const MaterialLeaves leaves(materials);
  for (std::uint32_t i = 0; i < values.size(); ++i) {
    const double cosine = values[i].cosine, alpha = std::pow(double{roughness}, 2);
    const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
    const dvec3 f = leaves.evaluate(std::vector<DirectionPair>{{i + 1, wo, wi}}).front().f;
    const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
    const double once = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);
    const dvec3 compensation = 1.0 + values[i].reflectance * (valueAt(leaves, 0, wo, wi) / once - 1);
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(i, channel, values[i].reflectance[channel]);
      const double expected = once * compensation[channel] * values[i].reflectance[channel];
      CHECK(f[channel] == Approx(expected).epsilon(100 * kRounding).margin(once * (kRounding + 1e-6)));
    }
  }
}

TEST_CASE("a thin film of thickness 0 is no film") {
  const FilmValue thin{1, 1.3f, 0, 0.04f, {}};
  for (const float transmission : {0.0f, 1.0f}) {
    const FilmValue visible{1, 1.3f, 400, 0.04f, {}};
    const MaterialLeaves leaves({dimmedBelowFilm(thin, 1, transmission), dimmedBelowFilm(thin, 0, transmission),
                                 dimmedBelowFilm(visible, 1, transmission)});
    for (const double cosine : {1.0, 0.7, 0.3}) {
      const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
      const auto values = leaves.evaluate(std::vector<DirectionPair>{{0, wo, wi}, {1, wo, wi}, {2, wo, wi}});
      CAPTURE(transmission, cosine);
      for (int channel = 0; channel < 3; ++channel) {
        CHECK(values[0].f[channel] == values[1].f[channel]);
        CHECK(values[0].f[channel] != values[2].f[channel]);
      }
      CHECK(values[0].f.x == values[0].f.y);
      CHECK(values[0].f.x == values[0].f.z);
    }
  }
}

TEST_CASE("the specular weight dims the dielectric below a thin film, but not the film") {
  for (const FilmValue& value : kFilmOnDielectric) {
    for (const float covered : {1.0f, 0.25f}) {
      const MaterialLeaves leaves({dimmedBelowFilm(value, covered, 0), dimmedBelowFilm(value, covered, 1),
                                   materialOf({.metalness = 1, .roughness = 0.6f})});
      const double cosine = value.cosine, alpha = 0.36;
      const dvec3 wo = directionAt(cosine, 0.1), wi(-wo.x, -wo.y, wo.z);
      const dvec3 opaque = leaves.evaluate(std::vector<DirectionPair>{{0, wo, wi}}).front().f;
      const dvec3 glass = leaves.evaluate(std::vector<DirectionPair>{{1, wo, wi}}).front().f;
      const double length = std::sqrt(alpha * alpha * (1 - cosine * cosine) + cosine * cosine);
      const double once = 1 / (std::numbers::pi * alpha * alpha) / (4 * cosine * length);  // D V at h = z
      const double white = valueAt(leaves, 2, wo, wi);                                     // D V / E
      const double bare = 0.5 * (0.08 + 0.92 * std::pow(1 - cosine, 5));
      for (int channel = 0; channel < 3; ++channel) {
        const double film = value.reflectance[channel];
        const double reflectance = covered * film + (1 - covered) * bare;
        const double compensation = 1 + (covered * film + (1 - covered) * 0.08) * (white / once - 1);
        CAPTURE(cosine, covered, channel);
        CHECK(opaque[channel] ==
              Approx(once * compensation * reflectance).epsilon(100 * kRounding).margin(once * (kRounding + 1e-6)));
        CHECK(glass[channel] ==
              Approx(white * reflectance).epsilon(100 * kRounding).margin(white * (kRounding + 1e-6)));
      }
    }
  }
}
