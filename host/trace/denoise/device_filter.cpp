// Filters bands of rows. A band's buffer also has the rows around it that its windows and patches reach.
#include "host/trace/denoise/device_filter.h"

#include <algorithm>

#include "host/base/divide_up.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "spirv/denoise.h"

namespace candela::denoise {
namespace {

using gpu::DenoiseConstants;
using gpu::DenoisePixel;

constexpr std::uint32_t kReach = gpu::kDenoiseRadius + gpu::kDenoisePatchRadius;

/// The rows that are filtered together, and those that the device reads for it.
struct RowBand {
  std::uint32_t first, end, readFirst, readEnd;
};

RowBand bandAt(const PixelStatistics& statistics, std::uint32_t first, std::uint32_t rows) {
  const std::uint32_t end = std::min(first + rows, statistics.height);
  return {first, end, first - std::min(first, kReach), std::min(end + kReach, statistics.height)};
}

std::uint32_t rowsPerBand(const PixelStatistics& statistics, std::uint64_t maxBandBytes) {
  const std::uint64_t rowBytes = std::uint64_t{statistics.width} * (sizeof(DenoisePixel) + sizeof(glm::vec4));
  const std::uint64_t rows = maxBandBytes / rowBytes;
  return rows > 2 * kReach + 1 ? static_cast<std::uint32_t>(rows - 2 * kReach) : 1;
}

class DeviceFilter {
 public:
  DeviceFilter(vulkan::Device& device, const PixelStatistics& statistics, std::uint32_t maxDispatchPixels)
      : device_(device),
        statistics_(statistics),
        rowsPerDispatch_(std::max(1u, maxDispatchPixels / statistics.width)),
        pipeline_(
            device, spirv::denoise,
            {{vulkan::BindingKind::storageBuffer, vulkan::BindingKind::storageBuffer}, sizeof(DenoiseConstants)}) {}

  void run(const RowBand& band, std::span<glm::vec4> light) {
    const std::size_t width = statistics_.width;
    const auto pixels = std::span(statistics_.pixels)
                            .subspan(band.readFirst * width, (band.readEnd - band.readFirst) * width);
    vulkan::Buffer input(device_, pixels.size_bytes(), vulkan::Usage::storage);
    const vulkan::Buffer output(device_, light.size_bytes(), vulkan::Usage::storage);
    input.upload(std::as_bytes(pixels));
    const vulkan::BindingSet bindings(pipeline_, {&input, &output});
    for (std::uint32_t first = band.first; first < band.end; first += rowsPerDispatch_) {
      dispatch(band, first, std::min(first + rowsPerDispatch_, band.end), bindings);
    }
    output.download(std::as_writable_bytes(light));
  }

 private:
  void dispatch(const RowBand& band, std::uint32_t first, std::uint32_t end, const vulkan::BindingSet& bindings) {
    const DenoiseConstants constants{.width = statistics_.width,
                                     .rows = band.readEnd - band.readFirst,
                                     .firstRow = first - band.readFirst,
                                     .endRow = end - band.readFirst,
                                     .firstResultRow = band.first - band.readFirst};
    const vulkan::GroupCount groups{divideUp(statistics_.width, gpu::kDenoiseWorkgroupSide),
                                    divideUp(end - first, gpu::kDenoiseWorkgroupSide)};
    device_.run([&](vulkan::CommandRecorder& recorder) {
      recorder.dispatch(pipeline_, bindings, std::as_bytes(std::span(&constants, 1)), groups);
    });
  }

  vulkan::Device& device_;
  const PixelStatistics& statistics_;
  std::uint32_t rowsPerDispatch_;
  vulkan::ComputePipeline pipeline_;
};

}  // namespace

std::vector<glm::vec3> filterOnDevice(vulkan::Device& device, const PixelStatistics& statistics,
                                      const FilterDivision& division) {
  DeviceFilter filter(device, statistics, division.maxDispatchPixels);
  std::vector<glm::vec3> light;
  light.reserve(statistics.pixels.size());
  std::vector<glm::vec4> results;
  const std::uint32_t rows = rowsPerBand(statistics, division.maxBandBytes);
  for (std::uint32_t first = 0; first < statistics.height; first += rows) {
    const RowBand band = bandAt(statistics, first, rows);
    results.resize(std::size_t{band.end - band.first} * statistics.width);
    filter.run(band, results);
    light.insert(light.end(), results.begin(), results.end());
  }
  return light;
}

}  // namespace candela::denoise
