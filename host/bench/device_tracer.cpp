#include "host/bench/device_tracer.h"

#include <utility>

namespace candela::bench {
namespace {

template <class Choice>
std::vector<Choice> choices(Choice asked, Choice first, Choice second) {
  return asked == Choice::automatic ? std::vector{first, second} : std::vector{asked};
}

}  // namespace

DeviceTracer::DeviceTracer(vulkan::Device& device, FlatScene flat, const RenderSettings& settings)
    : caster_(device, std::move(flat), settings) {}

const char* DeviceTracer::layout() const {
  const char* const name = layoutName(caster_.scene().structure);
  return *name != '\0' ? name : "none";
}

std::vector<std::unique_ptr<DeviceTracer>> deviceTracers(vulkan::Device& device, const Scene& scene,
                                                         const RenderSettings& asked) {
  std::vector<std::unique_ptr<DeviceTracer>> tracers;
  RenderSettings settings = asked;
  settings.accel = AccelKind::bvh;
  for (const BvhLayout layout : choices(asked.bvhLayout, BvhLayout::bvh2, BvhLayout::cwbvh)) {
    settings.bvhLayout = layout;
    const FlatScene flat = flatten(scene, settings);
    const bool any = canBind(device.info(), flat, SceneLoads::automatic);
    for (const SceneLoads loads : choices(asked.sceneLoads, SceneLoads::texel, SceneLoads::storage)) {
      settings.sceneLoads = loads;
      // Of a scene that fits in no way, the constructor says what is too large.
      if (asked.sceneLoads == SceneLoads::automatic && any && !canBind(device.info(), flat, loads)) continue;
      tracers.push_back(std::make_unique<DeviceTracer>(device, flat, settings));
    }
  }
  return tracers;
}

}  // namespace candela::bench
