// The rules of docs/json.md that hold for every JSON document of the program.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace candela {

/// Returns the violations of a document with the schema `schema`, each with its JSON pointer; nothing if there are
/// none.
std::vector<std::string> violationsOf(const nlohmann::ordered_json& document, const std::string& schema);

}  // namespace candela
