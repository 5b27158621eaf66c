// Writes settings of films as options.
#include "host/app/cli/film_options.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/app/cli/option_table.h"
#include "host/app/cli/settings_json.h"
#include "host/job/film_identity.h"

namespace candela::cli {

using nlohmann::ordered_json;

namespace {

const Option* settingNamed(const std::string& name) { return findOption(Command::render, "--" + name); }

bool isAbsent(const Option& option, const std::string& value) { return value.empty() || option.isDefault(value); }

}  // namespace

std::optional<std::string> optionOf(const std::string& name, const std::string& value) {
  if (name == job::kAntialiasing) return value == "off" ? std::optional<std::string>("--spp 0") : std::nullopt;
  const Option* const option = settingNamed(name);
  if (option == nullptr || isAbsent(*option, value)) return std::nullopt;
  if (option->isFlag()) return option->name();
  Arguments scratch = RenderArguments();
  if (!option->apply(scratch, value)) return std::nullopt;
  return fmt::format("{} {}", option->name(), shellQuoted(value));
}

ordered_json settingsJson(const std::map<std::string, std::string>& settings) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : settings) {
    const Option* const option = settingNamed(name);
    ordered_json& member = json[settingKey(name)];
    if (name == job::kAntialiasing) {
      member = value != "off";
    } else if (option == nullptr) {
      member = value;
    } else {
      const bool isUnset = option->isFlag() && option->isDefault(value);
      member = settingValue(*option, isUnset ? std::vector<std::string>{} : std::vector{value});
    }
  }
  return json;
}

}  // namespace candela::cli
