// Escapes HTML and expands templates.
#include "host/judge/report/html.h"

#include "host/base/errors.h"
#include "host/base/markup.h"

namespace candela::report {
namespace {

bool isInvisible(char32_t code) { return (code < 0x20 && code != '\n' && code != '\t') || code == 0x7f; }

}  // namespace

std::string escapeHtml(std::string_view text) { return escaped(text, kReplacementCharacter, isInvisible); }

std::string fillTemplate(std::string_view text, const std::map<std::string, std::string, std::less<>>& values) {
  std::string out;
  for (;;) {
    const std::size_t open = text.find("{{");
    const std::size_t close = text.find("}}", open);
    if (open == std::string_view::npos || close == std::string_view::npos) return out.append(text);
    const auto value = values.find(text.substr(open + 2, close - open - 2));
    if (value == values.end()) {
      throw InternalError("a template without a value for " + std::string(text.substr(open, close + 2 - open)));
    }
    out.append(text.substr(0, open)).append(value->second);
    text.remove_prefix(close + 2);
  }
}

}  // namespace candela::report
