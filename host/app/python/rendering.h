// Renders in Python.
#pragma once
#include <pybind11/pybind11.h>

#include "host/app/cli/render_job.h"
#include "host/app/python/python_film.h"
#include "host/app/python/python_scene.h"
#include "host/job/film/work_report.h"

namespace candela::python {

/// Returns the job of a render. With denoise=True, its film gets the sums that the denoiser needs. Throws as
/// PythonScene::jobOf() and cli::requireDenoisable() do.
cli::RenderJob renderJobOf(const PythonScene& scene, const cli::RenderArguments& arguments, const Log& log);

/// Returns the film of a render of a scene that has read `files`, with its report, and logs its warnings.
std::shared_ptr<PythonFilm> filmOf(const cli::RenderJob& job, const cli::RenderArguments& arguments,
                                   std::vector<std::filesystem::path> files, render::RenderResult result,
                                   film::FilmHeader header, const film::WorkReport& work, double seconds,
                                   const Log& log);
/// Throws UsageError as cli::requireSeparateFiles() and cli::requireUnread() do, for outputs beside files that were
/// read.
void requireSeparate(cli::RenderArguments arguments, const std::vector<std::filesystem::path>& files);

/// Defines render().
void defineRender(pybind11::module_& module);
/// Defines Session.
void defineSession(pybind11::module_& module);
/// Defines Sequence.
void defineSequence(pybind11::module_& module);

}  // namespace candela::python
