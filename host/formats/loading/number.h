// Numbers in the notation of scene files.
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

/// Returns whether `text` starts like a number. Any other word is a keyword, never a misspelt number.
bool looksLikeNumber(std::string_view text);

/// Parses the whole of `text` as a decimal number ("8", ".8", "+1.1e-16"), rounded once to binary32. Numbers that are
/// too small become 0.
ParsedNumber<float> parseFloat(std::string_view text);
/// Parses a number in the same way, rounded to binary64.
ParsedNumber<double> parseDouble(std::string_view text);

}  // namespace candela::scene
