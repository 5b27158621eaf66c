// `candela bench rays`: times the tracing of rays, with every node layout that the device supports.
#include <fmt/format.h>

#include "host/app/cli/bench_output.h"
#include "host/app/cli/commands.h"
#include "host/app/cli/render_job.h"
#include "host/app/cli/tuned.h"
#include "host/base/interrupt.h"
#include "host/measure/bench/device_tracer.h"
#include "host/measure/bench/ray_report.h"

namespace candela::cli {
namespace {

using bench::DeviceTracer;
using bench::RayMeasurement;
using bench::RayReport;
using bench::RayTracer;

// Returns false if it was interrupted.
bool measureScene(vulkan::Device& device, const RenderJob& job, const Log& log, RayReport& report) {
  const auto tracers = bench::deviceTracers(device, job.scene(), job.settings);
  const device::RaySets sets = tracers.front()->makeRays();
  log.note(fmt::format("{}: {} primary, {} diffuse and {} shadow rays, {} layouts, runs of each: {}", job.scene().name,
                       sets[gpu::kPrimaryRay].size(), sets[gpu::kDiffuseRay].size(), sets[gpu::kShadowRay].size(),
                       tracers.size(), report.repeats));
  std::vector<RayTracer*> all;
  for (const auto& tracer : tracers) all.push_back(tracer.get());
  std::vector<RayMeasurement> measurements = bench::measureRays(all, sets, report.repeats, &watchInterrupts());
  for (std::size_t i = 0; i < measurements.size(); ++i) {
    const DeviceTracer& tracer = *tracers[i % tracers.size()];
    report.rows.push_back({job.scene().name, job.scene().hash, nameOf(tracer.layout()), tracer.sceneLoads(),
                           tracer.sceneBytes(), std::move(measurements[i])});
  }
  return !measurements.empty();
}

}  // namespace

ExitCode runBenchRays(const BenchArguments& arguments, const Log& log) {
  if (arguments.usesReference())
    throw UsageError("bench rays --device cpu: the rays of the reference tracer cannot be timed alone");
  CachedDevice cached(arguments, log);
  vulkan::Device& device = cached.device();
  const render::AutomaticChoices choices = automaticChoices(arguments, device.info(), log);
  RayReport report;
  report.device = device.info().name;
  report.driver = device.info().driver;
  report.repeats = arguments.repeats;
  for (std::size_t i = 1; i < arguments.files.size(); ++i) {
    BenchArguments one = arguments;
    one.files = {arguments.files[i]};
    RenderJob job = loadJob(one, log);
    job.settings.execution.automatic = choices;
    report.size = job.settings.image.size;
    report.workgroup = job.settings.execution.workgroupInUse();
    if (measureScene(device, job, log, report)) continue;
    log.note("interrupted; nothing is written");
    return ExitCode::interrupted;
  }
  return publish(report, arguments, log, "the hits of some layouts differ; their times are left out", arguments.svg);
}

}  // namespace candela::cli
