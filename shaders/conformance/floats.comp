// One function of GLSL on 32-bit floats for each value of kFunction, over an array of arguments x, y as their bits.
#version 460

layout(constant_id = 0) const uint kFunction = 0u;
layout(local_size_x = 64) in;
layout(push_constant) uniform Push { uint count; uint unused; };
layout(set = 0, binding = 0, std430) readonly buffer Inputs { vec4 inputs[]; };
layout(set = 0, binding = 1, std430) writeonly buffer Outputs { vec4 outputs[]; };

float valueOf(float x, float y) {
  switch (kFunction) {
    case 0u: return x + y;
    case 1u: return x - y;
    case 2u: return x * y;
    case 3u: return x / y;
    case 4u: return sqrt(x);
    case 5u: return inversesqrt(x);
    case 6u: return sin(x);
    case 7u: return cos(x);
    case 8u: return exp(x);
    case 9u: return exp2(x);
    case 10u: return log(x);
    case 11u: return log2(x);
    case 12u: return pow(x, y);
    case 13u: return atan(x);
    case 14u: return atan(y, x);
    case 15u: return floor(x);
    case 16u: return ceil(x);
    case 17u: return trunc(x);
    case 18u: return roundEven(x);
    case 19u: return float(int(x));
    case 20u: return float(uint(abs(x)));
    case 21u: return float(floatBitsToInt(x));
    case 22u: return float(floatBitsToUint(x));
    case 23u: return uintBitsToFloat(uint(x < y) | uint(x <= y) << 1 | uint(x == y) << 2 | uint(x != y) << 3 |
                                     uint(x >= y) << 4 | uint(x > y) << 5 | 0x3f800000u);
  }
  return 0.0;
}

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  precise float value = valueOf(inputs[i].x, inputs[i].y);
  outputs[i] = vec4(value, 0.0, 0.0, 0.0);
}
