// Lobes, compared with their densities and with quadrature, and tests of reciprocity and energy:
// docs/light-transport.md section 5.
#include <catch2/catch.hpp>

#include "tests/trace/proof/cells.h"
#include "tests/trace/proof/chi_square.h"
#include "tests/trace/proof/hemisphere.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/proof/numbers.h"
#include "tests/trace/proof/reciprocity.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::proof;
using test::diffuseMaterial;
using test::glassMaterial;
using test::mirrorMaterial;
using test::mixtureMaterial;

namespace {

constexpr std::size_t kMaterialSamples = 1000000;
constexpr int kLobeRows = 32, kLobeColumns = 64;
constexpr int kFiner = 2;  // times as many columns in quadrature: towards the horizon lobes are narrow in azimuth

struct SmoothMaterial {
  scene::Material material;
  double glossyProbability;      // probability of the glossy lobe
  double dielectricProbability;  // and of the dielectric
};

const std::vector<SmoothMaterial> kSmooth{{diffuseMaterial({0.8f, 0.5f, 0.2f}), 0, 0},
                                          {mixtureMaterial(0, 0.9f, 0), 1, 0},
                                          {mixtureMaterial(0, 0.9f, 5), 1, 0},
                                          {mixtureMaterial(0, 0.9f, 50), 1, 0},
                                          {mixtureMaterial(0, 0.9f, 100), 1, 0},
                                          {mixtureMaterial(0.5f, 0.3f, 20), 0.375, 0},
                                          {mixtureMaterial(0.3f, 0.4f, 5, 0.3f, 1.5f), 0.4, 0.3}};

// Steep, middling and grazing, on no axis.
const std::vector<dvec3> kViews{directionAt(0.98, 0.05), directionAt(0.6, 0.32), directionAt(0.15, 0.81)};

std::vector<scene::Material> smoothMaterials() {
  std::vector<scene::Material> materials;
  for (const SmoothMaterial& smooth : kSmooth) materials.push_back(smooth.material);
  return materials;
}

template <class Body>
void forEachView(const Body& body) {
  for (std::uint32_t material = 0; material < kSmooth.size(); ++material) {
    for (const dvec3& wo : kViews) {
      INFO("material " << material << " seen at cosine " << wo.z);
      body(material, wo);
    }
  }
}

std::vector<Scattered> sampled(const MaterialLeaves& leaves, std::uint32_t material, const dvec3& wo,
                               std::span<const glm::vec3> numbers, bool outside = true) {
  std::vector<ScatterQuery> queries;
  for (const glm::vec3& u : numbers) queries.push_back({material, wo, u, outside});
  return leaves.sample(queries);
}

std::vector<ScatterValue> valuesOn(const MaterialLeaves& leaves, const HemisphereGrid& grid, std::uint32_t material,
                                   const dvec3& wo) {
  std::vector<DirectionPair> pairs;
  for (const QuadraturePoint& point : grid.points()) pairs.push_back({material, wo, point.direction});
  return leaves.evaluate(pairs);
}

bool isSmooth(render::Lobe lobe) { return lobe == render::Lobe::diffuse || lobe == render::Lobe::glossy; }

// Returns the probability that a half vector of Blinn's lobe reflects `wo` below the surface: with t = cosH^(n + 2)
// uniform.
double shareBelow(double exponent, const dvec3& wo) {
  constexpr std::size_t kPoints = 200000;
  int below = 0;
  for (const glm::vec3& u : latticeNumbers(kPoints)) {
    const dvec3 h = directionAt(std::pow(1 - double{u.y}, 1 / (exponent + 2)), u.z);
    below += 2 * dot(wo, h) * h.z - wo.z <= 0;
  }
  return below / double{kPoints};
}

// Schlick's reflectance, by angles.
double reflectance(double cosOutside, double ior) {
  const double atNormal = std::pow((1 - ior) / (1 + ior), 2);
  return atNormal + (1 - atNormal) * std::pow(1 - cosOutside, 5);
}

}  // namespace

TEST_CASE("directions of every lobe and mixture are sampled with the stated density", "[swiftshader-slow]") {
  const MaterialLeaves leaves(smoothMaterials());
  const HemisphereGrid grid(kLobeRows, kFiner * kLobeColumns);
  const std::vector<glm::vec3> numbers = randomNumbers(kMaterialSamples, 201);
  forEachView([&](std::uint32_t material, const dvec3& wo) {
    const std::vector<ScatterValue> values = valuesOn(leaves, grid, material, wo);
    Cells expected(kLobeRows, kLobeColumns), observed(kLobeRows, kLobeColumns);
    double above = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double share = values[i].pdf * grid.points()[i].solidAngle;
      expected.add(grid.points()[i].place, kMaterialSamples * share);
      above += share;
    }
    expected.addOutside(std::max(0.0, kMaterialSamples * (1 - above)));
    for (const Scattered& sample : sampled(leaves, material, wo, numbers)) {
      if (isSmooth(sample.lobe))
        observed.add({sample.wi.z, turns(sample.wi.x, sample.wi.y)});
      else
        observed.addOutside();
    }
    checkCounts(observed.counts(), expected.counts());
  });
}

TEST_CASE("densities integrate to 1, including directions below the surface and the dielectric lobe") {
  const MaterialLeaves leaves(smoothMaterials());
  const HemisphereGrid grid(kLobeRows, kFiner * kLobeColumns);
  forEachView([&](std::uint32_t material, const dvec3& wo) {
    const std::vector<ScatterValue> values = valuesOn(leaves, grid, material, wo);
    double above = 0;
    for (std::size_t i = 0; i < values.size(); ++i) above += values[i].pdf * grid.points()[i].solidAngle;
    const SmoothMaterial& smooth = kSmooth[material];
    const double below = smooth.glossyProbability > 0 ? shareBelow(smooth.material.glossy->exponent, wo) : 0;
    CHECK(above + smooth.glossyProbability * below + smooth.dielectricProbability == Approx(1).margin(5e-4));
  });
}

TEST_CASE("the mean weight of samples is the albedo computed by quadrature", "[swiftshader-slow]") {
  const MaterialLeaves leaves(smoothMaterials());
  const HemisphereGrid grid(kLobeRows, kFiner * kLobeColumns);
  const std::vector<glm::vec3> numbers = latticeNumbers(200000);
  forEachView([&](std::uint32_t material, const dvec3& wo) {
    const std::vector<ScatterValue> values = valuesOn(leaves, grid, material, wo);
    dvec3 albedo(0), mean(0);
    for (std::size_t i = 0; i < values.size(); ++i) {
      albedo += values[i].f * (grid.points()[i].direction.z * grid.points()[i].solidAngle);
    }
    for (const Scattered& sample : sampled(leaves, material, wo, numbers)) {
      if (isSmooth(sample.lobe)) mean += sample.weight / static_cast<double>(numbers.size());
    }
    for (int channel = 0; channel < 3; ++channel) {
      CAPTURE(channel, albedo[channel]);
      CHECK(mean[channel] == Approx(albedo[channel]).margin(1e-3));
    }
  });
}

TEST_CASE("samples have the weight and the density of the evaluated BSDF") {
  const MaterialLeaves leaves(smoothMaterials());
  forEachView([&](std::uint32_t material, const dvec3& wo) {
    const std::vector<Scattered> samples = sampled(leaves, material, wo, randomNumbers(2000, 204));
    std::vector<DirectionPair> pairs;
    for (const Scattered& sample : samples) pairs.push_back({material, wo, sample.wi});
    const std::vector<ScatterValue> values = leaves.evaluate(pairs);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      if (!isSmooth(samples[i].lobe)) continue;
      CAPTURE(i, samples[i].wi.z);
      REQUIRE(samples[i].pdf == Approx(values[i].pdf).epsilon(100 * kRounding));
      const dvec3 weight = values[i].f * (samples[i].wi.z / values[i].pdf);
      REQUIRE(length(samples[i].weight - weight) <= 100 * kRounding * length(weight));
    }
  });
}

TEST_CASE("scattering is reciprocal for every lobe and mixture") {
  const MaterialLeaves leaves(smoothMaterials());
  const std::vector<glm::vec3> first = randomNumbers(20000, 205), second = randomNumbers(20000, 206);
  for (std::uint32_t material = 0; material < kSmooth.size(); ++material) {
    const auto [there, back] = pairsBothWays(material, first, second);
    const std::vector<ScatterValue> f = leaves.evaluate(there), reversed = leaves.evaluate(back);
    int compared = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
      CAPTURE(material, there[i].wo.z, there[i].wi.z);
      REQUIRE(length(f[i].f - reversed[i].f) <= 100 * kRounding * length(f[i].f) + 1e-9);
      compared += length(f[i].f) > 1e-4;
    }
    CHECK(compared > 1000);
  }
}

TEST_CASE("nothing is scattered below the horizon or from below it") {
  const MaterialLeaves leaves(smoothMaterials());
  for (std::uint32_t material = 0; material < kSmooth.size(); ++material) {
    const dvec3 up = directionAt(0.4, 0.2), down = directionAt(-0.4, 0.6);
    const std::vector<DirectionPair> pairs{{material, up, down}, {material, down, up}, {material, down, down}};
    for (const ScatterValue& value : leaves.evaluate(pairs)) {
      CHECK(value.f == dvec3(0));
      CHECK(value.pdf == 0);
    }
  }
}

TEST_CASE("no white surface scatters more than it receives, at 16 angles and 16 exponents") {
  constexpr std::uint32_t kSteps = 16;
  std::vector<scene::Material> materials;  // glossy, and half diffuse
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const float exponent = i == 0 ? 0 : std::exp2(static_cast<float>(i) - 2);  // 0, 1/2, 1, ... 2^13
    materials.push_back(mixtureMaterial(0, 0.9999f, exponent));
    materials.push_back(mixtureMaterial(0.5f, 0.5f, exponent));
  }
  const MaterialLeaves leaves(materials);
  const std::vector<glm::vec3> numbers = latticeNumbers(4096);
  for (std::uint32_t material = 0; material < materials.size(); ++material) {
    for (std::uint32_t step = 0; step < kSteps; ++step) {
      const dvec3 wo = directionAt((step + 0.5) / kSteps, 0.1);
      double albedo = 0;
      for (const Scattered& sample : sampled(leaves, material, wo, numbers)) {
        albedo += sample.weight.x / static_cast<double>(numbers.size());
      }
      CAPTURE(materials[material].glossy->exponent, materials[material].glossy->weight, wo.z);
      CHECK(albedo <= 1.001);
      CHECK(albedo > 0.3);  // grooves occlude at most this fraction
    }
  }
}

TEST_CASE("the lobes of a mixture are chosen in proportion to their weights") {
  const scene::Material three = mixtureMaterial(0.2f, 0.3f, 8, 0.1f, 1.0f);    // ior 1 reflects nothing at steep angles
  const scene::Material tooMuch = mixtureMaterial(0.8f, 0.8f, 8, 0.4f, 1.0f);  // scaled to 0.4, 0.4 and 0.2
  const MaterialLeaves leaves({three, tooMuch});
  const std::vector<std::vector<double>> shares{{2.0 / 6, 3.0 / 6, 1.0 / 6}, {0.4, 0.4, 0.2}};
  for (std::uint32_t material = 0; material < 2; ++material) {
    std::vector<double> counts(3), expected;
    for (const double share : shares[material]) expected.push_back(kMaterialSamples * share);
    // Straight down, and with numbers for the direction at which no lobe goes below the surface.
    std::vector<glm::vec3> numbers = randomNumbers(kMaterialSamples, 207);
    for (glm::vec3& u : numbers) u = {u.x, 0.6f, 0.5f};
    for (const Scattered& sample : sampled(leaves, material, {0, 0, 1}, numbers)) {
      REQUIRE(sample.lobe != render::Lobe::none);
      ++counts[sample.lobe == render::Lobe::diffuse ? 0 : sample.lobe == render::Lobe::glossy ? 1 : 2];
    }
    checkCounts(counts, expected);
  }
}

TEST_CASE("glass reflects Schlick's fraction and refracts by Snell's law in both directions") {
  const double ior = 1.5;
  const MaterialLeaves leaves({glassMaterial({0.9f, 0.8f, 0.7f}, 1.5f)});
  const std::vector<glm::vec3> numbers = randomNumbers(kMaterialSamples / 4, 208);
  for (const double sine : {0.0, 0.5, 0.95}) {  // outside
    for (const bool outside : {true, false}) {
      const double cosOutside = std::sqrt(1 - sine * sine), ownSine = outside ? sine : sine / ior;
      const dvec3 wo = directionAt(std::sqrt(1 - ownSine * ownSine), 0.3);
      const double otherSine = outside ? sine / ior : sine;
      const dvec3 refracted = -directionAt(std::sqrt(1 - otherSine * otherSine), 0.3);
      std::vector<double> counts(2);
      for (const Scattered& sample : sampled(leaves, 0, wo, numbers, outside)) {
        const bool reflects = sample.lobe == render::Lobe::reflect;
        REQUIRE((reflects || sample.lobe == render::Lobe::refract));
        REQUIRE(length(sample.wi - (reflects ? dvec3(-wo.x, -wo.y, wo.z) : refracted)) < 10 * kRounding);
        REQUIRE(length(sample.weight - dvec3(glm::vec3(0.9f, 0.8f, 0.7f))) < kRounding);
        REQUIRE(sample.pdf == 0);
        ++counts[reflects ? 0 : 1];
      }
      const double share = reflectance(cosOutside, ior), total = static_cast<double>(numbers.size());
      CAPTURE(sine, outside);
      checkCounts(counts, std::vector<double>{share * total, (1 - share) * total});
    }
  }
}

TEST_CASE("glass reflects everything beyond the critical angle, and a mirror at any angle") {
  const MaterialLeaves leaves({glassMaterial(glm::vec3(1), 1.5f), mirrorMaterial({0.9f, 0.5f, 0.1f})});
  const dvec3 wo = directionAt(std::sqrt(1 - 0.7 * 0.7), 0.7);  // sine 0.7 > 1 / 1.5
  const dvec3 reflected(-wo.x, -wo.y, wo.z);
  const std::vector<glm::vec3> numbers = randomNumbers(10000, 209);
  for (const Scattered& sample : sampled(leaves, 0, wo, numbers, false)) {
    REQUIRE(sample.lobe == render::Lobe::reflect);
    REQUIRE(length(sample.wi - reflected) < kRounding);
  }
  for (const Scattered& sample : sampled(leaves, 1, wo, numbers)) {
    REQUIRE(sample.lobe == render::Lobe::mirror);
    REQUIRE(length(sample.wi - reflected) < kRounding);
    REQUIRE(sample.weight == dvec3(glm::vec3(0.9f, 0.5f, 0.1f)));
  }
}
