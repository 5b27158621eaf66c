// Dimensions 2 to 4 of the Sobol sequence (Joe and Kuo, new-joe-kuo-6.21201), least significant bit first: what Owen
// scrambling wants, so that nothing need be reversed. Entry b belongs to bit b of the index.
#ifndef CANDELA_SOBOL_DIRECTIONS_GLSL
#define CANDELA_SOBOL_DIRECTIONS_GLSL
#extension GL_EXT_control_flow_attributes : require

const uvec3 kReversedDirections[32] = uvec3[32](
    uvec3(0x00000001u, 0x00000001u, 0x00000001u),
    uvec3(0x00000003u, 0x00000003u, 0x00000003u),
    uvec3(0x00000005u, 0x00000006u, 0x00000004u),
    uvec3(0x0000000fu, 0x00000009u, 0x0000000au),
    uvec3(0x00000011u, 0x00000017u, 0x0000001fu),
    uvec3(0x00000033u, 0x0000003au, 0x0000002eu),
    uvec3(0x00000055u, 0x00000071u, 0x00000045u),
    uvec3(0x000000ffu, 0x000000a3u, 0x000000c9u),
    uvec3(0x00000101u, 0x00000116u, 0x0000011bu),
    uvec3(0x00000303u, 0x00000339u, 0x000002a4u),
    uvec3(0x00000505u, 0x00000677u, 0x0000079au),
    uvec3(0x00000f0fu, 0x000009aau, 0x00000b67u),
    uvec3(0x00001111u, 0x00001601u, 0x0000101eu),
    uvec3(0x00003333u, 0x00003903u, 0x0000302du),
    uvec3(0x00005555u, 0x00007706u, 0x00004041u),
    uvec3(0x0000ffffu, 0x0000aa09u, 0x0000a0c3u),
    uvec3(0x00010001u, 0x00010117u, 0x0001f104u),
    uvec3(0x00030003u, 0x0003033au, 0x0002e28au),
    uvec3(0x00050005u, 0x00060671u, 0x000457dfu),
    uvec3(0x000f000fu, 0x000909a3u, 0x000c9baeu),
    uvec3(0x00110011u, 0x00171616u, 0x0011a105u),
    uvec3(0x00330033u, 0x003a3939u, 0x002a7289u),
    uvec3(0x00550055u, 0x00717777u, 0x0079e7dbu),
    uvec3(0x00ff00ffu, 0x00a3aaaau, 0x00b6dba4u),
    uvec3(0x01010101u, 0x01170001u, 0x0100011au),
    uvec3(0x03030303u, 0x033a0003u, 0x030002a7u),
    uvec3(0x05050505u, 0x06710006u, 0x0400079eu),
    uvec3(0x0f0f0f0fu, 0x09a30009u, 0x0a000b6du),
    uvec3(0x11111111u, 0x16160017u, 0x1f001001u),
    uvec3(0x33333333u, 0x3939003au, 0x2e003003u),
    uvec3(0x55555555u, 0x77770071u, 0x45004004u),
    uvec3(0xffffffffu, 0xaaaa00a3u, 0xc900a00au));

// The point of `index`, bits reversed. Straight-line code: a loop here would cost a software device 32 turns a call.
uvec3 reversedSobolPoint(uint index) {
  uvec3 point = uvec3(0u);
  [[unroll]] for (uint bit = 0u; bit < 32u; ++bit) {
    point ^= kReversedDirections[bit] & uvec3(0u - ((index >> bit) & 1u));
  }
  return point;
}

#endif
