// The two sides of `candela compare`.
#pragma once
#include "host/cli/arguments.h"
#include "host/core/errors.h"
#include "host/core/log.h"

namespace candela::cli {

/// Two image files: figures, pictures of the differences, and a verdict if a tolerance was given.
ExitCode compareImageFiles(const Arguments& arguments, const Log& log);
/// One scene: the device's image against the reference's, from equal random numbers.
ExitCode compareTracersOnScene(const Arguments& arguments, const Log& log);

}  // namespace candela::cli
