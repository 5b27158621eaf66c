// The Vulkan devices of this machine, in Python.
#pragma once
#include <pybind11/pybind11.h>

namespace candela::python {

void defineDevices(pybind11::module_& module);

}  // namespace candela::python
