// Compares sizes with the memory of a device.
#include "host/trace/device/device_memory.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/memory_budget.h"
#include "host/base/setting_words.h"
#include "host/image/film.h"
#include "host/scene/memory.h"
#include "host/trace/device/gpu_session.h"

namespace candela::device {
namespace {

// Memory of the program, lavapipe and LLVM with the path tracer, which does not depend on the size of the image: 104 to
// 123 MiB if lavapipe has the kernel in its cache, and 123 to 184 MiB if it compiles it (docs/reliability.md).
constexpr std::uint64_t kDriverBytes = std::uint64_t{130} << 20;

}  // namespace

std::uint64_t hostMemoryNeed(const scene::Scene& scene, const render::RenderSettings& settings) {
  const render::Window window = settings.image.window();
  const std::uint64_t layerRows = image::layerRowCount(image::layerSumsOf(settings.image.layers));
  const std::uint64_t pixelBytes = sizeof(image::FilmPixel) + layerRows * sizeof(image::LayerRow);
  return kDriverBytes + scene::memoryOf(scene).total + 2 * pixelBytes * window.width * window.height;
}

std::uint64_t usableMemory(const vulkan::DeviceInfo& info, std::uint64_t hostBytes) {
  if (!info.isSoftware()) return info.memoryBytes;
  const std::uint64_t budget = memoryBudget();
  return std::min(info.memoryBytes, budget - std::min(budget, hostBytes));
}

std::uint64_t predictedMemory(const render::Session& session) {
  const auto* const onDevice = dynamic_cast<const GpuSession*>(&session);
  if (onDevice == nullptr || !onDevice->deviceInfo().isSoftware()) return 0;
  return onDevice->hostBytes() + onDevice->bufferBytes();
}

void requireDeviceMemory(const vulkan::DeviceInfo& info, std::uint64_t hostBytes, std::uint64_t sceneBytes,
                         std::uint64_t rowBytes) {
  const std::uint64_t usable = usableMemory(info, hostBytes);
  if (sceneBytes + rowBytes <= usable) return;
  const std::string besides = info.isSoftware()
                                  ? fmt::format(", since the driver, the scene and the films take {} of {} MiB",
                                                hostBytes >> 20, memoryBudget() >> 20)
                                  : "";
  throw DeviceLimitError(
      fmt::format("the scene needs {} MiB and a row of the image {} MiB on {}, which may use {} MiB{}: try {}, a "
                  "smaller image ({}), another device, or the reference tracer ({})",
                  sceneBytes >> 20, (rowBytes >> 20) + 1, info.name, usable >> 20, besides,
                  settingWords("layout", "cwbvh"), settingWords("size"), settingWords("device", "cpu")));
}

}  // namespace candela::device
