// Loops that end in unusual positions. `state` is an invocation's own word, so that invocations diverge.
#ifndef CANDELA_CONFORMANCE_LOOPS_GLSL
#define CANDELA_CONFORMANCE_LOOPS_GLSL
#include "chain.glsl"

const uint kNone = 0xffffffffu;

// Counts iterations: in one loop, in two consecutive loops, and in nested loops.
uvec4 countIterations(uint state, uint first, uint second, uint inner) {
  uint counts[3] = uint[](0u, 0u, 0u);
  while (counts[0] < first) {
    state = next(state);
    ++counts[0];
  }
  while (counts[1] < second) {
    state = next(state ^ 1u);
    ++counts[1];
  }
  for (uint i = 0u; i < inner; ++i) {
    for (uint k = 0u; k < inner; ++k) {
      state = next(state);
      ++counts[2];
    }
  }
  return uvec4(counts[0], counts[1], counts[2], state);
}

// Several samples in one loop: a sample that ended is added in the middle of the loop, whose only exit is there.
uvec4 endInTheMiddle(uint state) {
  uint samples = 1u + state % 7u;
  vec3 sum = vec3(0.0);
  vec3 light = vec3(0.0);
  uint sampleIndex = 0u;
  uint segments = 0u;
  while (true) {
    state = next(state);
    light += vec3(float(state & 255u), float((state >> 8) & 255u), 1.0);
    segments += 1u;
    bool ended = (state >> 28) < 5u;
    if (ended) {
      sum += light;
      light = vec3(0.0);
      sampleIndex += 1u;
      if (sampleIndex == samples) break;
      state += sampleIndex;
    }
    state ^= segments;
  }
  return uvec4(uvec3(sum), sampleIndex + 1000u * segments);
}

// The same, but the loop ends at its end, where the sum has not changed in the last iterations of other invocations.
uvec4 endAtTheEnd(uint state) {
  uint samples = 1u + state % 7u;
  vec3 sum = vec3(0.0);
  vec3 light = vec3(0.0);
  uint sampleIndex = 0u;
  uint segments = 0u;
  while (sampleIndex < samples) {
    state = next(state);
    light += vec3(float(state & 255u), float((state >> 8) & 255u), 1.0);
    segments += 1u;
    if ((state >> 28) < 5u) {
      sum += light;
      light = vec3(0.0);
      sampleIndex += 1u;
    }
    state ^= segments;
    if (sampleIndex == samples) break;
    state += sampleIndex;
  }
  return uvec4(uvec3(sum), sampleIndex + 1000u * segments);
}

// Values of the iteration in which an invocation leaves the loop.
uvec4 valuesAfterBreak(uint state) {
  uint iterations = 0u;
  uint before = 0u;
  while (true) {
    before = state;
    state = next(state);
    iterations += 1u;
    if ((state >> 27) == 3u) break;
  }
  return uvec4(state, before, iterations, state ^ before);
}

uvec4 nestedBreak(uint state) {
  uint foundRow = kNone;
  uint foundColumn = kNone;
  uint last = 0u;
  uint sum = 0u;
  for (uint row = 0u; row < 20u; ++row) {
    for (uint column = 0u; column < 20u; ++column) {
      state = next(state);
      if ((state & 31u) == 0u) {
        foundRow = row;
        foundColumn = column;
        break;
      }
      last = column;
    }
    if (foundColumn != kNone && (state >> 30) == 0u) break;
    sum += last + row;
  }
  return uvec4(foundRow, foundColumn, last, sum);
}

uvec4 continued(uint state) {
  uint sum = 0u;
  uint skipped = 0u;
  uint k = 0u;
  do {
    ++k;
    state = next(state);
    if ((state & 3u) == 0u) {
      ++skipped;
      continue;
    }
    if ((state & 7u) == 1u && k > 3u) sum += k;
    sum ^= state >> 20;
  } while ((state >> 27) != 5u && k < 200u);
  return uvec4(sum, skipped, k, state);
}

// A function that returns from the inner of two loops.
uint searched(uint state, uint wanted, inout uint looked) {
  for (uint i = 0u; i < 30u; ++i) {
    uint part = state;
    for (uint k = 0u; k < 8u; ++k) {
      ++looked;
      if ((part & 15u) == wanted) return 8u * i + k;
      part >>= 4;
    }
    state = next(state);
  }
  return kNone;
}

uvec4 returned(uint state) {
  uint looked = 0u;
  uint first = searched(state, 3u, looked);
  uint second = first < 4u ? searched(state + first, 11u, looked) : first + 7u;
  return uvec4(first, second, looked, searched(next(state), state & 15u, looked));
}

#endif
