// Scenes in Python.
#pragma once
#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "host/cli/render_job.h"
#include "host/python/python_log.h"

namespace candela::python {

/// A scene with the options with which it was read, which films record. Renders share it.
struct PythonScene {
  std::shared_ptr<const scene::Scene> scene;
  cli::Arguments loading;                    ///< files, loadOptions and the names of these options
  std::string report;                        ///< JSON, as `candela check` writes it
  std::vector<std::filesystem::path> files;  ///< that were read: the scene's own, and those that it names

  /// Returns `arguments` with the file and the options of the scene.
  cli::Arguments complete(cli::Arguments arguments) const;
  cli::RenderJob jobOf(const cli::Arguments& arguments, const Log& log) const;
};

void defineScene(pybind11::module_& module);

}  // namespace candela::python
