// Failures of stdout.
#pragma once
#include "host/core/errors.h"

namespace candela {

/// Stdout could not be written.
struct StdoutError : FileError {
  StdoutError() : FileError("cannot write to stdout") {}
};

/// Returns whether stdout is a pipe or socket that nobody reads any more, as after `candela ... | head`.
bool isStdoutAbandoned();

}  // namespace candela
