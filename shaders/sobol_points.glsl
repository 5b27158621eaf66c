// Dimensions 2 to 4 of the Sobol sequence (Joe and Kuo, new-joe-kuo-6.21201), least significant bit first. Owen
// scrambling needs this order, so that no bits have to be reversed.
//
// A dimension is a matrix over GF(2) that is derived from a primitive polynomial p. Over GF(2),
// p(x)^(2^k) = p(x^(2^k)), so the matrix of twice the degree consists of blocks of the previous one, and multiplying by
// it takes one step for each doubling instead of one for each bit. (In dimension 2, p = x + 1, this is Pascal's
// triangle, whose blocks are Sierpinski's.) A step adds the upper half of every block of bits to lower bits, as given
// by the terms of p.
#ifndef CANDELA_SOBOL_POINTS_GLSL
#define CANDELA_SOBOL_POINTS_GLSL

// Multiplies by the matrix of p = x + 1.
uint reversedSobol2(uint bits) {
  bits ^= bits >> 16;
  bits ^= (bits >> 8) & 0x00ff00ffu;
  bits ^= (bits >> 4) & 0x0f0f0f0fu;
  bits ^= (bits >> 2) & 0x33333333u;
  return bits ^ ((bits >> 1) & 0x55555555u);
}

// One step for p = x^2 + x + 1. Blocks have four runs of `run` bits; `mask` selects the lowest run.
uint sobolStepOfDegree2(uint bits, uint run, uint mask) {
  uint third = (bits >> (2u * run)) & mask;
  uint fourth = (bits >> (3u * run)) & mask;
  return bits ^ third ^ (third << run) ^ fourth ^ (fourth << (2u * run));
}

uint reversedSobol3(uint bits) {
  bits = sobolStepOfDegree2(bits, 8u, 0x000000ffu);
  bits = sobolStepOfDegree2(bits, 4u, 0x000f000fu);
  bits = sobolStepOfDegree2(bits, 2u, 0x03030303u);
  bits = sobolStepOfDegree2(bits, 1u, 0x11111111u);
  return bits ^ ((bits >> 1) & 0x55555555u);
}

// One step for p = x^3 + x + 1. Blocks have six runs of `run` bits; `maskOfTwo` selects the lowest two, `mask` the
// lowest one.
uint sobolStepOfDegree3(uint bits, uint run, uint maskOfTwo, uint mask) {
  uint fourthAndFifth = (bits >> (3u * run)) & maskOfTwo;
  uint sixth = (bits >> (5u * run)) & mask;
  uint twice = sixth ^ (sixth << run);
  return bits ^ fourthAndFifth ^ (fourthAndFifth << run) ^ twice ^ (twice << (2u * run));
}

uint reversedSobol4(uint bits) {
  bits ^= (bits >> 24) ^ ((bits >> 24) << 8);  // a block of 48, of whose upper half 32 bits contain only one run
  bits = sobolStepOfDegree3(bits, 4u, 0x000000ffu, 0x0000000fu);
  bits = sobolStepOfDegree3(bits, 2u, 0x0f00f00fu, 0x03003003u);
  bits = sobolStepOfDegree3(bits, 1u, 0xc30c30c3u, 0x41041041u);
  return bits ^ ((bits >> 1) & 0x49249249u);
}

// Returns the point of `index` with reversed bits.
uvec3 reversedSobolPoint(uint index) {
  return uvec3(reversedSobol2(index), reversedSobol3(index), reversedSobol4(index));
}

#endif
