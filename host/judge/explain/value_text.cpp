// Formats values of quantities as text.
#include "host/judge/explain/value_text.h"

#include <fmt/format.h>

namespace candela::explain {

std::string valueText(const Value& value) {
  std::string text = value.words;
  for (const double number : value.numbers) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", number);
  return text;
}

std::string apartText(const Quantity& quantity) {
  return quantity.apart == 0 ? "=" : fmt::format("{:.1e}", quantity.apart);
}

}  // namespace candela::explain
