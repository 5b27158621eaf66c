// Notes about options that have no effect on a render.
#pragma once
#include "host/cli/arguments.h"
#include "host/core/log.h"

namespace candela::cli {
/// Logs a note for each option that is given although this render does not read it. Such options cause a note rather
/// than an error, so that one command line can be used for all renders.
void noteIdleOptions(const Arguments& arguments, const Log& log);
/// Logs a note if --background none makes alpha that no output file can store.
void noteLostAlpha(const Arguments& arguments, const Log& log);

}  // namespace candela::cli
