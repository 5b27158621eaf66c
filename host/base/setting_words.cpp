// Keeps the words of the front end.
#include "host/base/setting_words.h"

#include <fmt/format.h>

namespace candela {
namespace {

std::string plainWords(std::string_view name, std::string_view value) {
  return value.empty() ? std::string(name) : fmt::format("{} = {}", name, value);
}

SettingWords spelling = &plainWords;

}  // namespace

std::string settingWords(std::string_view name, std::string_view value) { return spelling(name, value); }

void setSettingWords(SettingWords chosen) { spelling = chosen; }

}  // namespace candela
