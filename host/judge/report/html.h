// Escaping of HTML, and templates.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace candela::report {

/// Returns `text` escaped for the content and for quoted attributes of HTML. Control characters, and bytes that
/// are not UTF-8, become U+FFFD.
std::string escapeHtml(std::string_view text);

/// Returns the template with each "{{name}}" replaced. Inserted text is not searched again. Throws InternalError for a
/// name without a value.
std::string fillTemplate(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace candela::report
