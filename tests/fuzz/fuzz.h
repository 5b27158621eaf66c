// Common parts of the targets. A target calls one reader with any bytes, like the program: expected errors are caught,
// and everything else is a fault.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "host/base/errors.h"

namespace candela::fuzz {

using Input = std::span<const std::uint8_t>;

/// Runs one input. Each target defines it.
void run(Input input);

inline std::string textOf(Input input) { return {reinterpret_cast<const char*>(input.data()), input.size()}; }

/// A file in memory with these bytes, for readers that take a path. It is rewritten by each call.
std::filesystem::path fileOf(Input input);

/// Calls `f`, and ignores the errors that it may throw.
template <class F>
void expectErrors(F&& f) {
  try {
    f();
  } catch (const Error&) {
  }
}

}  // namespace candela::fuzz
