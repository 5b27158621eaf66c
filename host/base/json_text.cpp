// Parses and writes JSON with nlohmann's library.
#include "host/base/json_text.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>

namespace candela {
namespace {

template <class Json>
std::string textOf(const Json& json, int indent, bool isAscii) {
  return json.dump(indent, ' ', isAscii, Json::error_handler_t::replace);
}

/// Returns the offset of the first bracket that is nested more than kMaxJsonDepth levels deep, if there is one.
/// Brackets in strings do not count.
std::optional<std::size_t> findTooDeep(std::string_view text) {
  std::size_t depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (inString) {
      if (c == '\\') ++i;
      inString = c != '"';
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      if (++depth > kMaxJsonDepth) return i;
    } else if ((c == '}' || c == ']') && depth > 0) {
      --depth;
    }
  }
  return std::nullopt;
}

/// Returns the part of nlohmann's message that describes the error, without "[...] parse error at line 1, column 2: ".
/// It quotes the text, whose bytes need not be characters.
std::string reasonOf(std::string_view what) {
  const std::size_t start = what.find(": ");
  if (start != std::string_view::npos) what.remove_prefix(start + 2);
  constexpr std::size_t kMaxReason = 200;
  std::string shown;
  for (const char c : what.substr(0, kMaxReason)) shown += c < 0x20 || c > 0x7e ? '?' : c;
  return shown;
}

/// The offset of a number that is too large for a double. nlohmann's message quotes it and lacks its place.
std::size_t offsetOfNumber(std::string_view text, std::string_view what) {
  const std::size_t end = what.rfind('\'');
  const std::size_t start = end == std::string_view::npos ? end : what.rfind('\'', end - 1);
  if (start == std::string_view::npos) return 0;
  const std::size_t offset = text.find(what.substr(start + 1, end - start - 1));
  return offset == std::string_view::npos ? 0 : offset;
}

}  // namespace

JsonSyntaxError::JsonSyntaxError(std::string_view text, std::size_t offset, const std::string& message)
    : FileError(message) {
  const std::string_view before = text.substr(0, std::min(offset, text.size()));
  line = static_cast<std::size_t>(std::ranges::count(before, '\n')) + 1;
  column = before.size() - (before.rfind('\n') + 1) + 1;
}

nlohmann::json parseJson(std::string_view text) {
  if (const std::optional<std::size_t> offset = findTooDeep(text)) {
    throw JsonSyntaxError(text, *offset, "JSON is nested more than " + std::to_string(kMaxJsonDepth) + " levels deep");
  }
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw JsonSyntaxError(text, error.byte > 0 ? error.byte - 1 : 0, "not valid JSON: " + reasonOf(error.what()));
  } catch (const nlohmann::json::exception& error) {
    throw JsonSyntaxError(text, offsetOfNumber(text, error.what()), "not valid JSON: number overflow");
  }
}

std::string jsonText(const nlohmann::ordered_json& json, int indent) { return textOf(json, indent, false); }
std::string jsonText(const nlohmann::json& json, int indent) { return textOf(json, indent, false); }
std::string asciiJsonText(const nlohmann::ordered_json& json) { return textOf(json, -1, true); }

}  // namespace candela
