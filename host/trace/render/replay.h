// Samples of a session that are traced again, one at a time.
#pragma once
#include "host/trace/render/path_trace.h"
#include "host/trace/render/statistics.h"

namespace candela::render {

/// One sample that was traced again.
struct Replay {
  PathTrace path;
  RenderStatistics statistics;  ///< device, driver, structure, and whether work was truncated
};

/// Traces samples of a session again, without adding them to its film: Session::replayer().
class SampleReplayer {
 public:
  /// Traces the sample that advance() adds, bit for bit. The pixel must be within the image. Throws as
  /// Session::advance() does if the device fails.
  virtual Replay replay(const PixelSample& sample) = 0;

 protected:
  ~SampleReplayer() = default;
};

}  // namespace candela::render
