// A chain of dependent operations that no compiler can compute in closed form.
#ifndef CANDELA_CONFORMANCE_CHAIN_GLSL
#define CANDELA_CONFORMANCE_CHAIN_GLSL

uint next(uint state) { return (state ^ (state >> 15)) * 0x2c1b3c6du + 0x9e3779b9u; }

#endif
