// Traces rays on a device and returns their hits.
#include "host/measure/bench/device_tracer.h"

namespace candela::bench {
namespace {

template <class Choice>
std::vector<Choice> choices(Choice asked, Choice first, Choice second) {
  return asked == Choice::automatic ? std::vector{first, second} : std::vector{asked};
}

}  // namespace

DeviceTracer::DeviceTracer(vulkan::Device& device, const flatten::FlatScene& flat,
                           const render::RenderSettings& settings)
    : onGpu_(!device.info().isSoftware()), caster_(device, flat, settings) {}

render::LayoutInUse DeviceTracer::layout() const {
  const render::LayoutInUse layout = caster_.shape().layout();
  return layout == render::LayoutInUse::none ? render::LayoutInUse::list : layout;
}

std::vector<std::unique_ptr<DeviceTracer>> deviceTracers(vulkan::Device& device, const scene::Scene& scene,
                                                         const render::RenderSettings& asked) {
  std::vector<std::unique_ptr<DeviceTracer>> tracers;
  render::RenderSettings settings = asked;
  settings.structure.accel = render::AccelKind::bvh;
  for (const render::BvhLayout layout :
       choices(asked.structure.bvhLayout, render::BvhLayout::bvh2, render::BvhLayout::cwbvh)) {
    settings.structure.bvhLayout = layout;
    const flatten::FlatScene flat = flatten::flattenScene(scene, settings);
    const bool any = device::canBind(device.info(), flat, render::SceneLoads::automatic);
    for (const render::SceneLoads loads :
         choices(asked.execution.sceneLoads, render::SceneLoads::texel, render::SceneLoads::storage)) {
      settings.execution.sceneLoads = loads;
      // If the scene does not fit with either, the constructor reports the excess.
      if (asked.execution.sceneLoads == render::SceneLoads::automatic && any &&
          !device::canBind(device.info(), flat, loads))
        continue;
      tracers.push_back(std::make_unique<DeviceTracer>(device, flat, settings));
    }
  }
  return tracers;
}

}  // namespace candela::bench
