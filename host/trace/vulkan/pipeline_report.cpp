// Creates a pipeline and reads what its driver reports.
#include "host/trace/vulkan/pipeline_report.h"

#include "host/base/stopwatch.h"
#include "host/trace/vulkan/compute_pipeline_impl.h"
#include "host/trace/vulkan/device.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

double valueOf(const vk::PipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
    case vk::PipelineExecutableStatisticFormatKHR::eBool32:
      return statistic.value.b32 == VK_FALSE ? 0 : 1;
    case vk::PipelineExecutableStatisticFormatKHR::eInt64:
      return static_cast<double>(statistic.value.i64);
    case vk::PipelineExecutableStatisticFormatKHR::eUint64:
      return static_cast<double>(statistic.value.u64);
    case vk::PipelineExecutableStatisticFormatKHR::eFloat64:
      break;
  }
  return statistic.value.f64;
}

std::vector<Executable> executablesOf(const vk::raii::Device& device, vk::Pipeline pipeline) {
  std::vector<Executable> executables;
  for (const auto& properties : device.getPipelineExecutablePropertiesKHR({pipeline})) {
    Executable executable{properties.name.data(), properties.subgroupSize, {}};
    const vk::PipelineExecutableInfoKHR info(pipeline, static_cast<std::uint32_t>(executables.size()));
    for (const auto& statistic : device.getPipelineExecutableStatisticsKHR(info))
      executable.statistics.push_back({statistic.name.data(), valueOf(statistic)});
    executables.push_back(std::move(executable));
  }
  return executables;
}

}  // namespace

PipelineReport reportPipeline(Device& device, std::span<const std::uint32_t> spirv, const PipelineOptions& options) {
  return guarded("create a compute pipeline", [&] {
    const Device::Impl& impl = *device.impl();
    const vk::raii::DescriptorSetLayout setLayout = makeSetLayout(impl.handle, options.bindings);
    const vk::raii::PipelineLayout layout = makeLayout(impl.handle, *setLayout, options.pushConstantBytes);
    const ShaderCode code = codeFor(impl, spirv, options);
    PipelineReport report;
    report.spirvBytes = std::span(code.words).size_bytes();
    const vk::raii::PipelineCache cache(impl.handle, vk::PipelineCacheCreateInfo());
    Stopwatch watch;
    const vk::raii::Pipeline pipeline = makePipeline(impl, cache, *layout, code, options);
    report.seconds = watch.lap();
    report.cacheBytes = cache.getData().size();
    if (!impl.reportsExecutables) return report;
    const vk::raii::PipelineCache unused(impl.handle, vk::PipelineCacheCreateInfo());
    const vk::raii::Pipeline captured = makePipeline(impl, unused, *layout, code, options,
                                                     vk::PipelineCreateFlagBits::eCaptureStatisticsKHR);
    report.executables = executablesOf(impl.handle, *captured);
    return report;
  });
}

}  // namespace candela::vulkan
