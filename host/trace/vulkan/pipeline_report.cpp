// Creates a pipeline and reads what its driver reports.
#include "host/trace/vulkan/pipeline_report.h"

#include <ctime>

#include "host/trace/vulkan/compute_pipeline_impl.h"
#include "host/trace/vulkan/device.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::vulkan {
namespace {

decltype(ExecutableStatistic::value) valueOf(const vk::PipelineExecutableStatisticKHR& statistic) {
  switch (statistic.format) {
    case vk::PipelineExecutableStatisticFormatKHR::eBool32:
      return statistic.value.b32 != VK_FALSE;
    case vk::PipelineExecutableStatisticFormatKHR::eInt64:
      return std::int64_t{statistic.value.i64};
    case vk::PipelineExecutableStatisticFormatKHR::eUint64:
      return std::uint64_t{statistic.value.u64};
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
    const std::clock_t start = std::clock();
    const vk::raii::Pipeline pipeline = makePipeline(impl, cache, *layout, code, options);
    report.seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
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
