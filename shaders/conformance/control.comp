// One piece of control flow for each value of kFunction. host/drivers/conformance/control_twins.cpp computes the same.
#version 460
#extension GL_GOOGLE_include_directive : require
#include "conformance/branches.glsl"
#include "conformance/loops.glsl"

layout(constant_id = 0) const uint kFunction = 0u;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint parameter; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { uint inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { uvec4 outputs[]; };

uvec4 resultOf(uint state) {
  switch (kFunction) {
    case 0u: return countIterations(state, parameter, 0u, 0u);
    case 1u: return countIterations(state, parameter, parameter, 0u);
    case 2u: return countIterations(state, 0u, 0u, parameter);
    case 3u: return endInTheMiddle(state);
    case 4u: return endAtTheEnd(state);
    case 5u: return valuesAfterBreak(state);
    case 6u: return nestedBreak(state);
    case 7u: return continued(state);
    case 8u: return returned(state);
    case 9u: return switched(state);
    case 10u: return treeOnStack(state);
    case 11u: return deepStack(state);
    case 12u: return copiedInAndOut(state);
    case 13u: return shortCircuit(state);
  }
  return uvec4(0u);
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  outputs[i] = resultOf(inputs[i]);
}
