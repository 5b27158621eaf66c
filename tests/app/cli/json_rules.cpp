// Checks documents by the rules of docs/json.md.
#include "tests/app/cli/json_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>

#include "host/base/version.h"

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

// The keys of these objects are data: results of cases, labels of facts, numbers of samples.
const std::set<std::string> kTables{"counts", "facts", "halfRegions"};

bool matches(const std::string& text, const char* pattern) { return std::regex_match(text, std::regex(pattern)); }

bool hasMembers(const ordered_json& object, const std::vector<const char*>& keys) {
  return object.is_object() && std::ranges::all_of(keys, [&](const char* key) { return object.contains(key); });
}

bool isBadSamples(const ordered_json& value) {
  const auto isTally = [](const ordered_json& side) { return hasMembers(side, {"samples", "pixels", "firstPixels"}); };
  return isTally(value) || (value.is_object() && value.size() == 2 && std::ranges::all_of(value, isTally));
}

bool isNumberOrNull(const ordered_json& value) { return value.is_number() || value.is_null(); }

// Returns why a member breaks a rule about names or about values of such a name; empty if it does not.
std::string complaintAbout(const std::string& key, const ordered_json& value) {
  if (!matches(key, "[a-z][a-zA-Z0-9]*")) return "the key is not in camelCase";
  if (matches(key, ".*(Ms|Share)|(maximum|minimum|most|least|fewest|is)[A-Z].*|spp")) return "the name breaks a rule";
  if (value.is_boolean() && matches(key, "agree|equal|pass|met|expected|differs|regressed|same.*|.*Works")) {
    return "a verdict is called agrees";
  }
  if (key == "agrees" && !value.is_boolean() && !value.is_null()) return "it is neither a Boolean nor null";
  if (key == "badSamples" && !isBadSamples(value)) return "it has another form";
  if (key == "interrupted" && !value.is_boolean()) return "it is not a Boolean";
  if (key == "phaseSeconds" && !value.is_object()) return "it is not an object";
  if (key != "phaseSeconds" && matches(key, "seconds|.*(Seconds|Bytes|Fraction)") && !isNumberOrNull(value)) {
    return "it is not a number";
  }
  if (key == "size" && !matches(value.dump(), "\"[0-9]+x[0-9]+\"|null")) return "it is not WIDTHxHEIGHT";
  if (key == "window" && !matches(value.dump(), "\"([0-9]+,){3}[0-9]+\"")) return "it is not X,Y,WIDTH,HEIGHT";
  if (matches(key, "(scene|film)Hash") && !matches(value.dump(), "\"[0-9a-f]{16}\"")) return "it is not a hash";
  return "";
}

void checkMembers(const ordered_json& value, const std::string& pointer, std::vector<std::string>& violations) {
  for (const auto& [key, member] : value.items()) {
    const std::string place = pointer + "/" + key;
    if (value.is_object()) {
      if (const std::string why = complaintAbout(key, member); !why.empty()) violations.push_back(place + ": " + why);
    }
    if (!kTables.contains(key) && member.is_structured()) checkMembers(member, place, violations);
  }
  if (value.is_object() && value.contains("x") != value.contains("y")) violations.push_back(pointer + ": x without y");
}

// The inputs of the tests have no names with spaces, so that a value with a space is text of the help.
void checkSettings(const ordered_json& document, std::vector<std::string>& violations) {
  if (!document.contains("settings")) return;
  for (const auto& [key, value] : document["settings"].items()) {
    if (value.is_string() && value.get<std::string>().find(' ') != std::string::npos) {
      violations.push_back(fmt::format("/settings/{}: prose as a value: {}", key, value.get<std::string>()));
    }
  }
}

}  // namespace

std::vector<std::string> violationsOf(const ordered_json& document, const std::string& schema) {
  std::vector<std::string> violations;
  checkHead(document, schema, violations);
  checkMembers(document, "", violations);
  checkSettings(document, violations);
  return violations;
}

}  // namespace candela
