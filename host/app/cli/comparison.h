// The kinds of `candela compare`.
#pragma once
#include "host/app/cli/command_arguments.h"
#include "host/base/errors.h"
#include "host/base/log.h"

namespace candela::cli {

/// Compares two image files: figures, pictures of the differences, and a verdict by tolerance or by statistics.
ExitCode compareImageFiles(const CompareArguments& arguments, const Log& log);
/// Tests whether two sets of renders show the same light.
ExitCode compareRenderSets(const CompareArguments& arguments, const Log& log);
/// Compares the device's image of a scene with the reference's, from equal random numbers.
ExitCode compareTracersOnScene(const CompareArguments& arguments, const Log& log);

}  // namespace candela::cli
