// Finds the functions of libglfw.so.3.
#include "host/app/window/glfw.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string>

#include "host/base/errors.h"

namespace candela::window {
namespace {

constexpr const char* kLibrary = "libglfw.so.3";

void* symbolOf(void* library, const char* name) {
  void* const symbol = dlsym(library, name);
  if (symbol == nullptr)
    throw NoDeviceError(fmt::format("{} has no function {}; install a newer version", kLibrary, name));
  return symbol;
}

Glfw loadGlfw() {
  void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw NoDeviceError(
        fmt::format("candela view needs {}, which is not installed; on Debian: apt-get install libglfw3", kLibrary));
  }
  Glfw glfw;
#define CANDELA_LOAD(name) glfw.name = reinterpret_cast<decltype(glfw.name)>(symbolOf(library, "glfw" #name));
  CANDELA_GLFW_FUNCTIONS(CANDELA_LOAD)
#undef CANDELA_LOAD
  return glfw;
}

void connect(const Glfw& glfw) {
  if (glfw.Init() == GLFW_TRUE) return;
  const char* reason = nullptr;
  glfw.GetError(&reason);
  throw NoDeviceError(fmt::format(
      "candela view cannot open a window: {}; it needs a display ($DISPLAY), which `xvfb-run` gives a machine without "
      "one; `candela render` needs none",
      reason != nullptr ? reason : "GLFW does not start"));
}

}  // namespace

const Glfw& openGlfw() {
  static const Glfw glfw = [] {
    Glfw loaded = loadGlfw();
    connect(loaded);
    return loaded;
  }();
  return glfw;
}

}  // namespace candela::window
