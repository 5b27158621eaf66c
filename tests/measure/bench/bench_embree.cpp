// Compares a device's traversal with Embree's, alternately on the same primitives and rays, by kind of rays.
// Not a test: machines differ. Built where Embree 3 is found (libembree-dev), on request:
//   ninja bench_embree && tests/measure/bench/bench_embree SCENE [pixels a side] [runs] [device]
#include <fmt/format.h>

#include "host/base/errors.h"
#include "host/formats/load_scene.h"
#include "host/measure/bench/device_tracer.h"
#include "host/measure/bench/ray_report.h"
#include "tests/measure/bench/embree_tracer.h"
#include "tests/trace/reference/default_settings.h"

using namespace candela;
using namespace candela::bench;

namespace {

// Rays near an edge may hit either side of it: maximum fraction of rays that may hit another primitive.
constexpr double kEdgeFraction = 0.01;

RayReport measure(const scene::Scene& scene, const render::RenderSettings& settings, std::uint32_t repeats,
                  const std::string& selector) {
  vulkan::Device device = vulkan::Device::open(selector);
  const auto tracers = deviceTracers(device, scene, settings);
  EmbreeTracer embree(scene);
  std::vector<RayTracer*> all;
  for (const auto& tracer : tracers) all.push_back(tracer.get());
  all.push_back(&embree);
  const device::RaySets sets = tracers.front()->makeRays();
  RayReport report{
      device.info().name, device.info().driver, settings.execution.workgroupInUse(), settings.image.size, repeats, {}};
  std::size_t place = 0;
  for (RayMeasurement& measurement : measureRays(all, sets, repeats, nullptr)) {
    const std::size_t i = place++ % all.size();
    RayRow row{scene.name, scene.hash, "Embree", std::nullopt, 0, std::move(measurement), 1 - kEdgeFraction};
    if (i < tracers.size()) {
      row = {scene.name,
             scene.hash,
             nameOf(tracers[i]->layout()),
             tracers[i]->sceneLoads(),
             tracers[i]->sceneBytes(),
             std::move(row.measurement)};
    }
    report.rows.push_back(std::move(row));
  }
  return report;
}

// Returns each layout's rate relative to that of Embree for the same kind of rays.
void printRatios(const RayReport& report) {
  for (const RayRow& row : report.rows) {
    for (const RayRow& peer : report.rows) {
      if (peer.tracer != "Embree" || row.tracer == "Embree" || peer.measurement.kind != row.measurement.kind) continue;
      fmt::print(
          "{:<8} {:<6} {:<8} {:.3f} of Embree by the clock, {:.3f} by processor time; Embree finds {:.4f} of the "
          "hits\n",
          rayKindName(row.measurement.kind), row.tracer, nameOf(row.sceneLoads),
          row.measurement.mraysPerSecond() / peer.measurement.mraysPerSecond(),
          row.measurement.mraysPerProcessorSecond() / peer.measurement.mraysPerProcessorSecond(),
          peer.measurement.equalFraction);
    }
  }
}

}  // namespace

int main(int argumentCount, char** arguments) {
  const auto argument = [&](int i, const char* otherwise) {
    return std::string(argumentCount > i ? arguments[i] : otherwise);
  };
  if (argumentCount < 2) {
    fmt::print("bench_embree SCENE [pixels a side] [runs] [device]\n");
    return static_cast<int>(ExitCode::usage);
  }
  try {
    render::RenderSettings settings = render::defaultSettings();
    const auto side = static_cast<std::uint32_t>(std::stoul(argument(2, "512")));
    settings.image.size = {side, side};
    const scene::Scene scene = formats::loadScene(arguments[1]).scene;
    const RayReport report = measure(scene, settings, static_cast<std::uint32_t>(std::stoul(argument(3, "5"))),
                                     argument(4, ""));
    fmt::print("{}\n", toText(report));
    printRatios(report);
  } catch (const std::exception& error) {
    fmt::print(stderr, "bench_embree: {}\n", error.what());
    return static_cast<int>(ExitCode::internal);
  }
}
