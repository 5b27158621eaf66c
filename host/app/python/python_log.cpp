// Collects messages, and passes them to Python.
#include "host/app/python/python_log.h"

#include <pybind11/pybind11.h>

#include <iostream>

#include "host/app/python/file_names.h"
#include "host/app/python/running_call.h"

namespace candela::python {

namespace py = pybind11;

PythonLog::PythonLog() : Log(std::cerr, Verbosity::verbose) {}

void PythonLog::add(const char* kind, const std::string& text) const {
  const std::scoped_lock lock(mutex_);
  messages_.emplace_back(kind, text);
}

void PythonLog::passOn() {
  std::vector<std::pair<std::string, std::string>> messages;
  {
    const std::scoped_lock lock(mutex_);
    messages.swap(messages_);
  }
  const RunningCall call;
  const py::object publish = py::module_::import("candela._messages").attr("publish");
  for (const auto& [kind, text] : messages) publish(kind, textOf(text));
}

}  // namespace candela::python
