// Escapes characters that roff interprets.
#include "host/app/manuals/roff.h"

namespace candela::manuals {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char character : text) {
    if (character == '\\') {
      out += "\\e";
    } else if (character == '-') {
      out += "\\-";
    } else {
      out += character;
    }
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string withLiterals(const std::string& text) {
  std::string out;
  bool isLiteral = false;
  for (const char character : escaped(text)) {
    if (character == '`') {
      isLiteral = !isLiteral;
      out += isLiteral ? "\\fB" : "\\fR";
    } else {
      out += character;
    }
  }
  return out;
}

}  // namespace candela::manuals
