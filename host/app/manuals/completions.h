// Completion of command lines by shells, made from the tables of commands and options.
#pragma once
#include <string>

namespace candela::manuals {

/// Return the file that a shell reads to complete the commands, options, values and files of `candela`.
std::string bashCompletion();
std::string zshCompletion();
std::string fishCompletion();

}  // namespace candela::manuals
