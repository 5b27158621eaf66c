// Compiles the kernels of scenes, and relates their occupancy to that of an empty kernel.
#include "host/drivers/kernels/kernel_reporter.h"

#include <algorithm>

#include "host/base/hash_text.h"
#include "host/trace/device/code_form.h"
#include "host/trace/render/extent.h"
#include "host/trace/render/setting_names.h"

namespace candela::kernels {
namespace {

std::optional<double> invocationsOf(const vulkan::PipelineReport& report, const vulkan::DeviceInfo& info) {
  if (report.executables.empty()) return std::nullopt;
  return invocationsInFlight(report.executables.front(), info.minSubgroupSize);
}

std::optional<double> emptyInvocations(vulkan::Device& device) {
  return invocationsOf(reportPipeline(device, device::emptyKernel(), {}), device.info());
}

// Drivers count subgroups, and larger ones have more invocations.
std::optional<double> maxInvocations(vulkan::Device& device) {
  const std::optional<double> invocations = emptyInvocations(device);
  const vulkan::DeviceInfo& info = device.info();
  if (!invocations || info.maxSubgroupSize <= info.minSubgroupSize) return invocations;
  vulkan::Device widest = vulkan::Device::open(info, {.subgroupSize = info.maxSubgroupSize, .compilesOnly = true});
  return std::max(invocations, emptyInvocations(widest));
}

// Only a device that executes work can be measured.
render::SceneLoads fastestLoadsOf(const vulkan::DeviceInfo& info) {
  if (!info.isSoftware() || !info.usable) return render::SceneLoads::texel;
  vulkan::Device device = vulkan::Device::open(info);
  return device::fastestLoads(device);
}

}  // namespace

KernelReporter::KernelReporter(const std::string& selector)
    : device_(vulkan::Device::open(selector, {.compilesOnly = true})),
      fastestLoads_(fastestLoadsOf(device())),
      maxInvocations_(maxInvocations(device_)) {}

KernelRow KernelReporter::rowOf(const device::SceneKernels& kernels, std::size_t module) {
  vulkan::PipelineReport report = reportPipeline(device_, kernels.kernel.spirv[module], kernels.options);
  KernelRow row;
  row.kernel = moduleName(kernels.kernel, module);
  row.workgroup = render::extentText(kernels.workgroup);
  row.structure = nameOf(kernels.structure.accel);
  row.layout = nameOf(kernels.layout);
  row.sceneLoads = nameOf(kernels.loads);
  if (!report.executables.empty()) row.figures = normalise(report.executables.front(), device().driverName);
  const std::optional<double> invocations = invocationsOf(report, device());
  if (invocations && maxInvocations_) row.figures.occupancy = *invocations / *maxInvocations_;
  row.figures.spirvBytes = static_cast<double>(report.spirvBytes);
  row.figures.cacheBytes = static_cast<double>(report.cacheBytes);
  row.figures.compileSeconds = report.seconds;
  row.executables = std::move(report.executables);
  return row;
}

std::vector<KernelRow> KernelReporter::rowsOf(const scene::Scene& scene, render::RenderSettings settings) {
  render::SceneLoads& loads = settings.execution.automatic.sceneLoads;
  if (loads == render::SceneLoads::automatic) loads = fastestLoads_;
  const device::SceneKernels kernels = device::kernelsOf(device(), scene, settings);
  std::vector<KernelRow> rows;
  for (std::size_t module = 0; module < kernels.kernel.spirv.size(); ++module) {
    rows.push_back(rowOf(kernels, module));
    rows.back().scene = scene.name;
    rows.back().sceneHash = hashText(scene.hash);
  }
  return rows;
}

}  // namespace candela::kernels
