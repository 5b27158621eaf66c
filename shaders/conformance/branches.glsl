// Switches, functions and stacks under divergent control flow.
#ifndef CANDELA_CONFORMANCE_BRANCHES_GLSL
#define CANDELA_CONFORMANCE_BRANCHES_GLSL
#include "chain.glsl"

const uint kStackSize = 64u;

// Returns early from a switch in a loop if the sum exceeds a limit.
uvec4 switched(uint state) {
  uint sum = 0u;
  uint after = 0u;
  uint k = 0u;
  for (; k < 60u; ++k) {
    state = next(state);
    switch (state >> 29) {
      case 0u:
        sum += 1u;
        continue;
      case 1u:
        sum += 2u;  // falls through
      case 2u:
        sum += 4u;
        break;
      case 3u:
        if (sum > 300u) return uvec4(sum, after, k, 1u);
        sum += 8u;
        break;
      case 4u:
        for (uint i = 0u; i < 9u; ++i) {
          if (((state >> i) & 1u) != 0u) break;
          sum += 16u;
        }
        break;
      default:
        sum += (state >> 4) & 7u;
    }
    after += k;
    if (after > 900u) break;
  }
  return uvec4(sum, after, k, 0u);
}

// Traverses a binary tree that the words of the chain define, depth first.
uvec4 treeOnStack(uint seed) {
  uint stack[kStackSize];
  uint top = 1u;
  stack[0] = 1u;
  uint sum = 0u;
  uint visited = 0u;
  uint deepest = 0u;
  while (top > 0u && visited < 3000u) {
    --top;
    uint node = stack[top];
    ++visited;
    uint word = next(node ^ seed);
    sum = (sum << 1) ^ (sum >> 31) ^ word;
    deepest = max(deepest, uint(findMSB(node)));
    if (node < (1u << 24) && (word >> 29) < 5u && top + 2u <= kStackSize) {
      stack[top] = 2u * node + 1u;
      stack[top + 1u] = 2u * node;
      top += 2u;
    }
  }
  return uvec4(sum, visited, deepest, top);
}

// Fills the whole stack, and empties it with exchanges at computed indices.
uvec4 deepStack(uint state) {
  uint stack[kStackSize];
  for (uint k = 0u; k < kStackSize; ++k) {
    state = next(state);
    stack[k] = state;
  }
  uint sum = 0u;
  for (uint top = kStackSize; top > 0u; --top) {
    uint other = state % top;
    uint word = stack[other];
    stack[other] = stack[top - 1u];
    sum = (sum << 3) ^ (sum >> 29) ^ word;
    state = next(state ^ word);
    if (top == 5u && (state & 1u) != 0u) break;
  }
  return uvec4(sum, state, stack[0], stack[3]);
}

void exchangeWith(inout uint a, inout uint b, out uint sum) {
  uint old = a;
  a = b + 1u;
  b = old * 3u;
  sum = a ^ b;
}

uvec4 copiedInAndOut(uint state) {
  uint words[4] = uint[](state, next(state), 7u, state >> 3);
  uint sum = 0u;
  for (uint k = 0u; k < 12u; ++k) {
    uint part;
    exchangeWith(words[(state + k) & 3u], words[(state + k + 1u) & 3u], part);
    sum += part;
    if ((sum >> 30) == 2u) exchangeWith(sum, words[k & 3u], part);
  }
  return uvec4(words[0] ^ words[1], words[2], words[3], sum);
}

bool counted(inout uint calls, bool result) {
  ++calls;
  return result;
}

uvec4 shortCircuit(uint state) {
  uint calls = 0u;
  uint taken = 0u;
  for (uint k = 0u; k < 32u; ++k) {
    state = next(state);
    bool a = (state & 1u) != 0u, b = (state & 2u) != 0u, c = (state & 4u) != 0u;
    if (a && counted(calls, b) || c && counted(calls, a)) taken += k;
    taken += b || counted(calls, c) ? 1u : 0u;
    taken ^= (a ? counted(calls, b) : c) ? 0x100u : 0u;
  }
  return uvec4(calls, taken, state, 0u);
}

#endif
