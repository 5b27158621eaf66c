// The values of options in JSON documents.
#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "host/app/cli/option_table.h"

namespace candela::cli {

/// Returns the key of an option: "maxDepth" for "--max-depth" or "max-depth", and "samplesPerPixel" for "--spp".
std::string settingKey(const std::string& name);

/// Returns the value of an option that has `words`, as Option::show() returns them: a Boolean, a number, a text, a list
/// of several texts, or null if the option has no value.
nlohmann::ordered_json settingValue(const Option& option, const std::vector<std::string>& words);

}  // namespace candela::cli
