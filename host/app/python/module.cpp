// The module candela._candela, which candela/__init__.py shows as candela.
#include <pybind11/pybind11.h>

#include "host/app/python/device_function.h"
#include "host/app/python/errors.h"
#include "host/app/python/options.h"
#include "host/app/python/python_film.h"
#include "host/app/python/python_scene.h"
#include "host/app/python/rendering.h"
#include "host/app/python/running_call.h"
#include "host/app/python/verdicts.h"
#include "host/base/setting_words.h"
#include "host/base/version.h"

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
  defineSequence(module);
  defineVerdicts(module);
}
