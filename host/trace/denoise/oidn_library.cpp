// Loads Open Image Denoise 2, which the program is not linked with.
#include "host/trace/denoise/oidn_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <type_traits>

#include "host/base/errors.h"

namespace candela::denoise {
namespace {

constexpr const char* kLibrary = "libOpenImageDenoise.so.2";
constexpr const char* kRemedy =
    "unpack a release of https://github.com/RenderKit/oidn and add its folder `lib` to LD_LIBRARY_PATH, or denoise by "
    "the statistics of pixels";

void* symbolOf(void* library, const char* name) {
  void* const symbol = ::dlsym(library, name);
  if (symbol == nullptr) throw NoDeviceError(fmt::format("{} has no function {}; {}", kLibrary, name, kRemedy));
  return symbol;
}

void* openLibrary() {
  void* const library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    throw NoDeviceError(fmt::format("the library Open Image Denoise cannot be loaded: {}; {}",
                                    reason != nullptr ? reason : kLibrary, kRemedy));
  }
  return library;
}

}  // namespace

OidnFunctions::OidnFunctions(void* library) {
  const auto load = [&](auto& function, const char* name) {
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(symbolOf(library, name));
  };
  load(newDevice, "oidnNewDevice");
  load(commitDevice, "oidnCommitDevice");
  load(releaseDevice, "oidnReleaseDevice");
  load(deviceError, "oidnGetDeviceError");
  load(newFilter, "oidnNewFilter");
  load(setImage, "oidnSetSharedFilterImage");
  load(setBool, "oidnSetFilterBool");
  load(commitFilter, "oidnCommitFilter");
  load(executeFilter, "oidnExecuteFilter");
  load(releaseFilter, "oidnReleaseFilter");
}

const OidnFunctions& loadedFunctions() {
  static const OidnFunctions functions(openLibrary());
  return functions;
}

}  // namespace candela::denoise
