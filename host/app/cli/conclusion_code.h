// The exit code of a verdict.
#pragma once
#include "host/app/cli/arguments.h"
#include "host/base/errors.h"
#include "host/judge/verify/conclusion.h"

namespace candela::cli {

/// Returns ExitCode::undecided for a verdict that is not decided, unless --allow-undecided makes it a success.
inline ExitCode exitCodeOf(verify::Conclusion conclusion, const VerdictArguments& arguments) {
  if (conclusion == verify::Conclusion::different) return ExitCode::differ;
  const bool isOpen = conclusion == verify::Conclusion::undecided && !arguments.allowUndecided;
  return isOpen ? ExitCode::undecided : ExitCode::done;
}

}  // namespace candela::cli
