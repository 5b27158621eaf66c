// Writes reports as text.
#pragma once
#include <filesystem>
#include <initializer_list>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "host/app/cli/arguments.h"

namespace candela::cli {

/// Returns whether a command that writes these reports, each to a file, to stdout ("-") or nowhere, prints a text as
/// well.
bool wantsText(const GeneralArguments& arguments, std::initializer_list<std::string_view> reports);

/// Returns stdout, or stderr if one of these images is written to stdout.
std::ostream& textStream(std::span<const std::filesystem::path> images);

/// Writes `text` to a file, or to stdout if `target` is "-", or nowhere if it is empty. Throws FileError.
void writeText(const std::string& target, const std::string& text);

}  // namespace candela::cli
