// The table of functions on 32-bit floats, with the results that Vulkan permits.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <numbers>
#include <random>

#include "host/drivers/conformance/case_tables.h"
#include "host/drivers/conformance/error_bounds.h"
#include "host/drivers/conformance/mismatches.h"
#include "host/drivers/conformance/shader_run.h"
#include "host/drivers/conformance/workbench.h"
#include "spirv/floats.h"

namespace candela::conformance {
namespace {

constexpr std::uint32_t kFloatArguments = 4096;
constexpr double kTrigonometricError = 0x1p-11;
constexpr double kArcTangentUlps = 4096;
constexpr double kPi = std::numbers::pi;
constexpr double kPiRange = 3.1415925;  // the largest float below pi

/// Arguments are from `low` to `high` in magnitude, uniform in their exponent if `low` > 0, else uniform.
struct Range {
  double low = 0;
  double high = 0;
  bool hasSign = false;
};

/// A function with the interval of its permitted results.
struct FloatRow {
  const char* name;
  std::uint32_t function;  ///< kFunction of the shader
  Range x;
  Range y;
  Interval (*permitted)(double x, double y);
};

float bitsOf(std::uint32_t word) { return std::bit_cast<float>(word); }

Interval comparisons(double x, double y) {
  const std::uint32_t word = (x < y ? 1u : 0u) | (x <= y ? 2u : 0u) | (x == y ? 4u : 0u) | (x != y ? 8u : 0u) |
                             (x >= y ? 16u : 0u) | (x > y ? 32u : 0u);
  const double exact = bitsOf(word | 0x3f800000u);
  return {exact, exact};
}

Interval exactly(double value) { return {value, value}; }

double nearestEven(double x) { return x - std::remainder(x, 1.0); }

constexpr Range kAnyMagnitude{0x1p-30, 0x1p30, true};
constexpr Range kPositive{0x1p-30, 0x1p30};
constexpr Range kNearOne{0x1p-12, 0x1p12, true};
constexpr Range kSmallNumbers{0x1p-4, 0x1p20, true};
constexpr Range kAngle{0, kPiRange, true};
constexpr Range kExponent{0, 80, true};

const std::array<FloatRow, 24> kFloatRows{
    {{"add", 0, kNearOne, kNearOne, [](double x, double y) { return correctlyRounded(x + y); }},
     {"subtract", 1, kNearOne, kNearOne, [](double x, double y) { return correctlyRounded(x - y); }},
     {"multiply", 2, kAnyMagnitude, kAnyMagnitude, [](double x, double y) { return correctlyRounded(x * y); }},
     {"divide", 3, kAnyMagnitude, kAnyMagnitude, [](double x, double y) { return withinUlps(x / y, 2.5); }},
     {"sqrt", 4, kPositive, {}, [](double x, double) { return boundOfSqrt(x); }},
     {"inversesqrt", 5, kPositive, {}, [](double x, double) { return withinUlps(1 / std::sqrt(x), 2); }},
     {"sin", 6, kAngle, {}, [](double x, double) { return withinError(std::sin(x), kTrigonometricError); }},
     {"cos", 7, kAngle, {}, [](double x, double) { return withinError(std::cos(x), kTrigonometricError); }},
     {"exp", 8, kExponent, {}, [](double x, double) { return withinUlps(std::exp(x), 3 + 2 * std::abs(x)); }},
     {"exp2",
      9,
      kExponent,
      {},
      [](double x, double) {
        return boundOfExp2({x, x});
      }},
     {"log",
      10,
      kPositive,
      {},
      [](double x, double) {
        return x >= 0.5 && x <= 2 ? withinError(std::log(x), 0x1p-21) : withinUlps(std::log(x), 3);
      }},
     {"log2", 11, kPositive, {}, [](double x, double) { return boundOfLog2(x); }},
     {"pow", 12, {0x1p-8, 0x1p8}, {0, 8, true}, boundOfPow},
     {"atan", 13, kAnyMagnitude, {}, [](double x, double) { return withinUlps(std::atan(x), kArcTangentUlps); }},
     {"atan2", 14, kNearOne, kNearOne,
      [](double x, double y) { return withinUlps(std::atan2(y, x), kArcTangentUlps); }},
     {"floor", 15, kSmallNumbers, {}, [](double x, double) { return exactly(std::floor(x)); }},
     {"ceil", 16, kSmallNumbers, {}, [](double x, double) { return exactly(std::ceil(x)); }},
     {"trunc", 17, kSmallNumbers, {}, [](double x, double) { return exactly(std::trunc(x)); }},
     {"round_even", 18, kSmallNumbers, {}, [](double x, double) { return exactly(nearestEven(x)); }},
     {"to_int", 19, kSmallNumbers, {}, [](double x, double) { return exactly(std::trunc(x)); }},
     {"to_uint", 20, kSmallNumbers, {}, [](double x, double) { return exactly(std::trunc(std::abs(x))); }},
     {"from_int",
      21,
      kAnyMagnitude,
      {},
      [](double x, double) { return correctlyRounded(std::bit_cast<std::int32_t>(static_cast<float>(x))); }},
     {"from_uint",
      22,
      kAnyMagnitude,
      {},
      [](double x, double) { return correctlyRounded(std::bit_cast<std::uint32_t>(static_cast<float>(x))); }},
     {"compare", 23, kNearOne, kNearOne, comparisons}}};

class Arguments {
 public:
  float from(const Range& range) {
    const double fraction = static_cast<double>(random_() >> 8) * 0x1p-24;
    const double magnitude = range.low > 0 ? range.low * std::pow(range.high / range.low, fraction)
                                           : range.high * fraction;
    const bool negative = range.hasSign && random_() % 2 == 1;
    return static_cast<float>(negative ? -magnitude : magnitude);
  }

 private:
  std::mt19937 random_{17};
};

// Every eighth pair is of equal numbers, and every fourth x is a small whole number or a half.
std::vector<std::array<float, 4>> floatArguments(const FloatRow& row) {
  Arguments arguments;
  std::vector<std::array<float, 4>> pairs;
  for (std::uint32_t i = 0; i < kFloatArguments; ++i) {
    float x = arguments.from(row.x);
    const float y = arguments.from(row.y);
    if (i % 8 == 3 && row.y.low == row.x.low) x = y;
    if (i % 4 == 1 && row.x.high > 64 && row.x.low > 0) x = 0.5f * static_cast<float>(1 + i / 4 % 100);
    pairs.push_back({x, y, 0, 0});
  }
  return pairs;
}

std::string describe(const FloatRow& row, const std::array<float, 4>& pair, float found, const Interval& permitted) {
  const bool hasTwo = row.y.high > 0;
  const std::string list = hasTwo ? fmt::format("{:.9g}, {:.9g}", pair[0], pair[1]) : fmt::format("{:.9g}", pair[0]);
  return fmt::format("{}({}): expected {:.9g} to {:.9g}, found {:.9g} ({:#010x})", row.name, list, permitted.low,
                     permitted.high, found, std::bit_cast<std::uint32_t>(found));
}

ShaderRun shaderOf(const FloatRow& row) { return {spirv::floats, kFloatArguments, 0, {{0, row.function}}}; }

Finding runFloat(const FloatRow& row, Workbench& workbench) {
  using Row = std::array<float, 4>;
  const std::vector<Row> pairs = floatArguments(row);
  const std::vector<Row> found = runShader<Row>(workbench.device(), shaderOf(row), pairs, pairs.size());
  Mismatches mismatches;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Interval permitted = row.permitted(pairs[i][0], pairs[i][1]);
    const float value = found[i][0];
    mismatches.require(outputPosition(i, 0), permitted.low, permitted.high);
    mismatches.note(permitted.contains(value) ? "" : describe(row, pairs[i], value, permitted));
  }
  return perInvocation(mismatches.finding());
}

}  // namespace

Cases floatCases() {
  Cases cases;
  for (const FloatRow& row : kFloatRows) {
    cases.push_back(caseOf(fmt::format("leaf.float.{}", row.name), "leaf.float", pipelineOf(shaderOf(row)),
                           [row](Workbench& workbench) { return runFloat(row, workbench); }));
  }
  return cases;
}

}  // namespace candela::conformance
