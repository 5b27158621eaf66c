// Manual pages, made from the tables of commands and options.
#pragma once
#include <optional>
#include <string>

#include "host/app/cli/command_arguments.h"

namespace candela::manuals {

/// Returns "candela-verify" for a command, "candela" for none.
std::string pageName(std::optional<cli::Command> command);

/// Returns the page of a command, or of the program with a list of its commands, in the man macros of roff.
std::string manualPage(std::optional<cli::Command> command);

}  // namespace candela::manuals
