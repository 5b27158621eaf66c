// The module candela._candela, which candela/__init__.py shows as candela.
#include <pybind11/pybind11.h>

#include "host/core/setting_words.h"
#include "host/core/version.h"
#include "host/python/device_function.h"
#include "host/python/errors.h"
#include "host/python/options.h"
#include "host/python/python_film.h"
#include "host/python/python_scene.h"
#include "host/python/rendering.h"
#include "host/python/running_call.h"
#include "host/python/verdicts.h"

PYBIND11_MODULE(_candela, module) {
  using namespace candela::python;
  pybind11::options options;
  options.disable_function_signatures();  // the stubs have better signatures
  candela::setSettingWords(&keywordWords);
  translateErrors();
  waitForCallsAtExit();
  module.attr("__version__") = candela::versionText();
  defineDevices(module);
  defineScene(module);
  defineFilm(module);
  defineRender(module);
  defineSession(module);
  defineVerdicts(module);
}
