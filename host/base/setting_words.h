// How messages name a setting: as an option of the command line, as a keyword of Python, or by its plain name.
#pragma once
#include <string>
#include <string_view>

namespace candela {

/// Returns a setting, e.g. "spp" or "max-depth", and its value, unless that is empty, as the user writes them:
/// "max-depth" and "max-depth = 4", unless the front end has set other words. Libraries use it for the remedy in a
/// message, so that one sentence helps the users of every front end.
std::string settingWords(std::string_view name, std::string_view value = "");

using SettingWords = std::string (*)(std::string_view name, std::string_view value);
/// Sets the words of this process. A front end calls it once, before it starts threads.
void setSettingWords(SettingWords words);

}  // namespace candela
