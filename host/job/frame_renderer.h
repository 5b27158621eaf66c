// Renders jobs one after the other, and prepares again only what differs between them.
#pragma once
#include <memory>

#include "host/job/run_job.h"

namespace candela::job {

/// Runs the jobs of a sequence. The device is opened once, and its pipelines stay. If the scene and the settings of a
/// job differ from those of the job before at most in camera and seed, the session stays, too: nothing is built or
/// uploaded again. After a failure of the device, everything is prepared again.
class FrameRenderer {
 public:
  /// `open` is that of runJob(); what it refers to must outlive this object.
  explicit FrameRenderer(OpenDevice open);
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;
  ~FrameRenderer();

  /// Returns what runJob() returns, with the same film, bit for bit, and throws as it does. The times of what was
  /// prepared for an earlier job are 0 in the statistics.
  JobResult run(const Job& job, const JobControl& control, const Log& log);

 private:
  class Kept;

  OpenDevice open_;
  std::unique_ptr<Kept> device_, reference_;
};

}  // namespace candela::job
