// HTML as text: escaping, and templates.
#pragma once
#include <map>
#include <string>
#include <string_view>

namespace candela::report {

/// `text` as it appears in HTML, in content and in quoted attributes alike; control characters become U+FFFD.
std::string escapeHtml(std::string_view text);

/// The template with each "{{name}}" replaced. What is inserted is not looked at again. Throws InternalError for a name
/// that has no value.
std::string fillTemplate(std::string_view text, const std::map<std::string, std::string, std::less<>>& values);

}  // namespace candela::report
