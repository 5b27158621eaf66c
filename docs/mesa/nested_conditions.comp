// Invocation i counts to i, in 100 steps at most: by nested conditions or, with UNROLLED, by a loop that Mesa unrolls to nested conditions.
// The difference between the result and the smaller one of i and 100 is written and must be 0.
#version 460
#extension GL_EXT_control_flow_attributes : require

layout(local_size_x = 8) in;
layout(set = 0, binding = 0) buffer Words { uint words[]; };

#define IF(inner) \
  if (count < id) { \
    count += step; \
    inner \
  }
#define FIVE(inner) IF(IF(IF(IF(IF(inner)))))
#define TWENTY_FIVE(inner) FIVE(FIVE(FIVE(FIVE(FIVE(inner)))))
#define HUNDRED(inner) TWENTY_FIVE(TWENTY_FIVE(TWENTY_FIVE(TWENTY_FIVE(inner))))

void main() {
  uint id = gl_GlobalInvocationID.x;
  uint step = words[id];  // 1, which the driver does not know
  uint count = 0u;
#ifdef UNROLLED
  [[unroll]] for (uint k = 0u; k < 100u && count < id; ++k) count += step;
#else
  HUNDRED(;)
#endif
  words[id] = count - min(id, 100u);
}
