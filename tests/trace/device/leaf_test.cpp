// The shader's leaf functions on a device, compared with the reference's and with the C library.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <glm/glm.hpp>
#include <limits>
#include <random>

#include "host/image/film.h"
#include "host/trace/reference/sampler.h"
#include "host/trace/reference/sampling.h"
#include "shaders/shared/specialization.h"
#include "spirv/film_leaf.h"
#include "spirv/sampler_leaf.h"
#include "spirv/warp_leaf.h"
#include "tests/trace/device/run_leaf.h"

using namespace candela;
using namespace candela::device;

namespace {

std::vector<glm::vec4> randomInputs(std::size_t count) {
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  std::vector<glm::vec4> inputs;
  for (std::size_t i = 0; i < count; ++i) {
    const float height = i % 2 == 0 ? 2 * uniform() + 1e-7f : 1e-6f * uniform() + 1e-9f;
    // Some numbers are near the ends of their range.
    const float first = i % 32 == 0   ? static_cast<float>(i) * 0x1p-24f
                        : i % 32 == 1 ? 1 - static_cast<float>(i) * 0x1p-24f
                                      : uniform();
    inputs.push_back({first, uniform(), uniform(), height});
  }
  return inputs;
}

bool isNear(const glm::dvec3& a, const glm::dvec3& b, double tolerance) { return glm::length(a - b) <= tolerance; }

}  // namespace

TEST_CASE("the samplers agree with the reference bit for bit") {
  const auto [kind, id] = GENERATE(
      table<render::SamplerKind, std::uint32_t>({{render::SamplerKind::independent, gpu::kSamplerIndependent},
                                                 {render::SamplerKind::stratified, gpu::kSamplerStratified},
                                                 {render::SamplerKind::sobol, gpu::kSamplerSobol}}));
  const std::uint32_t samples = GENERATE(1u, 16u, 225u, 1000u);
  constexpr std::uint32_t kSeed = 12345;
  std::mt19937 engine(5);
  const auto random = [&] { return static_cast<std::uint32_t>(engine()); };
  std::vector<glm::uvec4> keys;
  for (int i = 0; i < 4000; ++i) {
    const std::uint32_t pixel = random() % 4096 + 65536 * (random() % 2160);
    keys.push_back({pixel, random() % samples, i % 8 == 0 ? random() % 40000 : random() % 12, kSeed});
  }
  const std::uint32_t side = samples == 225 ? 15 : samples == 1000 ? 31 : samples == 16 ? 4 : 1;
  const auto words = runLeaf<glm::uvec4>(spirv::sampler_leaf, keys, keys.size(),
                                         {static_cast<std::uint32_t>(keys.size()), side}, {{gpu::kSpecSampler, id}});
  const reference::Sampler sampler(kind, kSeed, samples);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const reference::Words expected = sampler.group(keys[i].x, keys[i].y, keys[i].z);
    CAPTURE(i, keys[i].x, keys[i].y, keys[i].z, samples);
    REQUIRE(std::memcmp(expected.data(), &words[i], sizeof expected) == 0);
  }
}

TEST_CASE("warps and elementary functions are accurate to a few units in the last place") {
  const auto inputs = randomInputs(20000);
  const auto rows = runLeaf<glm::vec4>(spirv::warp_leaf, inputs, 4 * inputs.size(),
                                       {static_cast<std::uint32_t>(inputs.size()), 0});
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const glm::dvec4 u(inputs[i]);
    const glm::dvec2 disc = reference::sampleDisc({u.x, u.y});
    const glm::dvec3 direction = reference::sampleCap({u.x, u.y}, u.w);
    CAPTURE(i, u.x, u.y, u.z, u.w);
    REQUIRE(isNear({disc, 0}, {rows[4 * i].x, rows[4 * i].y, 0}, 3e-7));
    REQUIRE(isNear(direction, glm::vec3(rows[4 * i + 1]), 4e-7));
    // For a narrow cap, the distance from its axis is compared.
    REQUIRE(std::hypot(rows[4 * i + 1].x - direction.x, rows[4 * i + 1].y - direction.y) <= 1e-6 * std::sqrt(u.w));
    REQUIRE(rows[4 * i + 2].w == Approx(reference::sampleGaussian(u.x)).margin(1.5e-6));
    REQUIRE(rows[4 * i + 2].x == Approx(std::log1p(-u.x)).epsilon(1e-6));
    REQUIRE(rows[4 * i + 2].y == Approx(std::expm1(-50 * u.y)).epsilon(4e-6));
  }
}

TEST_CASE("the sums of the device's film equal the host's") {
  constexpr std::uint32_t kLanes = 500, kPerLane = 40;
  std::mt19937 random(11);
  std::vector<glm::vec4> samples;
  for (std::uint32_t i = 0; i < kLanes * kPerLane; ++i) {
    const auto value = [&] {
      switch (random() % 40) {
        case 0:
          return std::numeric_limits<float>::quiet_NaN();
        case 1:
          return std::numeric_limits<float>::infinity();
        case 2:
          return -1.0f;
        case 3:
          return 3e6f;
        case 4:
          return 1e-45f;  // denormal: adds 0
        default:
          return std::ldexp(static_cast<float>(random() >> 8), static_cast<int>(random() % 60) - 63);
      }
    };
    samples.push_back({value(), value(), value(), 0});
  }
  const auto films = runLeaf<image::FilmPixel>(spirv::film_leaf, samples, kLanes, {kLanes, kPerLane});
  image::Film expected(kLanes, 1);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    expected.addSample(i / kPerLane, 0, glm::dvec3(samples[i]), i % kPerLane);
  }
  for (std::uint32_t lane = 0; lane < kLanes; ++lane) {
    const image::FilmPixel& host = expected.at(lane, 0);
    CAPTURE(lane);
    REQUIRE(films[lane].red == host.red);
    REQUIRE(films[lane].green == host.green);
    REQUIRE(films[lane].blue == host.blue);
    REQUIRE(films[lane].sampleCount == kPerLane);
    REQUIRE(films[lane].badCount == host.badCount);
    REQUIRE(films[lane].firstBadSample == host.firstBadSample);
    const auto high = [](const image::FixedSum& sum) {
      return std::ldexp(sum[2], 64) + std::ldexp(sum[1], 32) + sum[0];
    };
    REQUIRE(high(films[lane].luminanceSquared) == Approx(high(host.luminanceSquared)).epsilon(1e-6).margin(kPerLane));
  }
}

TEST_CASE("a carry in the device's film propagates through a full word") {
  // 2^24 - 2^-9 fills the middle one of three words, in units of 2^-40; 2^-9 more go into the last.
  std::vector<glm::vec4> samples(15, glm::vec4(0x1p20f));
  for (const float value : {0x1p20f - 0x1p-4f, 0x1p-4f - 0x1p-9f, 0x1p-9f}) samples.emplace_back(value);
  const auto perLane = static_cast<std::uint32_t>(samples.size());
  const auto films = runLeaf<image::FilmPixel>(spirv::film_leaf, samples, 1, {1, perLane});
  CHECK(films.at(0).red == image::FixedSum{0, 0, 1});
  CHECK(films.at(0).blue == image::FixedSum{0, 0, 1});
}
