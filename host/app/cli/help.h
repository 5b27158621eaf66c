// The texts of --help, made from the tables of options and commands.
#pragma once
#include <optional>
#include <string>

#include "host/app/cli/command_arguments.h"

namespace candela::cli {

inline constexpr std::size_t kMinHelpWidth = 80;
inline constexpr std::size_t kMaxHelpWidth = 100;

/// Returns usage, options and exit codes of one command, or of all commands (quoted in docs/command-line.md). Lines
/// have at most `width` columns, from kMinHelpWidth to kMaxHelpWidth.
std::string helpText(std::optional<Command> command, std::size_t width = kMaxHelpWidth);

/// Returns the width of the terminal that stdout is, within the limits; the maximum if stdout is no terminal.
std::size_t helpWidth();

}  // namespace candela::cli
