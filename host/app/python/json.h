// Converts JSON to Python objects.
#pragma once
#include <pybind11/pybind11.h>

#include <string>

namespace candela::python {

/// Returns the object that Python's json.loads() returns for a text.
inline pybind11::object fromJson(const std::string& text) {
  return pybind11::module_::import("json").attr("loads")(text);
}

}  // namespace candela::python
