// Converts JSON to Python objects.
#pragma once
#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>
#include <string>

namespace candela::python {

/// Returns the object that Python's json.loads() returns for a text.
inline pybind11::object fromJson(const std::string& text) {
  return pybind11::module_::import("json").attr("loads")(text);
}

/// Returns the text of a report. Bytes that are not UTF-8, which names of files may have, become U+FFFD, as in reports
/// of the program.
inline std::string jsonText(const nlohmann::ordered_json& report) {
  return report.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace candela::python
