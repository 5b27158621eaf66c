// Chooses the exception by the type and the exit code of an error.
#include "host/app/python/errors.h"

#include "host/app/python/file_names.h"
#include "host/base/errors.h"
#include "host/formats/loading/diagnostic.h"

namespace candela::python {
namespace {

namespace py = pybind11;

template <class T>
bool is(const Error& error) {
  return dynamic_cast<const T*>(&error) != nullptr;
}

const char* nameOf(const Error& error) {
  if (is<scene::SceneError>(error)) return "SceneError";
  if (is<DeviceHungError>(error)) return "DeviceHungError";
  switch (error.code()) {
    case ExitCode::usage:
      return "UsageError";
    case ExitCode::file:
      return "FileError";
    case ExitCode::noDevice:
      return "NoDeviceError";
    case ExitCode::deviceLost:
      return "DeviceLostError";
    case ExitCode::outOfMemory:
      return "OutOfMemoryError";
    case ExitCode::undecided:
      return "UndecidedError";
    default:
      return "InternalError";
  }
}

// The diagnostics of a scene, each as (file, line, column, message).
py::list diagnosticsOf(const scene::SceneError& error) {
  py::list list;
  for (const scene::Diagnostic& one : error.diagnostics) {
    list.append(py::make_tuple(textOf(one.file), one.line, one.column, textOf(one.message)));
  }
  return list;
}

void raise(const Error& error) {
  const py::object type = py::module_::import("candela._errors").attr(nameOf(error));
  const py::object exception = type(textOf(error.what()));
  if (const auto* scene = dynamic_cast<const scene::SceneError*>(&error)) {
    exception.attr("diagnostics") = diagnosticsOf(*scene);
  }
  PyErr_SetObject(type.ptr(), exception.ptr());
}

}  // namespace

void translateErrors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Error& error) {
      raise(error);
    }
  });
}

}  // namespace candela::python
