// The numbers of a film as arrays of NumPy.
#pragma once
#include <pybind11/numpy.h>

#include <string>

namespace candela::python {

/// Each returns an array that shares the memory of the film, a PythonFilm, keeps it alive, and is read-only.
pybind11::array imageOf(const pybind11::object& film);     ///< float32, (height, width, 3), linear RGB
pybind11::array varianceOf(const pybind11::object& film);  ///< float32, (height, width)
pybind11::array samplesOf(const pybind11::object& film);   ///< uint32, (height, width)
/// float32, (height, width); None for a film without alpha.
pybind11::object alphaOf(const pybind11::object& film);
/// float32, (height, width) for a layer of one channel, else (height, width, channels). The name is one of --aov.
/// Throws UsageError if the film lacks the layer.
pybind11::array layerOf(const pybind11::object& film, const std::string& name);
/// A dict of the layers that need sums, by name.
pybind11::dict layersOf(const pybind11::object& film);

}  // namespace candela::python
