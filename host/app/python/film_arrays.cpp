// Wraps the vectors of an image.
#include "host/app/python/film_arrays.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/app/python/python_film.h"
#include "host/base/errors.h"

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

// The layer with this name; `variance` and `samples`, which every film has, are not among them.
std::optional<image::Layer> layerNamed(const std::string& name) {
  const auto found = std::ranges::find(image::layerNames(), name);
  if (found == image::layerNames().end()) return std::nullopt;
  return static_cast<image::Layer>(found - image::layerNames().begin());
}

py::array shareLayer(const py::object& film, const LayerValues& layer) {
  std::vector<py::ssize_t> shape = shapeOf(film.cast<const PythonFilm&>().picture());
  if (layer.channels > 1) shape.push_back(static_cast<py::ssize_t>(layer.channels));
  return share(film, layer.values.data(), std::move(shape));
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

py::array layerOf(const py::object& film, const std::string& name) {
  const std::optional<image::Layer> layer = layerNamed(name);
  if (layer == image::Layer::variance) return varianceOf(film);
  if (layer == image::Layer::samples) return samplesOf(film);
  const auto& source = film.cast<const PythonFilm&>();
  const auto& layers = layerValuesOf(source);
  const auto values = layer ? layers.find(*layer) : layers.end();
  if (values != layers.end()) return shareLayer(film, values->second);
  throw UsageError(
      fmt::format("the film has no layer \"{}\"; its layers are {}", name, layerText(source.film.layers())));
}

py::dict layersOf(const py::object& film) {
  py::dict arrays;
  for (const auto& [layer, values] : layerValuesOf(film.cast<const PythonFilm&>())) {
    arrays[py::str(std::string(image::layerNames()[static_cast<std::size_t>(layer)]))] = shareLayer(film, values);
  }
  return arrays;
}

}  // namespace candela::python
