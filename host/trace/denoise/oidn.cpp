// Calls the C interface of Open Image Denoise 2.
#include "host/trace/denoise/oidn.h"

#include <fmt/format.h>

#include <string>

#include "host/base/errors.h"
#include "host/trace/denoise/denoise.h"
#include "host/trace/denoise/oidn_library.h"

namespace candela::denoise {
namespace {

// Values of OIDNDeviceType and OIDNFormat.
constexpr int kCpuDevice = 1;
constexpr int kFloat3 = 3;

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
  const OidnFunctions& functions_ = loadedFunctions();
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
