// Lobes: weights, densities compared with sampling, reciprocity, energy, and the dielectric by values computed by hand.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <vector>

#include "host/trace/reference/bsdf.h"
#include "host/trace/reference/sampling.h"
#include "tests/trace/reference/scene_builder.h"

using namespace candela;
using namespace candela::reference;
using test::mixtureMaterial;

namespace {

dvec3 direction(double cosTheta, double phi) {
  const double sinTheta = std::sqrt(1 - cosTheta * cosTheta);
  return {sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta};
}

dvec3 randomDirection(std::mt19937& random) {
  std::uniform_real_distribution<double> u(0, 1);
  return direction(1 - u(random), 2 * kPi * u(random));
}

// Integral over the hemisphere by the midpoint rule in (cos, phi).
template <class Function>
double integrate(const Function& g, int steps) {
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    for (int j = 0; j < 2 * steps; ++j) sum += g(direction((i + 0.5) / steps, (j + 0.5) * kPi / steps));
  }
  return sum * kPi / steps / steps;
}

// All have a glossy lobe.
const std::vector<scene::Material> kSmoothMaterials{mixtureMaterial(0.5f, 0.5f, 10), mixtureMaterial(0, 0.9f, 0),
                                                    mixtureMaterial(0, 0.9f, 50),
                                                    mixtureMaterial(0.3f, 0.4f, 5, 0.3f, 1.5f)};

}  // namespace

TEST_CASE("a surface scatters by the lobes that its material has") {
  CHECK(Bsdf(test::diffuseMaterial(glm::vec3(1))).chooseLobe(0.999) == render::Lobe::diffuse);
  CHECK(Bsdf(test::mirrorMaterial(glm::vec3(1))).isMirror());
  CHECK(Bsdf(test::glassMaterial(glm::vec3(1), 1.5f)).chooseLobe(0) == render::Lobe::refract);
  CHECK_FALSE(Bsdf(test::glassMaterial(glm::vec3(1), 1.5f)).isBlack());
  CHECK(Bsdf(scene::Material{}).isBlack());
  CHECK_FALSE(Bsdf(scene::Material{}).hasSmoothLobe());
}

TEST_CASE("lobes with a density scatter to the side of reflection, and only there have a value") {
  for (const scene::Material& material : kSmoothMaterials) {
    const Bsdf bsdf(material);
    CHECK(bsdf.scattersTo(Side::reflection));
    CHECK_FALSE(bsdf.scattersTo(Side::transmission));
    for (const double cosTheta : {0.9, 0.1, -0.1, -0.9}) {
      const dvec3 wi = direction(cosTheta, 2);
      const BsdfValue value = bsdf.evaluate({0, 0, 1}, wi);
      CHECK((value.f.x > 0) == bsdf.scattersTo(sideOf(wi)));
      CHECK((value.pdf > 0) == bsdf.scattersTo(sideOf(wi)));
    }
  }
  for (const scene::Material& material :
       {test::mirrorMaterial(glm::vec3(1)), test::glassMaterial(glm::vec3(1), 1.5f)}) {
    CHECK_FALSE(Bsdf(material).hasSmoothLobe());
  }
}

TEST_CASE("a mixture's lobes are chosen by their weights, scaled to at most 1") {
  const Bsdf half(mixtureMaterial(0.25f, 0.25f, 1));
  CHECK(half.chooseLobe(0.499) == render::Lobe::diffuse);
  CHECK(half.chooseLobe(0.5) == render::Lobe::glossy);
  CHECK(half.chooseLobe(1 - 0x1p-24) == render::Lobe::glossy);
  CHECK(half.evaluate({0, 0, 1}, {0, 0, 1}).f.x == Approx(0.25 / kPi + 0.25 * 3 / (2 * kPi) / 4));

  const Bsdf scaled(mixtureMaterial(0.8f, 0.8f, 1, 0.4f, 1.5f));  // 0.4, 0.4, 0.2
  CHECK(scaled.chooseLobe(0.39) == render::Lobe::diffuse);
  CHECK(scaled.chooseLobe(0.79) == render::Lobe::glossy);
  CHECK(scaled.chooseLobe(0.81) == render::Lobe::refract);
  CHECK(scaled.evaluate({0, 0, 1}, {0, 0, 1}).f.x == Approx(0.4 / kPi + 0.4 * 3 / (2 * kPi) / 4));

  const Bsdf opaque(mixtureMaterial(0.8f, 0.8f, 1, 0.4f, 0));  // T is dropped after the scaling
  CHECK(opaque.evaluate({0, 0, 1}, {0, 0, 1}).f.x == Approx(0.4 / kPi + 0.4 * 3 / (2 * kPi) / 4));
  CHECK(opaque.chooseLobe(0.99) == render::Lobe::glossy);
}

TEST_CASE("the glossy lobe has the value computed by hand") {
  // n = 2, wo = (0.6, 0, 0.8), wi mirrored: h = z, D = 2/pi, wo.h = 0.8, G = min(1, 2 * 0.8 / 0.8) = 1.
  const Bsdf bsdf(mixtureMaterial(0, 0.5f, 2));
  const BsdfValue value = bsdf.evaluate({0.6, 0, 0.8}, {-0.6, 0, 0.8});
  CHECK(value.f.y == Approx(0.5 * (2 / kPi) / (4 * 0.64)));
  CHECK(value.pdf == Approx((2 / kPi) / (4 * 0.8)));
  // Both at 30 degrees over the horizon, opposite in azimuth by 90 degrees: h has z = 0.5 / |h|.
  const double s = std::sqrt(0.75);
  const dvec3 h = normalize(dvec3(s, s, 1));
  const double g = 2 * h.z * 0.5 / (dot(dvec3(s, 0, 0.5), h));
  REQUIRE(g < 1);
  CHECK(bsdf.evaluate({s, 0, 0.5}, {0, s, 0.5}).f.z == Approx(0.5 * (2 / kPi) * h.z * h.z * g));
}

TEST_CASE("scattering of the reference is reciprocal") {
  std::mt19937 random(1);
  for (const scene::Material& material : kSmoothMaterials) {
    const Bsdf bsdf(material);
    for (int i = 0; i < 100; ++i) {
      const dvec3 a = randomDirection(random), b = randomDirection(random);
      CHECK(bsdf.evaluate(a, b).f.x == Approx(bsdf.evaluate(b, a).f.x).epsilon(1e-9));
    }
  }
}

TEST_CASE("no surface scatters more than it receives") {
  for (const double cosTheta : {1.0, 0.7, 0.3, 0.05}) {
    for (const float shine : {0.0f, 1.0f, 10.0f, 100.0f}) {
      const Bsdf bsdf(mixtureMaterial(0.25f, 0.75f, shine));
      const dvec3 wo = direction(cosTheta, 0.4);
      const double albedo = integrate([&](const dvec3& wi) { return bsdf.evaluate(wo, wi).f.x * wi.z; }, 200);
      INFO("cos " << cosTheta << ", shine " << shine);
      CHECK(albedo <= 1.001);
      CHECK(albedo > 0.25);
    }
  }
}

TEST_CASE("the densities of all directions, including those that end the path, integrate to 1") {
  for (const scene::Material& material : kSmoothMaterials) {
    const Bsdf bsdf(material);
    for (const double cosTheta : {1.0, 0.6, 0.2}) {
      const dvec3 wo = direction(cosTheta, 1);
      const double above = integrate([&](const dvec3& wi) { return bsdf.evaluate(wo, wi).pdf; }, 400);
      int below = 0, delta = 0;
      constexpr int kSide = 300;
      for (int i = 0; i < kSide * kSide; ++i) {
        const double u = (i % kSide + 0.5) / kSide, v = (i / kSide + 0.5) / kSide;
        // A third number, well spread against both others.
        const render::Lobe lobe = bsdf.chooseLobe(std::fmod(i * 0.61803398874989, 1));
        if (lobe == render::Lobe::refract) ++delta;
        if (lobe != render::Lobe::refract && bsdf.sampleSmooth(lobe, wo, {u, v}).z <= 0) ++below;
      }
      INFO("cos " << cosTheta << ", Ks " << material.glossy->weight << ", shine " << material.glossy->exponent);
      CHECK(above + (below + delta) / double{kSide * kSide} == Approx(1).epsilon(3e-3));
    }
  }
}

TEST_CASE("directions are sampled with the stated density") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const scene::Material& material : kSmoothMaterials) {
    const Bsdf bsdf(material);
    const dvec3 wo = direction(0.6, 0);
    // Chi-square over cells of equal solid angle, whose probability is integrated with 12 x 12 points each.
    constexpr int kRows = 8, kColumns = 8, kPoints = 12, kSamples = 40000;
    std::vector<double> expected(kRows * kColumns), observed(kRows * kColumns);
    for (int row = 0; row < kRows * kPoints; ++row) {
      for (int column = 0; column < kColumns * kPoints; ++column) {
        const double cosTheta = (row + 0.5) / (kRows * kPoints), phi = 2 * kPi * (column + 0.5) / (kColumns * kPoints);
        expected[static_cast<std::size_t>(row / kPoints * kColumns +
                                          column / kPoints)] += kSamples *
                                                                bsdf.evaluate(wo, direction(cosTheta, phi)).pdf * 2 *
                                                                kPi / (kRows * kPoints * kColumns * kPoints);
      }
    }
    for (int i = 0; i < kSamples; ++i) {
      const render::Lobe lobe = bsdf.chooseLobe(uniform(random));
      const dvec2 u(uniform(random), uniform(random));
      if (lobe == render::Lobe::refract) continue;
      const dvec3 wi = bsdf.sampleSmooth(lobe, wo, u);
      if (wi.z <= 0) continue;
      const double phi = std::atan2(wi.y, wi.x) / (2 * kPi);
      const int row = std::min(kRows - 1, static_cast<int>(wi.z * kRows));
      const int column = std::min(kColumns - 1, static_cast<int>((phi < 0 ? phi + 1 : phi) * kColumns));
      ++observed[static_cast<std::size_t>(row * kColumns + column)];
    }
    double chiSquare = 0;
    int cells = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (expected[i] < 10) continue;
      chiSquare += (observed[i] - expected[i]) * (observed[i] - expected[i]) / expected[i];
      ++cells;
    }
    INFO("Ks " << material.glossy->weight << ", shine " << material.glossy->exponent << ": " << chiSquare << " over "
               << cells << " cells");
    CHECK(cells > 8);
    CHECK(chiSquare < cells + 4.5 * std::sqrt(2.0 * cells));  // beyond the quantile 1 - 1e-4
  }
}

TEST_CASE("a mirror reflects about the normal and has the diffuse colour") {
  const DeltaSample sample = Bsdf(test::mirrorMaterial({0.9f, 0.5f, 0.1f})).sampleMirror({0.6, 0, 0.8});
  CHECK(sample.wi == dvec3(-0.6, 0, 0.8));
  CHECK(sample.weight == dvec3(glm::vec3(0.9f, 0.5f, 0.1f)));
}

TEST_CASE("a dielectric refracts by Snell's law and reflects Schlick's fraction") {
  const Bsdf glass(test::glassMaterial(glm::vec3(1), 1.5f));
  // From outside at 30 degrees: R = 0.04 + 0.96 (1 - cos 30)^5.
  const double cos1 = std::sqrt(0.75);
  const double reflectance = 0.04 + 0.96 * std::pow(1 - cos1, 5);
  const DeltaSample in = glass.sampleDielectric({0.5, 0, cos1}, true, reflectance + 1e-9);
  CHECK(in.lobe == render::Lobe::refract);
  CHECK(in.wi.x == Approx(-1.0 / 3));  // sin2 = 0.5 / 1.5
  CHECK(in.wi.z == Approx(-std::sqrt(1 - 1.0 / 9)));
  CHECK(in.weight == dvec3(1));
  CHECK(glass.sampleDielectric({0.5, 0, cos1}, true, reflectance - 1e-9).lobe == render::Lobe::reflect);

  // Backwards along the refracted ray: the same reflectance, since the cosine outside counts.
  const dvec3 inside(1.0 / 3, 0, std::sqrt(1 - 1.0 / 9));
  CHECK(glass.sampleDielectric(inside, false, reflectance - 1e-9).lobe == render::Lobe::reflect);
  const DeltaSample out = glass.sampleDielectric(inside, false, reflectance + 1e-9);
  CHECK(out.lobe == render::Lobe::refract);
  CHECK(out.wi.x == Approx(-0.5));
}

TEST_CASE("a dielectric reflects everything beyond the critical angle") {
  const Bsdf glass(test::glassMaterial(glm::vec3(1), 1.5f));
  const auto lobeAt = [&](double sine) {
    return glass.sampleDielectric({sine, 0, std::sqrt(1 - sine * sine)}, false, 1 - 0x1p-24).lobe;
  };
  CHECK(lobeAt(1 / 1.5 - 1e-6) == render::Lobe::refract);
  CHECK(lobeAt(1 / 1.5 + 1e-6) == render::Lobe::reflect);
}

TEST_CASE("a dielectric lobe of a mixture carries the weight of all lobes") {
  const Bsdf bsdf(mixtureMaterial(0.2f, 0.1f, 3, 0.5f, 1.5f));
  CHECK(bsdf.sampleDielectric({0, 0, 1}, true, 0.5).weight.x == Approx(0.8));  // t / p_t = S
}
