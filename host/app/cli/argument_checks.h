// Checks of arguments after they are parsed: numbers of files, and options that contradict each other or need others.
#pragma once
#include "host/app/cli/command_arguments.h"

namespace candela::cli {

/// Both throw UsageError. checkOptions() checks what also applies to arguments without files and outputs.
void checkArguments(const Arguments& arguments);
void checkOptions(const Arguments& arguments);

}  // namespace candela::cli
