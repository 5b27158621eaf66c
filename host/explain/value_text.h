// Quantities as text.
#pragma once
#include <string>

#include "host/explain/quantity.h"

namespace candela::explain {

/// Words, or numbers to six digits with spaces between them.
std::string valueText(const Value& value);
/// How far apart the two sides' numbers are: "3.1e-07", or "=" if they are equal to the bit.
std::string apartText(const Quantity& quantity);

}  // namespace candela::explain
