// Scenes in Python.
#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <mutex>
#include <string>

#include "host/app/cli/render_job.h"
#include "host/app/python/python_log.h"
#include "host/formats/loading/load.h"

namespace candela::python {

/// A scene with the options with which it was read, which films record. Renders share it.
class PythonScene {
 public:
  PythonScene(scene::LoadedScene loaded, cli::SceneArguments arguments);

  std::shared_ptr<const scene::Scene> scene;
  cli::SceneArguments loading;  ///< files, loadOptions and the names of these options

  /// Files that were read: the scene's own, and those that it names.
  const std::vector<std::filesystem::path>& files() const { return loaded_->files; }
  /// Returns JSON, as `candela check` writes it. The first call computes it, without the GIL, since that takes a second
  /// for millions of triangles.
  pybind11::object report() const;
  /// Returns the job of a command with the file and the options of the scene.
  cli::RenderJob jobOf(cli::TracingCommand command, const Log& log) const;

 private:
  std::shared_ptr<const scene::LoadedScene> loaded_;
  mutable std::once_flag isReported_;
  mutable std::string report_;
};

void defineScene(pybind11::module_& module);

}  // namespace candela::python
