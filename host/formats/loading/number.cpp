// Parses numbers of scene files.
#include "host/formats/loading/number.h"

#include <charconv>
#include <cmath>

#include "host/base/lower_case.h"

namespace candela::scene {
namespace {

/// Returns whether a decimal number that is out of range is too small rather than too large.
bool isTiny(std::string_view text) {
  const std::size_t exponent = text.find_first_of("eE");
  if (exponent != std::string_view::npos) return text.substr(exponent + 1).starts_with('-');
  return text.substr(0, text.find('.')).find_first_of("123456789") == std::string_view::npos;
}

template <typename Real>
ParsedNumber<Real> parseReal(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  Real value = 0;
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc::invalid_argument || stop != end) return {0, NumberStatus::notANumber};
  if (error == std::errc::result_out_of_range) {
    return isTiny(text) ? ParsedNumber<Real>{} : ParsedNumber<Real>{0, NumberStatus::overflow};
  }
  if (!std::isfinite(value)) return {0, NumberStatus::notFinite};
  return {value, NumberStatus::ok};
}

}  // namespace

bool looksLikeNumber(std::string_view text) {
  if (text.empty()) return false;
  const char first = text.front();
  if ((first >= '0' && first <= '9') || first == '.' || first == '+' || first == '-') return true;
  return equalsIgnoringCase(text, "nan") || equalsIgnoringCase(text, "inf") || equalsIgnoringCase(text, "infinity");
}

ParsedNumber<float> parseFloat(std::string_view text) { return parseReal<float>(text); }
ParsedNumber<double> parseDouble(std::string_view text) { return parseReal<double>(text); }

}  // namespace candela::scene
