// A scene ready for rendering: the file is read, its settings are combined with the options, and limits are checked.
#pragma once
#include <memory>
#include <string>

#include "host/app/cli/command_arguments.h"
#include "host/base/log.h"
#include "host/base/progress.h"
#include "host/formats/loading/load.h"
#include "host/job/run_job.h"
#include "host/scene/scene.h"
#include "host/trace/render/renderer.h"

namespace candela::cli {

/// A job with the options with which it is traced.
struct RenderJob : job::Job {
  TracingArguments arguments{};  ///< as the user gave them
  double parseSeconds = 0;
};

/// Logs the warnings about a scene that a command has read. Throws SceneError if it has no view, and UsageError as
/// requireUnread() does.
void acceptScene(const scene::LoadedScene& loaded, const Arguments& command, const Log& log);

/// Reads the first of the files of a command that reads scenes. It must have a view. Warnings about the file go to the
/// log. Throws SceneError and FileError, and UsageError as requireUnread() does.
scene::LoadedScene readScene(const Arguments& command, const Log& log);

/// Returns the settings of a render: those of the request, else of the scene, else the defaults of the integrator.
/// Throws as job::requirePossible() does.
render::RenderSettings resolveRequest(const render::RenderRequest& request, const scene::Scene& scene,
                                      const job::FilmPolicy& film, bool makesPictures, const Log& log);

/// Combines options with a scene that has a view. Logs notes about options without effect and about missing lights.
/// Throws as resolveRequest() does.
RenderJob jobOf(const TracingCommand& command, std::shared_ptr<const scene::Scene> scene, const Log& log);

/// Reads the first of the files of a command. Throws as readScene() and jobOf() do.
RenderJob loadJob(const TracingCommand& command, const Log& log);

/// Returns the options of a render of this job that no longer depend on the requests of the scene file.
RenderArguments statedArguments(const RenderJob& job);

/// Returns the reference for kReferenceDevice, else a Vulkan device, on which `auto` means the result of `candela tune`
/// unless --untuned is given. Throws NoDeviceError.
std::unique_ptr<render::Renderer> makeRenderer(const TracingArguments& arguments, const Log& log);
/// Returns the function that opens this device for job::runJob(), which is empty for the reference. It refers to both
/// arguments.
job::OpenDevice openDevice(const TracingArguments& arguments, const Log& log);

/// Reports progress on stderr; SIGINT and SIGTERM stop the render.
render::RenderControl makeControl(Progress& progress);

}  // namespace candela::cli
