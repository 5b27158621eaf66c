// Wraps the vectors of an image.
#include "host/python/film_arrays.h"

#include "host/python/python_film.h"

namespace candela::python {
namespace {

namespace py = pybind11;

template <class Number>
py::array share(const py::object& film, const Number* data, std::vector<py::ssize_t> shape) {
  py::array array = py::array_t<Number>(std::move(shape), data, film);
  array.attr("flags").attr("writeable") = false;  // all arrays of a film share its memory
  return array;
}

std::vector<py::ssize_t> shapeOf(const image::Image& image) {
  return {static_cast<py::ssize_t>(image.height), static_cast<py::ssize_t>(image.width)};
}

const image::Image& pictureIn(const py::object& film) { return pictureOf(film.cast<const PythonFilm&>()); }

}  // namespace

py::array imageOf(const py::object& film) {
  static_assert(sizeof(glm::vec3) == 3 * sizeof(float));
  const image::Image& image = pictureIn(film);
  std::vector<py::ssize_t> shape = shapeOf(image);
  shape.push_back(3);
  return share(film, reinterpret_cast<const float*>(image.rgb.data()), std::move(shape));
}

py::array varianceOf(const py::object& film) {
  const image::Image& image = pictureIn(film);
  return share(film, image.luminanceVariance.data(), shapeOf(image));
}

py::array samplesOf(const py::object& film) {
  const image::Image& image = pictureIn(film);
  return share(film, image.sampleCounts.data(), shapeOf(image));
}

py::object alphaOf(const py::object& film) {
  const image::Image& image = pictureIn(film);
  if (image.alpha.empty()) return py::none();
  return share(film, image.alpha.data(), shapeOf(image));
}

}  // namespace candela::python
