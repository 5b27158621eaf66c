// The words that shells complete: of commands, options and values.
#pragma once
#include <string>
#include <vector>

#include "host/app/cli/commands.h"
#include "host/app/cli/option_table.h"

namespace candela::manuals {

enum class ValueKind { none, words, file, folder, other };

/// Returns the kind of value that follows an option.
ValueKind valueKind(const cli::Option& option);

/// Returns the values of an option whose metavar lists them, such as "on|off"; else none.
std::vector<std::string> valuesOf(const cli::Option& option);

/// Returns the names of an option with their dashes.
std::vector<std::string> namesOf(const cli::Option& option);

/// Returns the words that may be the first argument of a command, such as the kinds of `generate`. If there are none,
/// it is a file.
std::vector<std::string> firstArguments(cli::Command command);

/// Joins words by spaces.
std::string joined(const std::vector<std::string>& words);

}  // namespace candela::manuals
