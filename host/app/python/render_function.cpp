// Implements render(), which works like the command, except that the film stays in memory.
#include <nlohmann/json.hpp>

#include "host/app/cli/denoise_film.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/separate_files.h"
#include "host/app/cli/statistics_report.h"
#include "host/app/python/options.h"
#include "host/app/python/python_scene.h"
#include "host/app/python/rendering.h"
#include "host/app/python/watched.h"
#include "host/base/json_text.h"
#include "host/base/progress.h"

namespace candela::python {
namespace {

namespace py = pybind11;
using Film = std::shared_ptr<PythonFilm>;

Film trace(const PythonScene& scene, const cli::RenderArguments& arguments, const Watch& watch, const Log& log) {
  const double start = monotonicSeconds();
  const cli::RenderJob job = renderJobOf(scene, arguments, log);
  const job::OpenDevice open = openDevice(job.arguments, log);
  job::JobResult ended = job::runJob(job, open, {.stop = &watch.stop, .report = watch.report, .start = start}, log);
  if (ended.failure) throw Error(ended.failure->code, ended.failure->message);
  if (ended.isFilmLost) throw FileError(arguments.film.checkpoint.string() + ": the film could not be written");
  if (!ended.result.interrupted) watch.report(1, ended.result.statistics.samples);
  const film::WorkReport work = ended.work.value_or(film::workOf(ended.result.statistics));
  return filmOf(job, arguments, scene.files(), std::move(ended.result), std::move(ended.header), work,
                monotonicSeconds() - start, log);
}

Film render(const PythonScene& scene, const py::object& progress, const py::kwargs& options) {
  const auto arguments = argumentsOf<cli::RenderArguments>(kRenderOptions, options);
  requireSeparate(arguments, scene.files());
  PythonLog log;
  const std::optional<film::FilmLock> lock = cli::lockCheckpoint(arguments.film, log);
  Film film;
  runWatched([&](const Watch& watch) { film = trace(scene, arguments, watch, log); }, progress);
  log.passOn();
  return film;
}

}  // namespace

cli::RenderJob renderJobOf(const PythonScene& scene, const cli::RenderArguments& arguments, const Log& log) {
  cli::requireDenoisable(arguments);
  cli::RenderJob job = scene.jobOf(withDenoiseLayers(arguments), log);
  cli::requireDenoisable(arguments, job.settings.image);
  return job;
}

// The names of scenes of arrays are no files.
void requireSeparate(cli::RenderArguments arguments, const std::vector<std::filesystem::path>& files) {
  arguments.files.clear();
  cli::requireSeparateFiles(arguments);
  cli::requireUnread(arguments, files);
}

Film filmOf(const cli::RenderJob& job, const cli::RenderArguments& arguments, std::vector<std::filesystem::path> files,
            render::RenderResult result, film::FilmHeader header, const film::WorkReport& work, double seconds,
            const Log& log) {
  auto film = std::make_shared<PythonFilm>();
  cli::RenderReport report{job, result, 0, seconds, {}, work};
  report.badSamples.add(result.film, job.settings.image);
  reportFlaws(report, log);
  film->report = jsonText(toJson(report));
  film->metadata = metadataOf(job, result);
  film->arguments = arguments;
  film->files = std::move(files);
  film->isInterrupted = result.interrupted;
  film->header = std::move(header);
  film->work = work;
  film->film = std::move(result.film);
  return film;
}

void defineRender(py::module_& module) {
  module.def("render", &render, py::arg("scene"), py::pos_only(), py::kw_only(), py::arg("progress") = py::none(),
             ("render(scene, /, *, progress=None, **options) -> Film\n\nRenders a scene as `candela render` does. "
              "`progress(fraction, samples)` is called from time to time.\n\n" +
              helpOf(kRenderOptions))
                 .c_str());
}

}  // namespace candela::python
