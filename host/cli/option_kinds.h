// The kinds of options in the option table: each function makes an Option from a field of Arguments.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "host/cli/notation.h"
#include "host/cli/option_table.h"

namespace candela::cli {

/// The properties of an option besides its value.
struct Row {
  const char* names;
  unsigned commands;
  OptionGroup group;
  std::string help;
};

/// An option with a value. `get` maps Arguments& to a reference to its field.
template <class T, class Get>
Option valued(const Row& row, const Notation<T>& notation, Get get) {
  Option option{row.names, row.commands, row.group, row.help, notation.metavar, notation.expected, "", {}, {}};
  option.words = notation.words;
  option.apply = [=](Arguments& arguments, const std::string& word) {
    const auto value = notation.parse(word);
    if (value) get(arguments) = *value;
    return value.has_value();
  };
  option.show = [=](const Arguments& arguments) { return std::vector{notation.print(get(arguments))}; };
  const Arguments defaults;
  option.defaultText = notation.print(get(std::as_const(defaults)));
  return option;
}

/// An option without a value.
template <class Get>
Option flag(const Row& row, Get get) {
  Option option{row.names, row.commands, row.group, row.help, "", "no value", "", {}, {}};
  option.apply = [=](Arguments& arguments, const std::string& word) {
    get(arguments) = true;
    return word == "true";  // value of CLI11 for a flag without a value
  };
  option.show = [=](const Arguments& arguments) { return std::vector<std::string>(get(arguments) ? 1 : 0, "on"); };
  return option;
}

/// A path without a default.
template <class Get>
Option path(const Row& row, const char* metavar, Get get) {
  Option option{row.names, row.commands, row.group, row.help, metavar, "a path", "", {}, {}};
  option.apply = [=](Arguments& arguments, const std::string& word) {
    get(arguments) = word;
    return !word.empty();
  };
  option.show = [=](const Arguments& arguments) { return std::vector{get(arguments).string()}; };
  return option;
}

/// A list of words or paths; the option may be repeated.
template <class Get>
Option list(const Row& row, const char* metavar, const char* expected, Get get) {
  Option option{row.names, row.commands, row.group, row.help, metavar, expected, "", {}, {}};
  option.apply = [=](Arguments& arguments, const std::string& word) {
    get(arguments).emplace_back(word);
    return !word.empty();
  };
  option.show = [=](const Arguments& arguments) {
    const auto& all = get(arguments);
    return std::vector<std::string>(all.begin(), all.end());
  };
  return option;
}

/// Paths; the option may be repeated.
template <class Get>
Option paths(const Row& row, const char* metavar, Get get) {
  return list(row, metavar, "a path", get);
}

}  // namespace candela::cli
