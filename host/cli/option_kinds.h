// The kinds of rows that the option table has: each makes an Option from a field of Arguments.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "host/cli/notation.h"
#include "host/cli/option_table.h"

namespace candela::cli {

/// What is said of an option beside its value.
struct Row {
  const char* names;
  unsigned commands;
  OptionGroup group;
  const char* help;
};

/// An option with a value. `get` maps Arguments& to its field, a reference.
template <class T, class Get>
Option valued(const Row& row, const Notation<T>& notation, Get get) {
  Option option{row.names, row.commands, row.group, row.help, notation.metavar, notation.expected, "", {}, {}};
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
    return word == "true";  // what CLI11 gives for a flag without a value
  };
  option.show = [=](const Arguments& arguments) { return std::vector<std::string>(get(arguments) ? 1 : 0, "on"); };
  return option;
}

/// A path, with no default.
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

/// The same for an option that may be given several times.
template <class Get>
Option paths(const Row& row, const char* metavar, Get get) {
  Option option{row.names, row.commands, row.group, row.help, metavar, "a path", "", {}, {}};
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

}  // namespace candela::cli
