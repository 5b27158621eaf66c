// The switches, functions and stacks of shaders/conformance/branches.glsl.
#include <algorithm>
#include <bit>
#include <vector>

#include "host/drivers/conformance/control_twins.h"

namespace candela::conformance {
namespace {

constexpr std::size_t kStackSize = 64;

// Returns the term that one iteration of switched() adds to its sum, unless it returns early.
std::uint32_t termOf(std::uint32_t state) {
  switch (state >> 29) {
    case 0:
      return 1;
    case 1:
      return 6;
    case 2:
      return 4;
    case 3:
      return 8;
    case 4:
      return 16 * static_cast<std::uint32_t>(std::min(9, std::countr_zero(state)));
    default:
      return state / 16 % 8;
  }
}

std::uint32_t exchangeWith(std::uint32_t& a, std::uint32_t& b) {
  const std::uint32_t newA = b + 1, newB = a * 3;
  a = newA;
  b = newB;
  return a ^ b;
}

}  // namespace

Words switched(std::uint32_t state, std::uint32_t) {
  std::uint32_t sum = 0, after = 0;
  for (std::uint32_t k = 0; k < 60; ++k) {
    state = nextWord(state);
    if (state >> 29 == 3 && sum > 300) return {sum, after, k, 1};
    sum += termOf(state);
    if (state >> 29 != 0) after += k;
    if (state >> 29 != 0 && after > 900) return {sum, after, k, 0};
  }
  return {sum, after, 60, 0};
}

Words treeOnStack(std::uint32_t seed, std::uint32_t) {
  std::vector<std::uint32_t> stack{1};
  std::uint32_t sum = 0, visited = 0;
  int deepest = 0;
  while (!stack.empty() && visited < 3000) {
    const std::uint32_t node = stack.back();
    stack.pop_back();
    ++visited;
    const std::uint32_t word = nextWord(node ^ seed);
    sum = std::rotl(sum, 1) ^ word;
    deepest = std::max(deepest, 31 - std::countl_zero(node));
    if (node >= 1u << 24 || word >> 29 >= 5 || stack.size() + 2 > kStackSize) continue;
    stack.push_back(2 * node + 1);
    stack.push_back(2 * node);
  }
  return {sum, visited, static_cast<std::uint32_t>(deepest), static_cast<std::uint32_t>(stack.size())};
}

Words deepStack(std::uint32_t state, std::uint32_t) {
  std::vector<std::uint32_t> stack;
  while (stack.size() < kStackSize) stack.push_back(state = nextWord(state));
  std::uint32_t sum = 0;
  for (std::uint32_t top = kStackSize; top > 0; --top) {
    const std::uint32_t word = stack[state % top];
    stack[state % top] = stack[top - 1];
    sum = std::rotl(sum, 3) ^ word;
    state = nextWord(state ^ word);
    if (top == 5 && state % 2 == 1) break;
  }
  return {sum, state, stack[0], stack[3]};
}

Words copiedInAndOut(std::uint32_t state, std::uint32_t) {
  Words words{state, nextWord(state), 7, state >> 3};
  std::uint32_t sum = 0;
  for (std::uint32_t k = 0; k < 12; ++k) {
    sum += exchangeWith(words[(state + k) % 4], words[(state + k + 1) % 4]);
    if (sum >> 30 == 2) exchangeWith(sum, words[k % 4]);
  }
  return {words[0] ^ words[1], words[2], words[3], sum};
}

Words shortCircuit(std::uint32_t state, std::uint32_t) {
  std::uint32_t calls = 0, taken = 0;
  for (std::uint32_t k = 0; k < 32; ++k) {
    state = nextWord(state);
    const bool a = state & 1, b = state & 2, c = state & 4;
    const bool firstHolds = a && b;
    calls += (a ? 1 : 0) + (!firstHolds && c ? 1 : 0) + (!b ? 1 : 0) + (a ? 1 : 0);
    if (firstHolds || (c && a)) taken += k;
    taken += b || c ? 1 : 0;
    if (a ? b : c) taken ^= 0x100;
  }
  return {calls, taken, state, 0};
}

}  // namespace candela::conformance
