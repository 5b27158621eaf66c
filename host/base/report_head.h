// The head of every JSON document that the program prints: docs/json.md.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace candela {

/// Returns an object with `schema`, e.g. "candela-verify/2", and the version of the program. The number of a schema
/// grows if a member changes its name or meaning, or disappears.
nlohmann::ordered_json reportHead(const std::string& schema);

}  // namespace candela
