// The Sobol sequence and its scrambling.
#include <array>
#include <bit>

#include "host/trace/reference/sampler.h"

namespace candela::reference {
namespace {

// A primitive polynomial of Joe and Kuo's table new-joe-kuo-6.21201: degree s, coefficients a, initial numbers m.
struct SobolPolynomial {
  std::uint32_t degree;
  std::uint32_t coefficients;
  std::array<std::uint32_t, 3> initial;
};
constexpr std::array<SobolPolynomial, 3> kPolynomials{{{1, 0, {1}}, {2, 1, {1, 3}}, {3, 1, {1, 3, 1}}}};

using Directions = std::array<std::uint32_t, 32>;

constexpr Directions sobolDirections(const SobolPolynomial& polynomial) {
  const std::uint32_t s = polynomial.degree;
  Directions v{};
  for (std::uint32_t b = 0; b < 32; ++b) {
    if (b < s) {
      v[b] = polynomial.initial[b] << (31 - b);
      continue;
    }
    v[b] = v[b - s] ^ (v[b - s] >> s);
    for (std::uint32_t k = 1; k < s; ++k) {
      if ((polynomial.coefficients >> (s - 1 - k)) & 1) v[b] ^= v[b - k];
    }
  }
  return v;
}

constexpr std::array<Directions, 3> kDirections{sobolDirections(kPolynomials[0]), sobolDirections(kPolynomials[1]),
                                                sobolDirections(kPolynomials[2])};

}  // namespace

std::uint32_t reverseBits(std::uint32_t x) {
  x = ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
  x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
  x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
  x = ((x & 0x00ff00ffu) << 8) | ((x >> 8) & 0x00ff00ffu);
  return (x << 16) | (x >> 16);
}

std::uint32_t owenPermutation(std::uint32_t x, std::uint32_t key) {
  x += key;
  x ^= x * 0x6c50b47cu;
  x ^= x * 0xb82f1e52u;
  x ^= x * 0xc7afe638u;
  x ^= x * 0x8d22f6e6u;
  return x;
}

std::uint32_t sobolPoint(std::uint32_t index, std::uint32_t slot) {
  if (slot == 0) return reverseBits(index);  // the van der Corput sequence
  std::uint32_t point = 0;
  for (; index != 0; index &= index - 1) {
    point ^= kDirections[slot - 1][static_cast<std::size_t>(std::countr_zero(index))];
  }
  return point;
}

}  // namespace candela::reference
