// Lists the devices in Python.
#include "host/app/python/device_function.h"

#include "host/app/cli/device_list.h"
#include "host/app/python/json.h"
#include "host/app/python/python_log.h"
#include "host/app/python/watched.h"
#include "host/base/json_text.h"

namespace candela::python {
namespace {

namespace py = pybind11;

py::object devices() {
  PythonLog log;
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  runWatched([&](const Watch&) {
    for (const cli::ListedDevice& device : cli::listedDevices("", log)) list.push_back(toJson(device));
  });
  log.passOn();
  return fromJson(jsonText(list));
}

}  // namespace

void defineDevices(py::module_& module) {
  module.def("devices", &devices,
             "devices() -> list\n\nReturns a dict for each Vulkan device, as the array `devices` of candela devices "
             "--json. Raises NoDeviceError if there is none.");
}

}  // namespace candela::python
