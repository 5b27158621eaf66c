// The depth to which brackets are nested in JSON, found before it is parsed.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace candela {

/// Maximum depth of JSON in files. nlohmann's dump() and copies call themselves once per level.
inline constexpr std::size_t kMaxJsonDepth = 256;

/// Returns the offset of the first bracket that is nested more than kMaxJsonDepth levels deep, if there is one.
/// Brackets in strings do not count.
std::optional<std::size_t> findTooDeepJson(std::string_view text);

}  // namespace candela
