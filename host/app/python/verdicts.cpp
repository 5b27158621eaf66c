// Compares tracers and images, like the commands.
#include "host/app/python/verdicts.h"

#include <fmt/format.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "host/app/cli/bad_samples.h"
#include "host/app/cli/image_pair.h"
#include "host/app/cli/requirements.h"
#include "host/app/python/file_names.h"
#include "host/app/python/json.h"
#include "host/app/python/options.h"
#include "host/app/python/python_film.h"
#include "host/app/python/python_scene.h"
#include "host/app/python/watched.h"
#include "host/base/errors.h"
#include "host/base/json_text.h"
#include "host/judge/explain/explanation.h"
#include "host/judge/verify/verify.h"
#include "host/trace/reference/reference_renderer.h"

namespace candela::python {
namespace {

namespace py = pybind11;

/// A job with both of its tracers.
struct Tracers {
  Tracers(const PythonScene& scene, const cli::TracingCommand& command, const Watch& watch, const Log& log)
      : job(scene.jobOf(command, log)),
        device(makeRenderer(job.arguments, log)),
        reference(reference::makeReferenceRenderer()),
        control{&watch.stop, watch.report} {}

  cli::RenderJob job;
  std::unique_ptr<render::Renderer> device, reference;
  render::RenderControl control;
};

/// Runs `work` without the GIL, and passes its messages on.
template <class Result>
Result watched(const std::function<Result(const Watch&, const Log&)>& work, const py::object& progress) {
  PythonLog log;
  Result result;
  runWatched([&](const Watch& watch) { result = work(watch, log); }, progress);
  log.passOn();
  return result;
}

// Fills in a result. An interrupted verdict and one that is not decided do not say whether the sides agree.
template <class Kind>
Kind outcomeOf(std::optional<verify::Conclusion> conclusion, std::string verdict, std::string text,
               const nlohmann::ordered_json& report) {
  Kind outcome{{std::nullopt, std::move(verdict), std::move(text), jsonText(report)}};
  outcome.isUndecided = conclusion == verify::Conclusion::undecided;
  if (conclusion && !outcome.isUndecided) outcome.agrees = conclusion == verify::Conclusion::same;
  return outcome;
}

std::optional<verify::Conclusion> conclusionOf(const auto& report) {
  return report.interrupted ? std::nullopt : std::optional(report.conclusion());
}

Verdict verifyScene(const PythonScene& scene, const cli::VerifyArguments& arguments, const Watch& watch,
                    const Log& log) {
  Tracers tracers(scene, arguments, watch, log);
  const verify::VerifyReport report = verify::verifyScene(tracers.job.scene(), tracers.job.settings, *tracers.device,
                                                          *tracers.reference, arguments.verification, tracers.control);
  reportBadSamples(report.badSamples, tracers.job, log);
  nlohmann::ordered_json json = toJson(report);
  json["badSamples"] = badSamplesJson(report.badSamples, tracers.job);
  return outcomeOf<Verdict>(conclusionOf(report), report.verdict(), toText(report), json);
}

Verdict verify(const PythonScene& scene, const py::object& progress, const py::kwargs& options) {
  const auto arguments = argumentsOf<cli::VerifyArguments>(kVerifyOptions, options);
  requireVerifiable(arguments);
  return watched<Verdict>([&](const Watch& watch, const Log& log) { return verifyScene(scene, arguments, watch, log); },
                          progress);
}

Explanation explanationOf(const explain::Explanation& explanation) {
  render::requireComplete(explanation.statistics);
  return {!explanation.firstDifference, explanation.verdict(), toText(explanation), jsonText(toJson(explanation))};
}

// The pixel that differs most is found by images of one sample per pixel.
Explanation explainWorst(Tracers& tracers) {
  verify::PathRenders renders;  // compare() reports bad samples
  const auto pixels = verify::comparePaths(tracers.job.scene(), tracers.job.settings, *tracers.device,
                                           *tracers.reference, verify::LightTestOptions().alpha, tracers.control,
                                           renders);
  if (!pixels) throw InterruptedError("interrupted before a sample was explained");
  render::requireComplete(renders.deviceStatistics);
  const auto worst = explain::explainWorst(tracers.job.scene(), tracers.job.settings, *pixels, *tracers.device,
                                           *tracers.reference);
  if (worst) return explanationOf(*worst);
  const std::string text = explain::nothingToExplain(*pixels);
  return {true, text, text + "\n", jsonText(explain::nothingJson(tracers.job.scene(), *pixels))};
}

Explanation explainScene(const PythonScene& scene, const cli::ExplainArguments& arguments, const Watch& watch,
                         const Log& log) {
  Tracers tracers(scene, arguments, watch, log);
  if (!arguments.pixel) return explainWorst(tracers);
  return explanationOf(explain::explainSample(tracers.job.scene(), tracers.job.settings,
                                              sampleAskedFor(arguments, tracers.job.settings.image), *tracers.device,
                                              *tracers.reference));
}

Explanation explain(const PythonScene& scene, const py::object& progress, const py::kwargs& options) {
  const auto arguments = argumentsOf<cli::ExplainArguments>(kExplainOptions, options);
  requireExplainable(arguments);
  return watched<Explanation>(
      [&](const Watch& watch, const Log& log) { return explainScene(scene, arguments, watch, log); }, progress);
}

Comparison compareTracers(const PythonScene& scene, const cli::CompareArguments& arguments, const Watch& watch,
                          const Log& log) {
  Tracers tracers(scene, arguments, watch, log);
  const verify::AgreementReport report = verify::compareTracers(tracers.job.scene(), tracers.job.settings,
                                                                *tracers.device, *tracers.reference,
                                                                arguments.verification, tracers.control);
  render::requireComplete(report.deviceStatistics);
  reportBadSamples(report.badSamples, tracers.job, log);
  nlohmann::ordered_json json = report.toJson();
  json["badSamples"] = badSamplesJson(report.badSamples, tracers.job);
  return outcomeOf<Comparison>(conclusionOf(report), report.verdict(), report.toText(), json);
}

Comparison compareScene(const PythonScene& scene, const py::object& progress, const py::kwargs& options) {
  const auto arguments = argumentsOf<cli::CompareArguments>(kCompareTracersOptions, options);
  requireComparable(arguments);
  return watched<Comparison>(
      [&](const Watch& watch, const Log& log) { return compareTracers(scene, arguments, watch, log); }, progress);
}

image::Image imageOfArray(const py::handle& value) {
  const auto array = py::array_t<float, py::array::c_style | py::array::forcecast>::ensure(value);
  if (!array || array.ndim() != 3 || array.shape(2) != 3) {
    throw UsageError("an image is a film, the name of an image file, or an array of shape (height, width, 3)");
  }
  image::Image image{
      static_cast<std::uint32_t>(array.shape(1)), static_cast<std::uint32_t>(array.shape(0)), {}, {}, {}, {}, {}};
  const auto* first = reinterpret_cast<const glm::vec3*>(array.data());
  image.rgb.assign(first, first + array.shape(0) * array.shape(1));
  return image;
}

image::Image imageFrom(const py::handle& value) {
  if (py::isinstance<PythonFilm>(value)) return pictureOf(value.cast<const PythonFilm&>());
  return isFileName(value) ? image::readImage(fileOf("image", value), image::ImageParts::withLayers)
                           : imageOfArray(value);
}

Comparison compareImages(const py::object& a, const py::object& b, const py::kwargs& options) {
  const auto arguments = argumentsOf<cli::CompareArguments>(kCompareImagesOptions, options);
  image::Image first = imageFrom(a), reference = imageFrom(b);
  cli::ImagePair pair;
  runWatched([&](const Watch&) { pair = comparePair(arguments, first, reference); });
  const auto conclusion = pair.verdict.isGiven() ? std::optional(pair.verdict.conclusion()) : std::nullopt;
  return outcomeOf<Comparison>(conclusion, pair.verdict.sentence(), toText(pair), toJson(pair));
}

bool truthOf(const Outcome& outcome) {
  if (outcome.agrees) return *outcome.agrees;
  if (outcome.isUndecided) throw UndecidedError(outcome.verdict);
  throw UsageError("there is no verdict: state tolerance or alpha, or compare films or EXR files of renders");
}

template <class Kind>
void defineKind(py::module_& module, const char* name, const char* help) {
  py::class_<Kind>(module, name, py::is_final(), help)
      .def_property_readonly("agrees", [](const Kind& outcome) { return outcome.agrees; })
      .def_property_readonly("verdict", [](const Kind& outcome) { return outcome.verdict; })
      .def_property_readonly("text", [](const Kind& outcome) { return outcome.text; })
      .def_property_readonly("report", [](const Kind& outcome) { return fromJson(outcome.report); })
      .def("__bool__", [](const Kind& outcome) { return truthOf(outcome); })
      .def("__str__", [](const Kind& outcome) { return outcome.text; })
      .def("__repr__", [name](const Kind& outcome) { return fmt::format("<candela.{}: {}>", name, outcome.verdict); });
}

template <class Function>
void defineOfScene(py::module_& module, const char* name, const Function& function, const char* help,
                   const FunctionOptions& options) {
  module.def(name, function, py::arg("scene"), py::pos_only(), py::kw_only(), py::arg("progress") = py::none(),
             (std::string(help) + "\n\n" + helpOf(options)).c_str());
}

}  // namespace

void defineVerdicts(py::module_& module) {
  defineKind<Verdict>(module, "Verdict", "Whether a device computes the same light as the reference tracer.");
  defineKind<Comparison>(module, "Comparison", "The difference of two images, or of two tracers.");
  defineKind<Explanation>(module, "Explanation", "One sample on both tracers.");
  defineOfScene(module, "verify", &verify, "Tests whether a device computes the same light as the reference tracer.",
                kVerifyOptions);
  defineOfScene(module, "explain", &explain, "Traces one sample on both tracers, and compares the paths.",
                kExplainOptions);
  defineOfScene(module, "compare", &compareScene, "Compares a device's image of a scene with the reference's.",
                kCompareTracersOptions);
  module.def("compare", &compareImages, py::arg("a"), py::arg("b"), py::pos_only(),
             ("Compares two images: films, image files or arrays.\n\n" + helpOf(kCompareImagesOptions)).c_str());
}

}  // namespace candela::python
