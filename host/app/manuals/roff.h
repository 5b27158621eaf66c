// Text in roff, the language of manual pages.
#pragma once
#include <string>

namespace candela::manuals {
/// Returns text that roff prints literally: without requests and escapes, and with minus signs instead of hyphens.
std::string escaped(const std::string& text);

/// Returns escaped text in which words between backquotes are bold.
std::string withLiterals(const std::string& text);

}  // namespace candela::manuals
