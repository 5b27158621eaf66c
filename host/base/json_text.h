// JSON as text, with one limit of depth and one form of errors for all files. The parser and the serialiser of the JSON
// library take seconds to compile in each library that calls them.
#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "host/base/errors.h"

namespace candela {

/// Maximum depth to which brackets may be nested. Copies and texts of values are made by functions that call themselves
/// once per level.
inline constexpr std::size_t kMaxJsonDepth = 256;

/// A text is not JSON, or it is nested too deeply. `what()` is one line of ASCII without the place, such as "not valid
/// JSON: syntax error while parsing value".
struct JsonSyntaxError : FileError {
  JsonSyntaxError(std::string_view text, std::size_t offset, const std::string& message);

  std::size_t line = 1;    ///< from 1
  std::size_t column = 1;  ///< in bytes, from 1
};

/// Throws JsonSyntaxError. Keys of objects are sorted.
nlohmann::json parseJson(std::string_view text);

/// Returns the text of a value: one line, or with `indent` >= 0 lines that are indented by `indent` spaces per level.
/// Bytes of strings that are not UTF-8, which names of files and of drivers may have, become U+FFFD.
std::string jsonText(const nlohmann::ordered_json& json, int indent = -1);
std::string jsonText(const nlohmann::json& json, int indent = -1);

/// The same as one line in which characters beyond ASCII are escaped.
std::string asciiJsonText(const nlohmann::ordered_json& json);

}  // namespace candela
