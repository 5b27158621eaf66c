// The settings of films in the notation of the command line.
#pragma once
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

namespace candela::cli {

/// Returns the option that gives a setting of FilmHeader::settings its value, e.g. "--max-depth 4" or "--one-sided".
/// Returns nothing if the setting has the default of the option, or if no option gives it.
std::optional<std::string> optionOf(const std::string& name, const std::string& value);

/// Returns the settings of a film as reports of renders have them: see settingValue().
nlohmann::ordered_json settingsJson(const std::map<std::string, std::string>& settings);

}  // namespace candela::cli
