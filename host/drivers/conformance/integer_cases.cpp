// Integer functions and samplers, with the results that the host computes independently.
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <limits>
#include <random>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/mismatches.h"
#include "host/drivers/conformance/shader_run.h"
#include "host/drivers/conformance/workbench.h"
#include "host/trace/reference/sampler.h"
#include "shaders/shared/specialization.h"
#include "spirv/integers.h"
#include "spirv/samplers.h"

namespace candela::conformance {
namespace {

constexpr std::uint32_t kArguments = 4096;
constexpr std::uint32_t kSeed = 12345;

using Function = Words (*)(const Words&);

std::uint32_t high(std::uint64_t value) { return static_cast<std::uint32_t>(value >> 32); }
std::uint32_t low(std::uint64_t value) { return static_cast<std::uint32_t>(value); }

Words added(const Words& v) {
  const std::uint64_t sum = std::uint64_t{v[0]} + v[1];
  return {low(sum), high(sum), v[0] - v[1], v[0] < v[1] ? 1u : 0u};
}

Words multiplied(const Words& v) {
  const std::uint64_t product = std::uint64_t{v[0]} * v[1];
  const auto signedProduct = static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(v[0])} *
                                                        static_cast<std::int32_t>(v[1]));
  return {low(product), high(product), low(signedProduct), high(signedProduct)};
}

Words divided(const Words& v) {
  const std::uint32_t odd = v[1] | 1u;
  return {v[0] / v[1], v[0] - v[0] / v[1] * v[1], v[2] / odd, v[2] - v[2] / odd * odd};
}

std::uint32_t reversed(std::uint32_t value) {
  std::uint32_t result = 0;
  for (int bit = 0; bit < 32; ++bit) result |= ((value >> bit) & 1u) << (31 - bit);
  return result;
}

Words counted(const Words& v) {
  const std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  return {reversed(v[0]), static_cast<std::uint32_t>(std::popcount(v[0])),
          v[0] == 0 ? none : 31u - static_cast<std::uint32_t>(std::countl_zero(v[0])),
          v[0] == 0 ? none : static_cast<std::uint32_t>(std::countr_zero(v[0]))};
}

Words bitfield(const Words& v) {
  const std::uint32_t offset = v[2] % 32;
  const std::uint32_t bits = v[3] % (33 - offset);
  const std::uint64_t mask = ((std::uint64_t{1} << bits) - 1) << offset;
  const std::uint32_t field = low((v[0] & mask) >> offset);
  const bool negative = bits > 0 && (field >> (bits - 1)) % 2 == 1;
  const std::uint32_t extended = negative ? low(field | ~((std::uint64_t{1} << bits) - 1)) : field;
  return {field, extended, low((v[0] & ~mask) | ((std::uint64_t{v[1]} << offset) & mask)), bits};
}

Words shifted(const Words& v) {
  const std::uint32_t n = v[1] % 32;
  const std::uint64_t wide = static_cast<std::uint64_t>(std::int64_t{static_cast<std::int32_t>(v[0])});
  // GLSL's expression for a rotation shifts by 0 to the right if n is 0.
  const std::uint32_t rotated = n == 0 ? v[0] : std::rotl(v[0], static_cast<int>(n));
  return {low(std::uint64_t{v[0]} << n), v[0] >> n, low(wide >> n), rotated};
}

Words ordered(const Words& v) {
  const auto a = static_cast<std::int32_t>(v[0]);
  const auto b = static_cast<std::int32_t>(v[1]);
  const std::int32_t top = b < -1000 ? -1000 : b;
  const std::int32_t clamped = a < -1000 ? -1000 : a > top ? top : a;
  return {v[0] < v[1] ? v[0] : v[1], v[0] < v[1] ? v[1] : v[0], static_cast<std::uint32_t>(a < b ? a : b),
          static_cast<std::uint32_t>(clamped)};
}

struct IntegerRow {
  const char* name;
  std::uint32_t function;  ///< kFunction of the shader
  Function expected;
};

constexpr std::array<IntegerRow, 7> kIntegerRows{{{"add_carry", 0, added},
                                                  {"multiply_extended", 1, multiplied},
                                                  {"divide", 2, divided},
                                                  {"count_bits", 3, counted},
                                                  {"bitfield", 4, bitfield},
                                                  {"shift", 5, shifted},
                                                  {"min_max", 6, ordered}}};

// Random words, among them values near 0 and the extremes. The second one is not 0.
std::vector<Words> integerArguments() {
  std::mt19937 random(7);
  constexpr std::array<std::uint32_t, 6> kExtremes{0, 1, 0x7fffffffu, 0x80000000u, 0xfffffffeu, 0xffffffffu};
  const auto word = [&]() -> std::uint32_t {
    const auto any = static_cast<std::uint32_t>(random());
    if (any % 4 == 0) return kExtremes[random() % kExtremes.size()];
    return static_cast<std::uint32_t>(random()) >> (any / 4 % 32);
  };
  std::vector<Words> arguments(kArguments);
  for (Words& v : arguments) v = {word(), std::max(word(), 1u), word(), word()};
  return arguments;
}

std::string textOf(const Words& v) { return fmt::format("({:#x}, {:#x}, {:#x}, {:#x})", v[0], v[1], v[2], v[3]); }

Finding compareWords(const std::string& name, const std::vector<Words>& arguments, const std::vector<Words>& expected,
                     const std::vector<Words>& found) {
  Mismatches mismatches;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    for (std::size_t k = 0; k < expected[i].size(); ++k) mismatches.require(outputPosition(i, k), expected[i][k]);
    mismatches.note(found[i] == expected[i] ? ""
                                            : fmt::format("{}{}: expected {}, found {}", name, textOf(arguments[i]),
                                                          textOf(expected[i]), textOf(found[i])));
  }
  return perInvocation(mismatches.finding());
}

ShaderRun shaderOf(const IntegerRow& row) { return {spirv::integers, kArguments, 0, {{0, row.function}}}; }

Finding runInteger(const IntegerRow& row, Workbench& workbench) {
  const std::vector<Words> arguments = integerArguments();
  const std::vector<Words> found = runShader<Words>(workbench.device(), shaderOf(row), arguments, arguments.size());
  std::vector<Words> expected;
  for (const Words& v : arguments) expected.push_back(row.expected(v));
  return compareWords(row.name, arguments, expected, found);
}

struct SamplerRow {
  const char* name;
  render::SamplerKind kind;
  std::uint32_t id;       ///< kSampler...
  std::uint32_t samples;  ///< per pixel
  std::uint32_t strata;   ///< per side
};

constexpr std::array<SamplerRow, 4> kSamplerRows{
    {{"independent", render::SamplerKind::independent, gpu::kSamplerIndependent, 16, 4},
     {"stratified", render::SamplerKind::stratified, gpu::kSamplerStratified, 225, 15},
     {"stratified_uneven", render::SamplerKind::stratified, gpu::kSamplerStratified, 1000, 31},
     {"sobol", render::SamplerKind::sobol, gpu::kSamplerSobol, 1000, 31}}};

// Arguments are (pixel, sample, group, seed).
std::vector<Words> samplerArguments(std::uint32_t samples) {
  std::mt19937 random(5);
  std::vector<Words> keys(kArguments);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const auto pixel = static_cast<std::uint32_t>(random() % 4096 + 65536 * (random() % 2160));
    const auto group = static_cast<std::uint32_t>(i % 8 == 0 ? random() % 40000 : random() % 12);
    keys[i] = {pixel, static_cast<std::uint32_t>(random()) % samples, group, kSeed};
  }
  return keys;
}

ShaderRun shaderOf(const SamplerRow& row) {
  return {spirv::samplers, kArguments, row.strata, {{gpu::kSpecSampler, row.id}}};
}

Finding runSampler(const SamplerRow& row, Workbench& workbench) {
  const std::vector<Words> keys = samplerArguments(row.samples);
  const std::vector<Words> found = runShader<Words>(workbench.device(), shaderOf(row), keys, keys.size());
  const reference::Sampler sampler(row.kind, kSeed, row.samples);
  std::vector<Words> expected;
  for (const Words& key : keys) expected.push_back(sampler.group(key[0], key[1], key[2]));
  return compareWords(fmt::format("{} sampler: words of (pixel, sample, group, seed) ", row.name), keys, expected,
                      found);
}

}  // namespace

Cases integerCases() {
  Cases cases;
  for (const IntegerRow& row : kIntegerRows) {
    cases.push_back(caseOf(fmt::format("leaf.integer.{}", row.name), "leaf.integer", pipelineOf(shaderOf(row)),
                           [row](Workbench& workbench) { return runInteger(row, workbench); }));
  }
  for (const SamplerRow& row : kSamplerRows) {
    cases.push_back(caseOf(fmt::format("leaf.sampler.{}", row.name), "leaf.integer", pipelineOf(shaderOf(row)),
                           [row](Workbench& workbench) { return runSampler(row, workbench); }));
  }
  return cases;
}

}  // namespace candela::conformance
