// Compiles the kernels of scenes, and relates their occupancy to that of an empty kernel.
#include "host/drivers/kernels/kernel_reporter.h"

#include <algorithm>

#include "host/base/hash_text.h"
#include "host/trace/render/extent.h"
#include "host/trace/render/setting_names.h"

namespace candela::kernels {
namespace {

std::optional<vulkan::Device> openWidest(const vulkan::DeviceInfo& info) {
  if (info.maxSubgroupSize <= info.minSubgroupSize) return std::nullopt;
  return vulkan::Device::open(info, {.subgroupSize = info.maxSubgroupSize, .compilesOnly = true});
}

std::optional<double> invocationsOf(const vulkan::PipelineReport& report, const vulkan::DeviceInfo& info) {
  if (report.executables.empty()) return std::nullopt;
  return invocationsInFlight(report.executables.front(), info.minSubgroupSize);
}

}  // namespace

KernelReporter::KernelReporter(const std::string& selector)
    : device_(vulkan::Device::open(selector, {.compilesOnly = true})), widest_(openWidest(device_.info())) {}

// Drivers count subgroups, and larger ones have more invocations.
std::optional<double> KernelReporter::maxInvocations(const render::Extent& workgroup) {
  std::optional<double> max;
  for (vulkan::Device* const device : {&device_, widest_ ? &*widest_ : nullptr}) {
    if (device == nullptr) continue;
    const vulkan::PipelineReport report = reportPipeline(*device, device::emptyKernel(),
                                                         device::emptyKernelOptions(workgroup));
    max = std::max(max, invocationsOf(report, device->info()));
  }
  return max;
}

KernelRow KernelReporter::rowOf(const device::SceneKernels& kernels, std::size_t module,
                                std::optional<double> maxInvocations) {
  vulkan::PipelineReport report = reportPipeline(device_, kernels.kernel.spirv[module], kernels.options);
  KernelRow row;
  row.kernel = moduleName(kernels.kernel, module);
  row.workgroup = render::extentText(kernels.workgroup);
  row.structure = nameOf(kernels.structure.accel);
  row.layout = nameOf(kernels.layout);
  row.sceneLoads = nameOf(kernels.loads);
  if (!report.executables.empty()) row.figures = normalise(report.executables.front());
  const std::optional<double> invocations = invocationsOf(report, device());
  if (invocations && maxInvocations) row.figures.occupancy = *invocations / *maxInvocations;
  row.figures.spirvBytes = static_cast<double>(report.spirvBytes);
  row.figures.cacheBytes = static_cast<double>(report.cacheBytes);
  row.figures.compileSeconds = report.seconds;
  row.executables = std::move(report.executables);
  return row;
}

std::vector<KernelRow> KernelReporter::rowsOf(const scene::Scene& scene, const render::RenderSettings& settings) {
  const device::SceneKernels kernels = device::kernelsOf(device(), scene, settings);
  const std::optional<double> max = maxInvocations(kernels.workgroup);
  std::vector<KernelRow> rows;
  for (std::size_t module = 0; module < kernels.kernel.spirv.size(); ++module) {
    rows.push_back(rowOf(kernels, module, max));
    rows.back().scene = scene.name;
    rows.back().sceneHash = hashText(scene.hash);
  }
  return rows;
}

}  // namespace candela::kernels
