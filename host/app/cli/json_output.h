// Writes JSON reports.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace candela::cli {

/// Writes `json`, indented, to a file, or to stdout if `target` is "-", or nowhere if it is empty. Throws FileError.
void writeJson(const std::string& target, const nlohmann::ordered_json& json);

}  // namespace candela::cli
