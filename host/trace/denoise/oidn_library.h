// The C interface of Open Image Denoise 2.
#pragma once
#include <cstddef>

namespace candela::denoise {

/// The functions of the library that are used.
struct OidnFunctions {
  /// Throws NoDeviceError if the library lacks one of them.
  explicit OidnFunctions(void* library);

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

/// Returns the functions, which the first call loads. Throws NoDeviceError, with a remedy, if that fails.
const OidnFunctions& loadedFunctions();

}  // namespace candela::denoise
