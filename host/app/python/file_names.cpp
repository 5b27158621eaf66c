// Converts names of files and other text between Python and C++.
#include "host/app/python/file_names.h"

#include <fmt/format.h>

namespace candela::python {

namespace py = pybind11;

bool isFileName(const py::handle& value) {
  return py::isinstance<py::str>(value) || py::isinstance<py::bytes>(value) || py::hasattr(value, "__fspath__");
}

std::filesystem::path fileOf(const std::string& what, const py::handle& value) {
  if (!isFileName(value)) {
    throw py::type_error(fmt::format("{}: expected the name of a file, got {}", what, std::string(py::repr(value))));
  }
  PyObject* name = nullptr;
  if (PyUnicode_FSConverter(value.ptr(), &name) == 0) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(name));
}

py::str textOf(const std::string& text) {
  PyObject* const decoded = PyUnicode_DecodeUTF8(text.data(), static_cast<py::ssize_t>(text.size()),
                                                 "backslashreplace");
  if (decoded == nullptr) throw py::error_already_set();
  return py::reinterpret_steal<py::str>(decoded);
}

}  // namespace candela::python
