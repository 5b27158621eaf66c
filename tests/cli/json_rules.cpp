#include "tests/cli/json_rules.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/core/version.h"

namespace candela {
namespace {

using nlohmann::ordered_json;

// The head stands before all other members.
void checkHead(const ordered_json& document, const std::string& schema, std::vector<std::string>& violations) {
  if (!document.is_object() || document.size() < 3) {
    violations.emplace_back("no object with a head and contents");
    return;
  }
  const auto first = document.begin();
  const auto second = std::next(first);
  if (first.key() != "schema" || *first != schema) violations.push_back("the first member is not the schema " + schema);
  if (second.key() != "version" || *second != versionText()) violations.emplace_back("the second is not the version");
}

}  // namespace

std::vector<std::string> violationsOf(const ordered_json& document, const std::string& schema) {
  std::vector<std::string> violations;
  checkHead(document, schema, violations);
  return violations;
}

}  // namespace candela
