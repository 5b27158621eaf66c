// The loops of shaders/conformance/loops.glsl, written without exits in the middle where that is possible.
#include <optional>
#include <utility>

#include "host/drivers/conformance/control_twins.h"

namespace candela::conformance {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr std::uint32_t kRows = 20;

std::uint32_t chained(std::uint32_t state, std::uint32_t times) {
  for (; times > 0; --times) state = nextWord(state);
  return state;
}

// Computes the sums of samples that end at random. `atEnd`: the order of operations of endAtTheEnd().
Words sumOfSamples(std::uint32_t state, bool atEnd) {
  const std::uint32_t samples = 1 + state % 7;
  Words sum{};
  std::uint32_t finished = 0, segments = 0;
  Words light{};
  while (finished < samples) {
    state = nextWord(state);
    light = {light[0] + state % 256, light[1] + state / 256 % 256, light[2] + 1, 0};
    ++segments;
    const bool ends = state >> 28 < 5;
    if (ends) {
      for (int k = 0; k < 3; ++k) sum[k] += std::exchange(light[k], 0u);
      ++finished;
      if (!atEnd) state += finished;
    }
    state ^= segments;
    if (atEnd) state += finished;
  }
  sum[3] = finished + 1000 * segments;
  return sum;
}

// Returns the word after the row, and the column at which it ends early.
std::pair<std::uint32_t, std::optional<std::uint32_t>> scanRow(std::uint32_t state) {
  for (std::uint32_t column = 0; column < kRows; ++column) {
    state = nextWord(state);
    if (state % 32 == 0) return {state, column};
  }
  return {state, std::nullopt};
}

std::uint32_t searched(std::uint32_t state, std::uint32_t wanted, std::uint32_t& looked) {
  for (std::uint32_t position = 0; position < 240; ++position) {
    ++looked;
    if (((state >> (4 * (position % 8))) & 15) == wanted) return position;
    if (position % 8 == 7) state = nextWord(state);
  }
  return kNone;
}

}  // namespace

std::uint32_t nextWord(std::uint32_t state) { return (state ^ (state >> 15)) * 0x2c1b3c6du + 0x9e3779b9u; }

Words countOneLoop(std::uint32_t state, std::uint32_t iterations) {
  return {iterations, 0, 0, chained(state, iterations)};
}

Words countTwoLoops(std::uint32_t state, std::uint32_t iterations) {
  state = chained(state, iterations);
  for (std::uint32_t k = 0; k < iterations; ++k) state = nextWord(state ^ 1);
  return {iterations, iterations, 0, state};
}

Words countNestedLoops(std::uint32_t state, std::uint32_t iterations) {
  return {0, 0, iterations * iterations, chained(state, iterations * iterations)};
}

Words endInTheMiddle(std::uint32_t state, std::uint32_t) { return sumOfSamples(state, false); }
Words endAtTheEnd(std::uint32_t state, std::uint32_t) { return sumOfSamples(state, true); }

Words valuesAfterBreak(std::uint32_t state, std::uint32_t) {
  std::uint32_t iterations = 1;
  std::uint32_t after = nextWord(state);
  for (; after >> 27 != 3; ++iterations) {
    state = after;
    after = nextWord(state);
  }
  return {after, state, iterations, after ^ state};
}

Words nestedBreak(std::uint32_t state, std::uint32_t) {
  Words result{kNone, kNone, 0, 0};
  for (std::uint32_t row = 0; row < kRows; ++row) {
    const auto [after, column] = scanRow(state);
    state = after;
    if (column) result = {row, *column, *column > 0 ? *column - 1 : result[2], result[3]};
    if (!column) result[2] = kRows - 1;
    if (result[1] != kNone && state >> 30 == 0) break;
    result[3] += result[2] + row;
  }
  return result;
}

Words continued(std::uint32_t state, std::uint32_t) {
  std::uint32_t sum = 0, skipped = 0, k = 0;
  for (bool continues = true; continues; continues = state >> 27 != 5 && k < 200) {
    state = nextWord(state);
    ++k;
    const bool isSkipped = state % 4 == 0;
    skipped += isSkipped ? 1 : 0;
    if (!isSkipped) sum = (sum + (state % 8 == 1 && k > 3 ? k : 0)) ^ (state >> 20);
  }
  return {sum, skipped, k, state};
}

Words returned(std::uint32_t state, std::uint32_t) {
  std::uint32_t looked = 0;
  const std::uint32_t first = searched(state, 3, looked);
  const std::uint32_t second = first < 4 ? searched(state + first, 11, looked) : first + 7;
  const std::uint32_t before = looked;
  return {first, second, before, searched(nextWord(state), state % 16, looked)};
}

}  // namespace candela::conformance
