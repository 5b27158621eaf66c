// Films in Python.
#pragma once
#include <pybind11/pybind11.h>

#include <mutex>
#include <string>

#include "host/app/cli/render_images.h"
#include "host/app/python/film_layers.h"
#include "host/job/film/film_header.h"
#include "host/job/film/work_report.h"

namespace candela::python {

/// The exact sums of a render with all metadata of its files. It does not change.
struct PythonFilm {
  image::Film film;
  film::FilmHeader header;
  cli::Metadata metadata;                      ///< of image files
  film::WorkReport work;                       ///< of the file beside a film file
  cli::RenderArguments arguments;              ///< of the render; of a film file, the defaults
  std::vector<std::filesystem::path> files{};  ///< that the scene has read, or the film files themselves
  std::string report;                          ///< JSON, as `candela render` writes it; empty for a film file
  bool isInterrupted = false;

  /// Converts the sums once, even if several threads call it. Without the GIL.
  const image::Image& picture() const;
  /// Returns the layers of picture(), which are also computed once.
  const std::map<image::Layer, LayerValues>& layers() const;

 private:
  mutable std::once_flag once_, layersOnce_;
  mutable image::Image picture_;
  mutable std::map<image::Layer, LayerValues> layers_;
};

/// Converts the sums of a film without the GIL, which the caller holds.
const image::Image& pictureOf(const PythonFilm& film);
/// Makes the layers of a film without the GIL, which the caller holds.
const std::map<image::Layer, LayerValues>& layerValuesOf(const PythonFilm& film);

void defineFilm(pybind11::module_& module);

}  // namespace candela::python
