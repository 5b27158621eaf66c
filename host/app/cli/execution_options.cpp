// Options of the execution of a render, which do not change the image.
#include "host/app/cli/option_groups.h"
#include "host/app/cli/option_kinds.h"

namespace candela::cli {
namespace {

constexpr std::uint32_t kMaxSegments = 1u << 20;
constexpr std::uint32_t kMaxWorkgroupSide = 1024;
constexpr std::uint32_t kMaxThreads = 1024;
constexpr float kMinGridDensity = 0.0625f;
constexpr float kMaxGridDensity = 64;

}  // namespace

// NOLINTBEGIN: each option is one row of any length.
// clang-format off
std::vector<Option> executionOptions() {
  constexpr OptionGroup kGroup = OptionGroup::execution;
  return {
    valued<DeviceArguments, commandsWith<DeviceArguments> & ~kDevices>({"--device", kGroup, "device that renders: its index in `candela devices` or a part of its name; `cpu`: the reference tracer"},
           deviceSelector(), [](auto& a) -> auto& { return a.device; }),
    valued<TracingArguments, kTracingButVerify>({"--accel", kGroup, "acceleration structure"},
           orAbsent(named<render::AccelKind>(), "the scene's `accel`, else bvh"), [](auto& a) -> auto& { return a.request.accel; }),
    valued<RequestArguments, commandsWith<RequestArguments> & ~kVerify>({"--bvh-split", kGroup, "how the nodes of a BVH are split: by the surface area heuristic, or at the midpoint of the longest axis"},
           named<render::BvhSplit>(), [](auto& a) -> auto& { return a.request.structure.bvhSplit; }),
    valued<RequestArguments, commandsWith<RequestArguments> & ~kVerify>({"--bvh-quality", kGroup, "build quality of a device's SAH BVH: `fast` builds faster, `high` traces faster"},
           named<render::BuildQuality>(), [](auto& a) -> auto& { return a.request.structure.bvhQuality; }),
    valued<TracingArguments>({"--layout", kGroup, "nodes of a device's BVH: binary (bvh2), or compressed and 8-wide (cwbvh); `auto`: as tuned, else cwbvh, or bvh2 with midpoint splits"},
           named<render::BvhLayout>(), [](auto& a) -> auto& { return a.request.structure.bvhLayout; }),
    valued<TracingArguments>({"--loads", kGroup, "buffer type through which a device reads the scene; `auto`: as tuned, else that with which the device reads faster, if the scene fits"},
           named<render::SceneLoads>(), [](auto& a) -> auto& { return a.request.execution.sceneLoads; }),
    valued<TracingArguments>({"--grid-density", kGroup, "density M of a grid, which has about M^3 cells per primitive"},
           realNumber<float>("M", kMinGridDensity, kMaxGridDensity), [](auto& a) -> auto& { return a.request.structure.gridDensity; }),
    valued<TracingArguments>({"--kernel", kGroup, "one kernel that traces whole paths, or one kernel per stage; `auto`: as tuned, else megakernel"},
           named<render::KernelKind>(), [](auto& a) -> auto& { return a.request.execution.kernel; }),
    valued<TracingArguments>({"--workgroup", kGroup, "workgroup size in invocations; `auto`: as tuned, else 8x8"},
           orAbsent(extent("XxY", kMaxWorkgroupSide), "auto"), [](auto& a) -> auto& { return a.request.execution.workgroup; }),
    valued<TracingArguments>({"--tile", kGroup, "size in pixels of the region that one dispatch processes; `auto`: chosen by timing"},
           orAbsent(extent("WxH", image::kMaxImageSide), "auto"), [](auto& a) -> auto& { return a.request.execution.tile; }),
    valued<TracingArguments>({"--segments-per-dispatch", kGroup, "maximum number of segments by which one dispatch advances a path; `auto`: chosen by timing"},
           orAbsent(wholeNumber(1, kMaxSegments), "auto"), [](auto& a) -> auto& { return a.request.execution.segmentsPerDispatch; }),
    valued<OpenDeviceArguments>({"--hang-timeout", kGroup, "time after which a device that has not finished its work counts as hung; 0s: never; `auto`: 50 times the longest dispatch and at least 10 s, or never on devices in software"},
           orAbsent(duration(0), "auto"), [](auto& a) -> auto& { return a.hangTimeout; }),
    valued<RenderArguments>({"--fallback", kGroup, "what finishes the render if the device fails permanently or no device is found; `cpu`: the reference tracer, and a film with samples of both is marked as mixed"},
           choice<job::Fallback>({{"none", job::Fallback::none}, {"cpu", job::Fallback::reference}}), [](auto& a) -> auto& { return a.film.fallback; }),
    valued<MemoryArguments>({"--memory", kGroup, "maximum memory to use; work that needs more is refused before memory is allocated"},
           orAbsent(byteCount(), "that of the machine or of its control group"), [](auto& a) -> auto& { return a.memory; }),
    flag<TracingArguments>({"--untuned", kGroup, "ignore the results of `candela tune`"}, [](auto& a) -> auto& { return a.untuned; }),
    flag<OpenDeviceArguments>({"--no-cache", kGroup, "neither read nor write compiled pipelines in the cache folder; the driver may have a cache of its own"},
         [](auto& a) -> auto& { return a.noCache; }),
    valued<TracingArguments>({"-t,--threads", kGroup, "threads of the reference tracer; 0: one per core"},
           wholeNumber(0, kMaxThreads), [](auto& a) -> auto& { return a.request.execution.threads; }),
  };
}
// clang-format on
// NOLINTEND

}  // namespace candela::cli
