// Computes the sizes of a band's buffers.
#include "host/trace/device/band_layout.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/image/film.h"
#include "host/trace/device/wavefront.h"

namespace candela::device {
namespace {

constexpr std::uint64_t kRecordBytes = gpu::kRecordedVertices * sizeof(gpu::uvec2);
constexpr std::uint64_t kHitListBytes = gpu::kListedHits * sizeof(gpu::uint);

std::uint64_t largestBytesPerPixel(const Kernel& kernel, const render::RenderSettings& settings) {
  const std::uint64_t path = std::max<std::uint64_t>(kernel.stateBytes, filmBytesPerPixel(settings));
  const std::uint64_t queues = recordOffset(kernel, 1) - recordOffset(kernel, 0);
  return settings.execution.recordPaths ? std::max(path, queues + kRecordBytes) : path;
}

}  // namespace

std::uint64_t filmBytesPerPixel(const render::RenderSettings& settings) {
  return sizeof(gpu::FilmRows) +
         sizeof(image::LayerRow) * image::layerRowCount(image::layerSumsOf(settings.image.layers)) +
         (hasMattes(settings.image.layers) ? kHitListBytes : 0);
}

std::uint64_t resultBytes(const Kernel& kernel, const render::RenderSettings& settings, std::uint64_t pixels) {
  return recordOffset(kernel, pixels) + (settings.execution.recordPaths ? kRecordBytes * pixels : sizeof(gpu::uvec2));
}

std::uint64_t hitListOffset(const render::RenderSettings& settings, std::uint64_t pixels) {
  return (filmBytesPerPixel(settings) - kHitListBytes) * pixels;
}

std::uint64_t recordOffset(const Kernel& kernel, std::uint64_t pixels) {
  return sizeof(gpu::Counters) + (kernel.isWavefront() ? queueBytes(pixels) : 0);
}

std::uint64_t bandRowBytes(const Kernel& kernel, const render::RenderSettings& settings) {
  const std::uint64_t width = settings.image.window().width;
  return (kernel.stateBytes + filmBytesPerPixel(settings)) * width + resultBytes(kernel, settings, width);
}

std::uint32_t bandHeight(const vulkan::DeviceInfo& info, const Kernel& kernel, const render::RenderSettings& settings,
                         std::uint64_t maxBytes) {
  const std::uint64_t rowBytes = largestBytesPerPixel(kernel, settings) * settings.image.window().width;
  const std::uint64_t allowedBytes = std::min(info.maxStorageBufferRange, maxBytes);
  const std::uint64_t header = recordOffset(kernel, 0);
  const std::uint64_t rows = allowedBytes <= header ? 0 : (allowedBytes - header) / rowBytes;
  if (rows == 0) {
    throw FileError(
        fmt::format("an image {} pixels wide needs {} KiB a row, but {} binds at most {} KiB: make it "
                    "narrower",
                    settings.image.window().width, rowBytes >> 10, info.name, allowedBytes >> 10));
  }
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(rows, settings.image.window().height));
}

}  // namespace candela::device
