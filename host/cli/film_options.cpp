// Writes settings of films as options.
#include "host/cli/film_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "host/cli/option_table.h"
#include "host/cli/settings_json.h"

namespace candela::cli {

using nlohmann::ordered_json;

namespace {

constexpr const char* kAntialiasing = "antialiasing";  // a setting of films that --spp 0 gives
constexpr const char* kAccel = "accel";  // describes the acceleration structure, and begins with the value of --accel

const Option* settingNamed(const std::string& name) { return findOption(Command::render, "--" + name); }

bool isAbsent(const Option& option, const std::string& value) { return value.empty() || option.isDefault(value); }

// The changes that make the settings of a render those of a film.
struct Changes {
  std::vector<std::string> added;
  std::vector<std::string> removed;

  void adopt(const std::string& name, const std::string& value) {
    const Option* const option = settingNamed(name);
    if (const std::optional<std::string> words = optionOf(name, value)) {
      added.push_back(*words);
    } else if (option != nullptr && isAbsent(*option, value)) {
      removed.push_back(option->name());
    }
  }
};

// Films without a description of the structure do not depend on it.
void adoptStructure(const std::string& film, const std::string& render, Changes& changes) {
  const std::string kind = film.substr(0, film.find(' '));
  if (!film.empty() && kind != render.substr(0, render.find(' '))) changes.added.push_back("--accel " + kind);
}

}  // namespace

std::optional<std::string> optionOf(const std::string& name, const std::string& value) {
  if (name == kAntialiasing) return value == "off" ? std::optional<std::string>("--spp 0") : std::nullopt;
  const Option* const option = settingNamed(name);
  if (option == nullptr || isAbsent(*option, value)) return std::nullopt;
  if (option->isFlag()) return option->name();
  Arguments scratch;
  if (!option->apply(scratch, value)) return std::nullopt;
  return fmt::format("{} {}", option->name(), shellQuoted(value));
}

ordered_json settingsJson(const std::map<std::string, std::string>& settings) {
  ordered_json json = ordered_json::object();
  for (const auto& [name, value] : settings) {
    const Option* const option = settingNamed(name);
    ordered_json& member = json[settingKey(name)];
    if (name == kAntialiasing) {
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

std::string stepsToResume(const film::FilmHeader& film, const film::FilmHeader& render) {
  Changes changes;
  if (film.size != render.size) changes.added.push_back("--size " + render::extentText(film.size));
  if (film.seed != render.seed) changes.added.push_back(fmt::format("--seed {}", film.seed));
  std::map<std::string, std::string> names = film.settings;
  names.insert(render.settings.begin(), render.settings.end());
  for (const auto& [name, ignored] : names) {
    const std::string value = film.setting(name);
    if (value == render.setting(name)) continue;
    if (name == kAccel) {
      adoptStructure(value, render.setting(name), changes);
    } else if (name == kAntialiasing && value.empty()) {
      changes.added.push_back(fmt::format("--spp {}", film.samplesPerPixel));
    } else {
      changes.adopt(name, value);
    }
  }
  std::vector<std::string> steps;
  if (!changes.added.empty()) steps.push_back(fmt::format("use {}", fmt::join(changes.added, " ")));
  if (!changes.removed.empty()) steps.push_back(fmt::format("leave out {}", fmt::join(changes.removed, " and ")));
  return fmt::format("{}", fmt::join(steps, ", and "));
}

}  // namespace candela::cli
