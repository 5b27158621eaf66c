// A substitute for Open Image Denoise with the functions that Candela uses. Its filter halves the colours and adds the
// albedo and the normal, so that a test sees each image. It fails for images that are one pixel wide.
#include <cstddef>
#include <cstring>
#include <map>
#include <string>

namespace {

struct Filter {
  std::map<std::string, float*> images;
  std::size_t width = 0, height = 0;
  bool isHdr = false, isCommitted = false;
};

bool isDeviceCommitted = false;
const char* error = nullptr;

}  // namespace

extern "C" {

void* oidnNewDevice(int type) { return type == 1 ? &isDeviceCommitted : nullptr; }
void oidnCommitDevice(void* device) { *static_cast<bool*>(device) = true; }
void oidnReleaseDevice(void* device) { *static_cast<bool*>(device) = false; }
int oidnGetDeviceError(void*, const char** message) {
  *message = error;
  return error == nullptr ? 0 : 1;
}
void* oidnNewFilter(void*, const char* type) {
  return isDeviceCommitted && std::strcmp(type, "RT") == 0 ? new Filter : nullptr;
}
void oidnSetSharedFilterImage(void* filter, const char* name, void* pixels, int format, std::size_t width,
                              std::size_t height, std::size_t, std::size_t, std::size_t) {
  if (format != 3) error = "the format is not FLOAT3";
  auto& f = *static_cast<Filter*>(filter);
  f.images[name] = static_cast<float*>(pixels);
  f.width = width;
  f.height = height;
}
void oidnSetFilterBool(void* filter, const char* name, bool value) {
  if (std::strcmp(name, "hdr") == 0) static_cast<Filter*>(filter)->isHdr = value;
}
void oidnCommitFilter(void* filter) { static_cast<Filter*>(filter)->isCommitted = true; }
void oidnExecuteFilter(void* filter) {
  auto& f = *static_cast<Filter*>(filter);
  if (!f.isHdr || !f.isCommitted) error = "the filter is not ready";
  if (f.width == 1) error = "the image is too narrow";
  if (error != nullptr) return;
  for (std::size_t i = 0; i < 3 * f.width * f.height; ++i)
    f.images["output"][i] = f.images["color"][i] / 2 + f.images["albedo"][i] + f.images["normal"][i];
}
void oidnReleaseFilter(void* filter) { delete static_cast<Filter*>(filter); }

}  // extern "C"
