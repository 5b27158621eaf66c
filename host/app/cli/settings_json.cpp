// Converts the values of options to JSON.
#include "host/app/cli/settings_json.h"

#include <cctype>
#include <nlohmann/json.hpp>

namespace candela::cli {

using nlohmann::ordered_json;

std::string settingKey(const std::string& name) {
  const std::string words = name.starts_with("--") ? name.substr(2) : name;
  if (words == "spp") return "samplesPerPixel";
  std::string key;
  bool raise = false;
  for (const char character : words) {
    if (character != '-') key += raise ? static_cast<char>(std::toupper(character)) : character;
    raise = character == '-';
  }
  return key;
}

ordered_json settingValue(const Option& option, const std::vector<std::string>& words) {
  if (option.isFlag()) return !words.empty();
  if (words.size() != 1) return words;
  if (!option.isValue(words[0])) return nullptr;
  const ordered_json number = ordered_json::parse(words[0], nullptr, false);
  return number.is_number() ? number : ordered_json(words[0]);
}

}  // namespace candela::cli
