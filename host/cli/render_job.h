// A scene ready for rendering: the file is read, its settings are combined with the options, and limits are checked.
#pragma once
#include <memory>
#include <string>

#include "host/cli/arguments.h"
#include "host/core/log.h"
#include "host/core/progress.h"
#include "host/job/run_job.h"
#include "host/render/renderer.h"
#include "host/scene/load.h"
#include "host/scene/scene.h"

namespace candela::cli {

/// A job with the arguments of its command.
struct RenderJob : job::Job {
  Arguments arguments{};  ///< as the user gave them
  double parseSeconds = 0;
};

/// Reads the first of `arguments.files`, which must have a view. Warnings about the file go to the log. Throws
/// SceneError and FileError, and UsageError as requireUnread() does.
scene::LoadedScene readScene(const Arguments& arguments, const Log& log);

/// Combines options with a scene that has a view. Throws as resolveRequests() does.
RenderJob jobOf(const Arguments& arguments, std::shared_ptr<const scene::Scene> scene, const Log& log);

/// Reads the first of `arguments.files`. Throws as readScene() and jobOf() do.
RenderJob loadJob(const Arguments& arguments, const Log& log);

/// Returns the settings: those of the options, else of the scene file, else the defaults of the integrator. Throws
/// UsageError if the integrator cannot render the scene, FileError if the image exceeds the limits, and
/// OutOfMemoryError if film and scene do not fit into memory. Logs notes about options without effect and about missing
/// lights.
render::RenderSettings resolveRequests(const Arguments& arguments, const scene::Scene& scene, const Log& log);

/// Returns the options of a render of this job that no longer depend on the requests of the scene file.
Arguments statedArguments(const RenderJob& job);

/// Returns the reference for kReferenceDevice, else a Vulkan device, on which `auto` means the result of `candela tune`
/// unless --untuned is given. Throws NoDeviceError.
std::unique_ptr<render::Renderer> makeRenderer(const Arguments& arguments, const Log& log);
/// Returns the function that opens this device for job::runJob(), which is empty for the reference. It refers to both
/// arguments.
job::OpenDevice openDevice(const Arguments& arguments, const Log& log);

/// Reports progress on stderr; SIGINT and SIGTERM stop the render.
render::RenderControl makeControl(Progress& progress);

}  // namespace candela::cli
