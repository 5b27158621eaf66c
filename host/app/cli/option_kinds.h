// The kinds of options in the option table: each function makes an Option from a field of a part of the arguments.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "host/app/cli/notation.h"
#include "host/app/cli/option_table.h"

namespace candela::cli {

/// The properties of an option besides its value.
struct Row {
  const char* names;
  OptionGroup group;
  std::string help;
};

// In each function, `get` maps a reference to `Part` to a reference to the field. All commands that have this part
// have the option, unless `kCommands` states fewer of them.

/// An option without notation, text of its default and functions.
template <class Part, unsigned kCommands>
Option emptyOption(const Row& row, std::string metavar, std::string expected) {
  static_assert((kCommands & ~commandsWith<Part>) == 0, "the arguments of a command lack the field of the option");
  return {row.names, kCommands, row.group, row.help, std::move(metavar), std::move(expected), "", {}, {}};
}

/// An option with a value.
template <class Part, unsigned kCommands = commandsWith<Part>, class T, class Get>
Option valued(const Row& row, const Notation<T>& notation, Get get) {
  Option option = emptyOption<Part, kCommands>(row, notation.metavar, notation.expected);
  option.words = notation.words;
  option.apply = [=](Arguments& arguments, const std::string& word) {
    const auto value = notation.parse(word);
    if (value) get(partOf<Part>(arguments)) = *value;
    return value.has_value();
  };
  option.show = [=](const Arguments& arguments) { return std::vector{notation.print(get(partOf<Part>(arguments)))}; };
  const Part defaults{};
  option.defaultText = notation.print(get(defaults));
  return option;
}

/// An option without a value.
template <class Part, unsigned kCommands = commandsWith<Part>, class Get>
Option flag(const Row& row, Get get) {
  Option option = emptyOption<Part, kCommands>(row, "", "no value");
  option.apply = [=](Arguments& arguments, const std::string& word) {
    get(partOf<Part>(arguments)) = true;
    return word == "true";  // value of CLI11 for a flag without a value
  };
  option.show = [=](const Arguments& arguments) {
    return std::vector<std::string>(get(partOf<Part>(arguments)) ? 1 : 0, "on");
  };
  return option;
}

/// A path without a default.
template <class Part, unsigned kCommands = commandsWith<Part>, class Get>
Option path(const Row& row, const char* metavar, Get get) {
  Option option = emptyOption<Part, kCommands>(row, metavar, "a path");
  option.apply = [=](Arguments& arguments, const std::string& word) {
    get(partOf<Part>(arguments)) = word;
    return !word.empty();
  };
  option.show = [=](const Arguments& arguments) { return std::vector{get(partOf<Part>(arguments)).string()}; };
  return option;
}

/// A list of words or paths; the option may be repeated.
template <class Part, unsigned kCommands = commandsWith<Part>, class Get>
Option list(const Row& row, const char* metavar, const char* expected, Get get) {
  Option option = emptyOption<Part, kCommands>(row, metavar, expected);
  option.apply = [=](Arguments& arguments, const std::string& word) {
    get(partOf<Part>(arguments)).emplace_back(word);
    return !word.empty();
  };
  option.show = [=](const Arguments& arguments) {
    const auto& all = get(partOf<Part>(arguments));
    return std::vector<std::string>(all.begin(), all.end());
  };
  return option;
}

/// Paths; the option may be repeated.
template <class Part, unsigned kCommands = commandsWith<Part>, class Get>
Option paths(const Row& row, const char* metavar, Get get) {
  return list<Part, kCommands>(row, metavar, "a path", get);
}

}  // namespace candela::cli
