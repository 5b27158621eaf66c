// Saves, opens and merges films.
#include "host/app/python/python_film.h"

#include <fmt/format.h>
#include <pybind11/stl.h>

#include <nlohmann/json.hpp>

#include "host/app/cli/display_choice.h"
#include "host/app/cli/film_description.h"
#include "host/app/cli/output_check.h"
#include "host/app/python/file_names.h"
#include "host/app/python/film_arrays.h"
#include "host/app/python/film_denoise.h"
#include "host/app/python/json.h"
#include "host/app/python/options.h"
#include "host/app/python/python_log.h"
#include "host/app/python/rendering.h"
#include "host/app/python/running_call.h"
#include "host/app/python/watched.h"
#include "host/base/json_text.h"
#include "host/job/film/film_file.h"
#include "host/job/film/merge.h"

namespace candela::python {
namespace {

namespace py = pybind11;
using Files = std::vector<std::filesystem::path>;
using Film = std::shared_ptr<PythonFilm>;

void writeFilmFile(const PythonFilm& film, const std::filesystem::path& file) {
  const film::FilmLock lock(file);
  const std::string check = film::writeFilm(file, film.header, film.film);
  film::writeWork(file, check, film.work);
}

// The display options of the call replace those of the film.
cli::RenderArguments savingArguments(const PythonFilm& film, const Files& outputs,
                                     const std::filesystem::path& filmFile, const py::kwargs& options) {
  const auto given = argumentsOf<cli::RenderArguments>(kSaveOptions, options);
  cli::RenderArguments arguments = film.arguments;
  static_cast<cli::PictureArguments&>(arguments) = given;
  arguments.outputs = outputs;
  arguments.film.checkpoint = filmFile;
  if (options.contains("denoise") && !options["denoise"].is_none())
    static_cast<cli::DenoisingArguments&>(arguments) = given;
  if (given.given.contains("--device")) arguments.device = given.device;
  arguments.noCache = arguments.noCache || given.noCache;
  return arguments;
}

// Raises TypeError for anything but names of files.
Files filesOf(const py::iterable& names) {
  Files files;
  for (const py::handle& name : names) files.push_back(fileOf("files", name));
  return files;
}

// Takes the film file out of the options; empty: none.
std::filesystem::path takeFilmFile(const py::kwargs& options) {
  const py::object file = options.attr("pop")("checkpoint", py::none());
  return file.is_none() ? std::filesystem::path() : fileOf("checkpoint", file);
}

void save(const PythonFilm& film, const py::args& files, const py::kwargs& options) {
  const Files outputs = filesOf(files);
  const std::filesystem::path filmFile = takeFilmFile(options);
  for (const auto& file : outputs) {
    if (image::isStandardOutput(file)) throw UsageError(file.string() + ": name a file; to_png() returns bytes");
    cli::requireWritableImage(file);
  }
  if (!filmFile.empty()) cli::requireWritableFilm(filmFile);
  const cli::RenderArguments arguments = savingArguments(film, outputs, filmFile, options);
  requireSeparate(arguments, film.files);
  PythonLog log;
  runWatched([&](const Watch&) {
    if (!outputs.empty())
      writeImages(resultImage(film, arguments, log), arguments, cli::integratorOf(film.header), log);
    if (!filmFile.empty()) writeFilmFile(film, filmFile);
  });
  log.passOn();
}

py::bytes png(const PythonFilm& film) {
  std::vector<std::byte> bytes;
  PythonLog log;
  runWatched([&](const Watch&) {
    const image::Image image = resultImage(film, film.arguments, log);
    const image::DisplayTransform display = chooseDisplay(film.arguments, cli::integratorOf(film.header), image);
    bytes = image::toPng(image.alpha.empty() ? toPixels8(image, display) : toStraightPixels8(image, display));
  });
  log.passOn();
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

Film filmOfFiles(const Files& files, film::FilmHeader header, image::Film sums, film::WorkReport work) {
  auto film = std::make_shared<PythonFilm>();
  film->metadata = cli::metadataOf(header, sums);
  film->isInterrupted = !header.begun.empty();
  film->header = std::move(header);
  film->film = std::move(sums);
  film->work = std::move(work);
  for (const auto& file : files) film->files.insert(film->files.end(), {file, film::workFile(file)});
  return film;
}

Film open(const py::object& name) {
  const std::filesystem::path file = fileOf("file", name);
  Film film;
  runWatched([&](const Watch&) {
    film::FilmReader reader(file);
    film = filmOfFiles({file}, reader.header(), film::readFilm(reader), film::readWork(file, reader.check()));
  });
  return film;
}

Film merge(const py::iterable& names, const py::kwargs& options) {
  if (isFileName(names)) throw py::type_error("files: expected several names of files, in a list");
  const Files files = filesOf(names);
  const auto arguments = argumentsOf<cli::MergeArguments>(kMergeOptions, options);
  Film film;
  runWatched([&](const Watch&) {
    film::MergedFilm merged = film::mergeFilms(files, {arguments.mixedDevices, arguments.partial});
    film = filmOfFiles(files, std::move(merged.header), std::move(merged.film), std::move(merged.work));
  });
  return film;
}

cli::FilmDescription descriptionOf(const PythonFilm& film) { return cli::describe(film.header, film.film, film.work); }

py::object reportOf(const PythonFilm& film) { return film.report.empty() ? py::none() : fromJson(film.report); }

std::string filmText(const PythonFilm& film) {
  const cli::FilmDescription description = descriptionOf(film);
  return fmt::format("<candela.Film {}x{}, {} samples{}, hash {}>", film.film.width(), film.film.height(),
                     description.samples, film.isInterrupted ? ", interrupted" : "", description.filmHash);
}

void defineArrays(py::class_<PythonFilm, Film>& type) {
  type.def_property_readonly("image", &imageOf, "float32 (height, width, 3): mean of the samples, linear RGB")
      .def_property_readonly("variance", &varianceOf,
                             "float32 (height, width): variance of the luminance of one sample, not of the mean")
      .def_property_readonly("samples", &samplesOf, "uint32 (height, width): number of samples")
      .def_property_readonly("alpha", &alphaOf, "float32 (height, width), with background='none'; else None")
      .def_property_readonly("layers", &layersOf, "dict of the layers of aovs=[...] by name, as layer() returns them")
      .def("layer", &layerOf, py::arg("name"), py::pos_only(),
           "float32 (height, width) or (height, width, channels): a layer of aovs=[...]");
}

}  // namespace

const image::Image& PythonFilm::picture() const {
  std::call_once(once_, [this] { picture_ = cli::pictureOf(header, film, metadata); });
  return picture_;
}

const std::map<image::Layer, LayerValues>& PythonFilm::layers() const {
  std::call_once(layersOnce_, [this] { layers_ = layersIn(picture(), film.layers()); });
  return layers_;
}

const image::Image& pictureOf(const PythonFilm& film) {
  const RunningCall call;
  const py::gil_scoped_release released;
  return film.picture();
}

const std::map<image::Layer, LayerValues>& layerValuesOf(const PythonFilm& film) {
  const RunningCall call;
  const py::gil_scoped_release released;
  return film.layers();
}

void defineFilm(py::module_& module) {
  py::class_<PythonFilm, Film> type(module, "Film", py::is_final(), "The exact sums of a render. It does not change.");
  defineArrays(type);
  type.def_property_readonly("width", [](const PythonFilm& film) { return film.film.width(); })
      .def_property_readonly("height", [](const PythonFilm& film) { return film.film.height(); })
      .def_property_readonly("hash", [](const PythonFilm& film) { return descriptionOf(film).filmHash; })
      .def_property_readonly("interrupted", [](const PythonFilm& film) { return film.isInterrupted; })
      .def_property_readonly("description",
                             [](const PythonFilm& film) { return fromJson(jsonText(toJson(descriptionOf(film)))); })
      .def_property_readonly("report", &reportOf)
      .def("save", &save,
           ("save(*files, checkpoint=None, **options)\n\nWrites image files (.png, .jpg, .hdr, .pfm, .exr) and a film "
            "file, with the bytes that the program writes.\n\n" +
            helpOf(kSaveOptions))
               .c_str())
      .def("denoise", &denoised,
           ("denoise(**options)\n\nfloat32 (height, width, 3): the denoised image, linear RGB.\n\n" +
            helpOf(kDenoiseOptions))
               .c_str())
      .def("_repr_png_", &png)
      .def("__copy__", [](const Film& film) { return film; })
      .def("__deepcopy__", [](const Film& film, const py::dict&) { return film; })
      .def("__repr__", &filmText);
  module.def("open_film", &open, py::arg("file"), py::pos_only(), "open_film(file, /) -> Film\n\nReads a film file.");
  module.def(
      "merge", &merge, py::arg("files"), py::pos_only(),
      ("merge(files, /, **options) -> Film\n\nMerges film files of parts of a render.\n\n" + helpOf(kMergeOptions))
          .c_str());
}

}  // namespace candela::python
