// Unpacks the records that the replay kernel writes.
#pragma once
#include "host/trace/render/path_trace.h"
#include "shaders/shared/trace_rows.h"

namespace candela::device {

render::PathTrace unpackTrace(const gpu::TracedSample& rows);

}  // namespace candela::device
