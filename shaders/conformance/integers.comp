// One integer function of GLSL for each value of kFunction, over an array of arguments.
#version 460

layout(constant_id = 0) const uint kFunction = 0u;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { uvec4 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { uvec4 outputs[]; };

uvec4 added(uvec4 v) {
  uint carry, borrow;
  uint sum = uaddCarry(v.x, v.y, carry);
  uint difference = usubBorrow(v.x, v.y, borrow);
  return uvec4(sum, carry, difference, borrow);
}

uvec4 multiplied(uvec4 v) {
  uint high, low;
  int signedHigh, signedLow;
  umulExtended(v.x, v.y, high, low);
  imulExtended(int(v.x), int(v.y), signedHigh, signedLow);
  return uvec4(low, high, uint(signedLow), uint(signedHigh));
}

uvec4 shifted(uvec4 v) {
  uint n = v.y & 31u;
  return uvec4(v.x << n, v.x >> n, uint(int(v.x) >> int(n)), (v.x << n) | (v.x >> ((32u - n) & 31u)));
}

uvec4 bitfield(uvec4 v) {
  int offset = int(v.z & 31u);
  int bits = int(v.w % uint(33 - offset));
  return uvec4(bitfieldExtract(v.x, offset, bits), uint(bitfieldExtract(int(v.x), offset, bits)),
               bitfieldInsert(v.x, v.y, offset, bits), uint(bits));
}

uvec4 ordered(uvec4 v) {
  ivec2 s = ivec2(v.xy);
  return uvec4(min(v.x, v.y), max(v.x, v.y), uint(min(s.x, s.y)), uint(clamp(s.x, -1000, max(s.y, -1000))));
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  uvec4 v = inputs[i];
  uvec4 result = uvec4(0u);
  switch (kFunction) {
    case 0u: result = added(v); break;
    case 1u: result = multiplied(v); break;
    case 2u: result = uvec4(v.x / v.y, v.x % v.y, v.z / (v.y | 1u), v.z % (v.y | 1u)); break;
    case 3u: result = uvec4(bitfieldReverse(v.x), bitCount(v.x), uint(findMSB(v.x)), uint(findLSB(v.x))); break;
    case 4u: result = bitfield(v); break;
    case 5u: result = shifted(v); break;
    case 6u: result = ordered(v); break;
  }
  outputs[i] = result;
}
