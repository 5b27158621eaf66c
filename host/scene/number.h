// Numbers as scene files write them.
#pragma once
#include <cstdint>
#include <string_view>

namespace candela::scene {

enum class NumberStatus : std::uint8_t { ok, notANumber, notFinite, overflow };

template <typename Real>
struct ParsedNumber {
  Real value = 0;
  NumberStatus status = NumberStatus::ok;
};

/// True if `text` starts like a number: a word that does not is a keyword, never a misspelt number.
bool looksLikeNumber(std::string_view text);

/// The whole of `text` as a decimal number ("8", ".8", "+1.1e-16"), rounded once to binary32. Too small rounds to 0.
ParsedNumber<float> parseFloat(std::string_view text);
/// The same in binary64.
ParsedNumber<double> parseDouble(std::string_view text);

}  // namespace candela::scene
