// The class Sequence.
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <atomic>
#include <set>

#include "host/app/cli/denoise_film.h"
#include "host/app/cli/frame_arguments.h"
#include "host/app/python/claim.h"
#include "host/app/python/file_names.h"
#include "host/app/python/options.h"
#include "host/app/python/python_log.h"
#include "host/app/python/rendering.h"
#include "host/app/python/watched.h"
#include "host/base/progress.h"
#include "host/formats/load_scene.h"
#include "host/job/frame_renderer.h"

namespace candela::python {
namespace {

namespace py = pybind11;

/// A scene file that was read once, and the renderer of its frames.
class PythonSequence {
 public:
  explicit PythonSequence(const cli::RenderArguments& arguments)
      : arguments_(arguments),
        source_(arguments_.files.front(), arguments_.loadOptions),
        renderer_(openDevice(arguments_, log_)) {}
  PythonSequence(const PythonSequence&) = delete;
  PythonSequence& operator=(const PythonSequence&) = delete;

  job::FrameRange frames() const { return framesOf(arguments_); }

  /// Returns the film of a frame, as render() returns it. Runs on another thread, without the GIL.
  std::shared_ptr<PythonFilm> render(std::uint32_t frame, const Watch& watch) {
    const double start = monotonicSeconds();
    const cli::RenderArguments arguments = argumentsOfFrame(arguments_, frame);
    scene::LoadedScene loaded = source_.at(arguments.loadOptions.time, arguments.loadOptions.orbit);
    for (const scene::Diagnostic& warning : loaded.warnings) {
      if (warnings_.insert(toString(warning)).second) log_.warning(toString(warning));
    }
    requireCamera(loaded.scene);
    cli::requireDenoisable(arguments);
    const auto scene = std::make_shared<const scene::Scene>(std::move(loaded.scene));
    const cli::RenderJob job = jobOf(withDenoiseLayers(arguments), scene, log_);
    cli::requireDenoisable(arguments, job.settings.image);
    job::JobResult ended = renderer_.run(job, {.stop = &watch.stop, .report = watch.report, .start = start}, log_);
    if (ended.failure) throw Error(ended.failure->code, ended.failure->message);
    if (!ended.result.interrupted) watch.report(1, ended.result.statistics.samples);
    const film::WorkReport work = film::workOf(ended.result.statistics);
    loaded.files.emplace_back(arguments.files.front());
    return filmOf(job, arguments, loaded.files, std::move(ended.result), std::move(ended.header), work,
                  monotonicSeconds() - start, log_);
  }

  PythonLog& log() { return log_; }
  std::atomic<bool>& isBusy() { return isBusy_; }

 private:
  cli::RenderArguments arguments_;
  PythonLog log_;
  formats::SceneSource source_;
  job::FrameRenderer renderer_;
  std::set<std::string> warnings_{};  ///< that were passed on
  std::atomic<bool> isBusy_{false};
};
using Sequence = std::shared_ptr<PythonSequence>;

Sequence openSequence(const py::object& file, const py::kwargs& options) {
  auto arguments = argumentsOf<cli::RenderArguments>(kSequenceOptions, options);
  if (!arguments.isSequence())
    throw UsageError("frames: no frames given, for example frames=range(48), or turntable=120");
  arguments.files = {fileOf("file", file)};
  Sequence sequence;
  runWatched([&](const Watch&) { sequence = std::make_shared<PythonSequence>(arguments); });
  return sequence;
}

py::object framesOfSequence(const PythonSequence& sequence) {
  const job::FrameRange frames = sequence.frames();
  return py::module_::import("builtins").attr("range")(frames.first, frames.end);
}

std::shared_ptr<PythonFilm> renderFrame(PythonSequence& sequence, std::uint32_t frame, const py::object& progress) {
  const Claim claim(sequence.isBusy(), "the sequence");
  const job::FrameRange frames = sequence.frames();
  if (frame < frames.first || frame >= frames.end) {
    throw UsageError(fmt::format("frame: expected a frame from {} to {}, got {}", frames.first, frames.end - 1, frame));
  }
  std::shared_ptr<PythonFilm> film;
  runWatched([&](const Watch& watch) { film = sequence.render(frame, watch); }, progress);
  sequence.log().passOn();
  return film;
}

}  // namespace

void defineSequence(py::module_& module) {
  py::class_<PythonSequence, Sequence>(module, "Sequence", py::is_final(),
                                       "The frames of an animation or of a turntable, whose file is read once.")
      .def(py::init(&openSequence), py::arg("file"), py::pos_only(),
           ("Sequence(file, /, **options)\n\n" + helpOf(kSequenceOptions)).c_str())
      .def("render", &renderFrame, py::arg("frame"), py::pos_only(), py::kw_only(), py::arg("progress") = py::none(),
           "Renders a frame, with the bytes of render() on a scene that was loaded at its time.")
      .def_property_readonly("frames", &framesOfSequence, "The range of the frames.");
}

}  // namespace candela::python
