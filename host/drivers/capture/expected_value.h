// The values that one or several words of a buffer may have after a dispatch.
#pragma once
#include <cstdint>
#include <vector>

namespace candela::capture {

/// The interpretation of the words of a value. The numbers are written to files: see reproduce.c.
enum class ValueType : std::uint32_t {
  word = 0,    ///< an unsigned integer of 32 bits, or bits that must be equal
  number = 1,  ///< a 32-bit float
  sum = 2,     ///< three words of a film's sum in units of 2^-40, the lowest first
};

/// The position of a value in the buffers of the last dispatch.
struct WordPosition {
  std::uint32_t binding = 0;
  std::uint32_t word = 0;  ///< index of its first word in the buffer
};

/// A value that must be in [low, high]. Both are whole numbers for ValueType::word.
struct ExpectedValue {
  ValueType type = ValueType::word;
  WordPosition position;
  double low = 0;
  double high = 0;
};

using ExpectedValues = std::vector<ExpectedValue>;

}  // namespace candela::capture
