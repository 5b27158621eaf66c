// Denoised pictures of films.
#pragma once
#include <pybind11/numpy.h>

#include "host/app/python/python_film.h"
#include "host/base/log.h"

namespace candela::python {

/// Returns the image that is saved and shown: that of the film, denoised if `arguments` request it. Without the GIL.
image::Image resultImage(const PythonFilm& film, const cli::RenderArguments& arguments, const Log& log);

/// Returns a new array, float32, (height, width, 3). By default, the device of the render denoises.
pybind11::array denoised(const PythonFilm& film, const pybind11::kwargs& options);

}  // namespace candela::python
