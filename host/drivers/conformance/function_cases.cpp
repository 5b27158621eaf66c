// Candela's own leaf functions: elementary functions and warps to a stated error, the film's sums bit for bit.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/mismatches.h"
#include "host/drivers/conformance/shader_run.h"
#include "host/drivers/conformance/workbench.h"
#include "host/image/film.h"
#include "host/trace/reference/sampling.h"
#include "spirv/film_sums.h"
#include "spirv/functions.h"

namespace candela::conformance {
namespace {

using Row = std::array<float, 4>;

constexpr std::uint32_t kFunctionArguments = 4096;
constexpr std::size_t kPixelWords = sizeof(image::FilmPixel) / sizeof(std::uint32_t);

/// A function of (u, v, w, height of a cap). Errors are those of 32-bit arithmetic with division and square root as
/// Vulkan permits them.
struct FunctionRow {
  const char* name;
  std::uint32_t function;  ///< kFunction of the shader
  double relativeError;
  double absoluteError;
  glm::dvec4 (*expected)(const glm::dvec4& u);
};

glm::dvec4 discAndTriangle(const glm::dvec4& u) {
  return {reference::sampleDisc({u.x, u.y}), reference::sampleTriangle({u.x, u.y})};
}
glm::dvec4 cap(const glm::dvec4& u) { return {reference::sampleCap({u.x, u.y}, u.w), 0}; }
glm::dvec4 hemisphereAndTent(const glm::dvec4& u) {
  return {reference::sampleCosineHemisphere({u.x, u.y}), reference::sampleTent(u.z)};
}
glm::dvec4 logarithms(const glm::dvec4& u) {
  return {std::log1p(-u.x), std::log(static_cast<double>(static_cast<float>(u.y) + 0.001f)), 0, 0};
}
glm::dvec4 exponentials(const glm::dvec4& u) { return {std::expm1(-50 * u.y), std::exp(40 * u.x - 20), 0, 0}; }
glm::dvec4 turns(const glm::dvec4& u) { return {std::atan2(u.y - 0.5, u.x - 0.5) / (2 * std::numbers::pi), 0, 0, 0}; }

constexpr std::array<FunctionRow, 6> kFunctionRows{{{"disc_and_triangle", 0, 0, 1e-6, discAndTriangle},
                                                    {"cap", 1, 0, 1e-6, cap},
                                                    {"hemisphere_and_tent", 2, 0, 1e-6, hemisphereAndTent},
                                                    {"logarithm", 3, 1e-6, 2e-7, logarithms},
                                                    {"exponential", 4, 4e-6, 0, exponentials},
                                                    {"arc_tangent", 5, 0, 5e-7, turns}}};

// Every other cap is narrow.
std::vector<Row> functionArguments() {
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<float>(random() >> 8) * 0x1p-24f; };
  std::vector<Row> inputs;
  for (std::uint32_t i = 0; i < kFunctionArguments; ++i) {
    const float height = i % 2 == 0 ? 2 * uniform() : 1e-6f * uniform() + 1e-9f;
    inputs.push_back({uniform(), uniform(), uniform(), height});
  }
  return inputs;
}

void compareRow(const FunctionRow& row, std::size_t invocation, const Row& u, const Row& found,
                Mismatches& mismatches) {
  const glm::dvec4 expected = row.expected({u[0], u[1], u[2], u[3]});
  for (int k = 0; k < 4; ++k) {
    const double error = row.relativeError * std::abs(expected[k]) + row.absoluteError;
    mismatches.require(outputPosition(invocation, static_cast<std::size_t>(k)), expected[k] - error,
                       expected[k] + error);
    const bool isNear = std::abs(double{found[k]} - expected[k]) <= error;
    mismatches.note(
        isNear
            ? ""
            : fmt::format("{}({:.9g}, {:.9g}, {:.9g}, {:.9g}), value {}: expected {:.9g} within {:.2g}, found {:.9g}",
                          row.name, u[0], u[1], u[2], u[3], k, expected[k], error, found[k]));
  }
}

ShaderRun shaderOf(const FunctionRow& row) { return {spirv::functions, kFunctionArguments, 0, {{0, row.function}}}; }

Finding runFunction(const FunctionRow& row, Workbench& workbench) {
  const std::vector<Row> inputs = functionArguments();
  const std::vector<Row> found = runShader<Row>(workbench.device(), shaderOf(row), inputs, inputs.size());
  Mismatches mismatches;
  for (std::size_t i = 0; i < inputs.size(); ++i) compareRow(row, i, inputs[i], found[i], mismatches);
  return perInvocation(mismatches.finding());
}

// Samples of all magnitudes, among them some that the film refuses or clamps, and a denormal number, which adds 0.
std::vector<Row> filmSamples(std::size_t count) {
  constexpr std::array<float, 5> kSpecial{std::numeric_limits<float>::quiet_NaN(),
                                          std::numeric_limits<float>::infinity(), -1.0f, 3e6f, 1e-45f};
  std::mt19937 random(11);
  const auto value = [&] {
    const std::size_t kind = random() % 40;
    if (kind < kSpecial.size()) return kSpecial[kind];
    return std::ldexp(static_cast<float>(random() >> 8), static_cast<int>(random() % 60) - 63);
  };
  std::vector<Row> samples(count);
  for (Row& sample : samples) sample = {value(), value(), value(), 0};
  return samples;
}

// 2^24 - 2^-9 fills the middle one of three words, in units of 2^-40; 2^-9 more go into the last.
std::vector<Row> carryingSamples() {
  std::vector<Row> samples(15, Row{0x1p20f, 0x1p20f, 0x1p20f, 0});
  for (const float value : {0x1p20f - 0x1p-4f, 0x1p-4f - 0x1p-9f, 0x1p-9f}) samples.push_back({value, value, value, 0});
  return samples;
}

void comparePixel(std::size_t pixel, const image::FilmPixel& host, const image::FilmPixel& found,
                  Mismatches& mismatches) {
  const auto positionOf = [&](const std::uint32_t& member) {
    const std::ptrdiff_t word = &member - reinterpret_cast<const std::uint32_t*>(&found);
    return capture::WordPosition{kOutputs,
                                 static_cast<std::uint32_t>(pixel * kPixelWords + static_cast<std::size_t>(word))};
  };
  const auto compareSum = [&](const char* channel, const image::FixedSum& a, const image::FixedSum& b) {
    for (std::size_t word = 0; word < a.size(); ++word) {
      mismatches.expect(fmt::format("film of invocation {}, {}, word {}", pixel, channel, word), positionOf(b[word]),
                        a[word], b[word]);
    }
  };
  compareSum("red", host.red, found.red);
  compareSum("green", host.green, found.green);
  compareSum("blue", host.blue, found.blue);
  mismatches.expect(fmt::format("film of invocation {}, samples", pixel), positionOf(found.sampleCount),
                    host.sampleCount, found.sampleCount);
  mismatches.expect(fmt::format("film of invocation {}, bad samples", pixel), positionOf(found.badCount), host.badCount,
                    found.badCount);
  mismatches.expect(fmt::format("film of invocation {}, first bad sample", pixel), positionOf(found.firstBadSample),
                    host.firstBadSample, found.firstBadSample);
}

Finding runFilm(const std::vector<Row>& samples, std::uint32_t invocations, Workbench& workbench) {
  const auto perInvocation = static_cast<std::uint32_t>(samples.size()) / invocations;
  const auto films = runShader<image::FilmPixel>(workbench.device(), {spirv::film_sums, invocations, perInvocation},
                                                 samples, invocations);
  image::Film expected(invocations, 1);
  for (std::uint32_t i = 0; i < samples.size(); ++i) {
    const Row& sample = samples[i];
    expected.addSample(i / perInvocation, 0, {sample[0], sample[1], sample[2]}, i % perInvocation);
  }
  Mismatches mismatches;
  for (std::uint32_t i = 0; i < invocations; ++i) comparePixel(i, expected.at(i, 0), films[i], mismatches);
  return conformance::perInvocation(mismatches.finding());
}

}  // namespace

Cases functionCases() {
  constexpr const char* kGroup = "leaf.function";
  Cases cases;
  for (const FunctionRow& row : kFunctionRows) {
    cases.push_back(caseOf(fmt::format("leaf.function.{}", row.name), kGroup, pipelineOf(shaderOf(row)),
                           [row](Workbench& workbench) { return runFunction(row, workbench); }));
  }
  const CasePipeline film = pipelineOf({.spirv = spirv::film_sums});
  cases.push_back(caseOf("leaf.film.sums", kGroup, film,
                         [](Workbench& bench) { return runFilm(filmSamples(20'000), 500, bench); }));
  cases.push_back(
      caseOf("leaf.film.carry", kGroup, film, [](Workbench& bench) { return runFilm(carryingSamples(), 1, bench); }));
  return cases;
}

}  // namespace candela::conformance
