// Accesses at and beyond the end of buffers, on a device with robustBufferAccess.
#pragma once
#include <cstdint>
#include <span>

#include "host/drivers/conformance/case.h"

namespace candela::conformance {

struct BoundsRow {
  const char* name;
  std::uint32_t function;  ///< kFunction of shaders/conformance/bounds.comp
  std::uint32_t elements;  ///< of the array that is accessed
};

std::span<const BoundsRow> boundsRows();

/// Creates the pipeline of runBounds().
Finding compileBounds(const BoundsRow& row, const Workbench& workbench);

/// Reads within a buffer give its content, and others give 0 or some word of the buffer. Writes beyond the buffer
/// change no other buffer.
Finding runBounds(const BoundsRow& row, const Workbench& workbench);

}  // namespace candela::conformance
