// Denoises copies of a film's picture as the commands do.
#include "host/app/python/film_denoise.h"

#include "host/app/cli/denoise_film.h"
#include "host/app/python/options.h"
#include "host/app/python/python_log.h"
#include "host/app/python/watched.h"

namespace candela::python {

namespace py = pybind11;

image::Image resultImage(const PythonFilm& film, const cli::RenderArguments& arguments, const Log& log) {
  image::Image image = film.picture();
  if (arguments.denoise) denoiseResult(image, film.film, film.isInterrupted, arguments, log);
  return image;
}

py::array denoised(const PythonFilm& film, const py::kwargs& options) {
  auto arguments = argumentsOf<cli::DenoiseArguments>(kDenoiseOptions, options);
  if (!arguments.given.contains("--device")) arguments.device = film.arguments.device;
  PythonLog log;
  image::Image image;
  runWatched([&](const Watch&) {
    image = film.picture();
    denoiseImage(image, film.film, arguments, log);
  });
  log.passOn();
  return py::array_t<float>({film.film.height(), film.film.width(), 3u}, &image.rgb.data()->x);
}

}  // namespace candela::python
