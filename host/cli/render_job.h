// A scene that is ready to be traced: read, its requests and the command line joined, its limits checked.
#pragma once
#include <memory>
#include <string>

#include "host/cli/arguments.h"
#include "host/core/log.h"
#include "host/core/progress.h"
#include "host/render/renderer.h"
#include "host/scene/scene.h"

namespace candela::cli {

struct RenderJob {
  Arguments arguments;  ///< with nothing left to the file
  render::RenderSettings settings;
  scene::Scene scene;
  double parseSeconds = 0;
};

/// Reads the first of `arguments.files`; the file's warnings go to the log. Throws SceneError, FileError and
/// OutOfMemoryError (a film larger than the machine's memory).
RenderJob loadJob(const Arguments& arguments, const Log& log);

/// What must hold before a render of resolved arguments begins: an image within the limits (else FileError) whose film
/// fits into memory (else OutOfMemoryError). Says in the log which options change nothing, and what will be dark.
void requirePossible(const Arguments& arguments, const scene::Scene& scene, const Log& log);

/// The file's requests, and what the integrator defaults to, take the place of options that are absent.
void resolveRequests(Arguments& arguments, const scene::Scene& scene, const Log& log);

/// "cpu": the reference; everything else: a Vulkan device, on which `auto` means what `candela tune` found, unless the
/// arguments have it otherwise. Throws NoDeviceError.
std::unique_ptr<render::Renderer> makeRenderer(const Arguments& arguments, const Log& log);

/// Progress on stderr; SIGINT and SIGTERM stop.
render::RenderControl makeControl(Progress& progress);

/// Throws, since the image would be wrong, if work was truncated: FileError where a scene's grid is too much for the
/// device's loops, InternalError elsewhere.
void requireComplete(const render::RenderStatistics& statistics);

}  // namespace candela::cli
