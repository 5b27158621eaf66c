// Bytes on stdout, and its failures.
#pragma once
#include <cstddef>
#include <span>

#include "host/base/errors.h"

namespace candela {

/// Stdout could not be written.
struct StdoutError : FileError {
  StdoutError() : FileError("cannot write to stdout") {}
};

/// Writes bytes to stdout. Throws StdoutError.
void writeStandardOutput(std::span<const std::byte> bytes);

/// Returns whether stdout is a pipe or socket that nobody reads any more, as after `candela ... | head`.
bool isStdoutAbandoned();

}  // namespace candela
