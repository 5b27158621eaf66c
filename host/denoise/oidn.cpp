// Calls the C interface of Open Image Denoise 2.
#include "host/denoise/oidn.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <string>
#include <type_traits>

#include "host/core/errors.h"
#include "host/denoise/denoise.h"

namespace candela::denoise {
namespace {

constexpr const char* kLibrary = "libOpenImageDenoise.so.2";
constexpr const char* kRemedy =
    "unpack a release of https://github.com/RenderKit/oidn and add its folder `lib` to LD_LIBRARY_PATH, or use "
    "--denoise without a value";

// Values of OIDNDeviceType and OIDNFormat.
constexpr int kCpuDevice = 1;
constexpr int kFloat3 = 3;

void* symbolOf(void* library, const char* name) {
  void* const symbol = ::dlsym(library, name);
  if (symbol == nullptr) throw NoDeviceError(fmt::format("{} has no function {}; {}", kLibrary, name, kRemedy));
  return symbol;
}

void* openLibrary() {
  void* const library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* const reason = ::dlerror();
    throw NoDeviceError(fmt::format("--denoise oidn needs the library Open Image Denoise: {}; {}",
                                    reason != nullptr ? reason : kLibrary, kRemedy));
  }
  return library;
}

// The functions of the library that are used.
struct Functions {
  explicit Functions(void* library) {
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

  void* (*newDevice)(int type);
  void (*commitDevice)(void* device);
  void (*releaseDevice)(void* device);
  int (*deviceError)(void* device, const char** message);
  void* (*newFilter)(void* device, const char* type);
  void (*setImage)(void* filter, const char* name, void* pixels, int format, std::size_t width, std::size_t height,
                   std::size_t offset, std::size_t pixelStride, std::size_t rowStride);
  void (*setBool)(void* filter, const char* name, bool value);
  void (*commitFilter)(void* filter);
  void (*executeFilter)(void* filter);
  void (*releaseFilter)(void* filter);
};

const Functions& loadedFunctions() {
  static const Functions functions(openLibrary());
  return functions;
}

// A device of the library with one filter. The first error is thrown by execute().
class OidnFilter {
 public:
  OidnFilter(std::uint32_t width, std::uint32_t height) : width_(width), height_(height) {
    functions_.commitDevice(device_);
    filter_ = functions_.newFilter(device_, "RT");
  }
  ~OidnFilter() {
    functions_.releaseFilter(filter_);
    functions_.releaseDevice(device_);
  }
  OidnFilter(const OidnFilter&) = delete;
  OidnFilter& operator=(const OidnFilter&) = delete;

  void set(const char* name, std::vector<glm::vec3>& pixels) {
    functions_.setImage(filter_, name, pixels.data(), kFloat3, width_, height_, 0, 0, 0);
  }

  void execute() {
    functions_.setBool(filter_, "hdr", true);
    functions_.commitFilter(filter_);
    functions_.executeFilter(filter_);
    const char* message = nullptr;
    if (functions_.deviceError(device_, &message) == 0) return;
    throw NoDeviceError(fmt::format("Open Image Denoise: {}", message != nullptr ? message : "an unknown error"));
  }

 private:
  std::uint32_t width_, height_;
  const Functions& functions_ = loadedFunctions();
  void* device_ = functions_.newDevice(kCpuDevice);
  void* filter_ = nullptr;
};

}  // namespace

void requireOidn() { loadedFunctions(); }

void denoiseByOidn(image::Image& image, const image::Film& film) {
  requireStatistics(film);
  std::vector<glm::vec3> albedo, normal, result(image.rgb.size());
  for (const gpu::DenoisePixel& pixel : statisticsOf(film).pixels) {
    albedo.emplace_back(pixel.reflectance);
    normal.emplace_back(pixel.normal);
  }
  OidnFilter filter(film.width(), film.height());
  filter.set("color", image.rgb);
  filter.set("albedo", albedo);
  filter.set("normal", normal);
  filter.set("output", result);
  filter.execute();
  image.rgb = std::move(result);
  image.luminanceVariance.clear();
  image.metadata[kDenoisedMetadata] = "by Open Image Denoise, guided by normals and albedos";
}

}  // namespace candela::denoise
