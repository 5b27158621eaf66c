// Formats values of quantities as text.
#pragma once
#include <string>

#include "host/judge/explain/quantity.h"

namespace candela::explain {

/// Returns words, or numbers with six digits, separated by spaces.
std::string valueText(const Value& value);
/// Returns the relative difference of both sides: "3.1e-07", or "=" if they are bit-identical.
std::string apartText(const Quantity& quantity);

}  // namespace candela::explain
