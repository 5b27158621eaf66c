// Renders of one image and of a sequence of frames: `candela render`.
#pragma once
#include <functional>

#include "host/app/cli/command_arguments.h"
#include "host/app/cli/render_job.h"
#include "host/base/errors.h"
#include "host/base/log.h"
#include "host/job/run_job.h"

namespace candela::cli {

/// The steps in which a frame of a sequence differs from a single image.
struct RenderSteps {
  std::function<RenderJob(const RenderArguments&)> load;
  std::function<job::JobResult(const RenderJob&, const job::JobControl&)> trace;
  /// Returns whether nothing is left to do for a job; may be empty.
  std::function<bool(const RenderArguments&, const RenderJob&)> isDone{};
  job::JobControl control{};  ///< without flags, which renderImage() sets
  bool isFrame = false;       ///< interrupted renders write no picture, and the summary is a detail
};

/// Renders one image. Throws as the steps do.
ExitCode renderImage(const RenderArguments& arguments, const RenderSteps& steps, const Log& log);

/// Renders the frames of a sequence one after the other, until one of them fails: its exit code is that of the
/// sequence. Throws as renderImage() does, and FileError if another process renders frames of this sequence.
ExitCode renderSequence(const RenderArguments& arguments, const Log& log);

}  // namespace candela::cli
