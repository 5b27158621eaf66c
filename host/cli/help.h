// The texts of --help, made from the tables of options and commands.
#pragma once
#include <optional>
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {

/// Returns usage, options and exit codes of one command, or of all commands (quoted in docs/command-line.md). Lines
/// have at most 100 columns.
std::string helpText(std::optional<Command> command);

}  // namespace candela::cli
