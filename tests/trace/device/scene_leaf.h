// Runs a leaf function's small shader that reads a scene, over arrays.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "host/trace/device/device_scene.h"
#include "host/trace/device/specialise.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/loop_limit.h"
#include "tests/trace/reference/default_settings.h"
#include "tests/trace/vulkan_support/test_device.h"

namespace candela::device {

/// The shader has the program's scene bindings, with the same specialisation as in the program. Its inputs and outputs
/// replace the path states and the film.
class SceneLeaf {
 public:
  SceneLeaf(std::span<const std::uint32_t> spirv, const scene::Scene& scene,
            const render::RenderSettings& settings = render::defaultSettings())
      : device_(openTestDevice()),
        flat_(flatten::flattenScene(scene, settings)),
        scene_(device_, flat_, render::SceneLoads::storage),
        pipeline_(device_, spirv, optionsFor(flat_.shape, settings)) {}

  /// Runs `lanes` lanes on `inputs`; the push constants are `lanes` and `task`. Returns `outputs` values that they
  /// wrote.
  template <typename Output, typename Input>
  std::vector<Output> run(const std::vector<Input>& inputs, std::size_t outputs, std::size_t lanes,
                          std::uint32_t task = 0) {
    // Memory that the host maps: copies through staging would take most of the time of a test on a discrete GPU.
    constexpr vulkan::Usage kUsage = vulkan::Usage::storage | vulkan::Usage::readback;
    vulkan::Buffer in(device_, inputs.size() * sizeof(Input), kUsage);
    vulkan::Buffer out(device_, outputs * sizeof(Output), kUsage);
    in.upload(std::as_bytes(std::span(inputs)));
    const vulkan::BindingSet bindings(
        pipeline_, {&scene_.rows(), &in, &out, &scene_.rows(), &scene_.texels(), &scene_.uniforms()});
    const std::array<std::uint32_t, 2> push{static_cast<std::uint32_t>(lanes), task};
    device_.run([&](vulkan::CommandRecorder& recorder) {
      recorder.dispatch(pipeline_, bindings, std::as_bytes(std::span(push)), {.x = (push[0] + 63) / 64});
    });
    std::vector<Output> result(outputs);
    out.download(std::as_writable_bytes(std::span(result)));
    return result;
  }

 private:
  vulkan::PipelineOptions optionsFor(const flatten::SceneShape& shape, const render::RenderSettings& settings) {
    const CodeForm form = codeFormOf(device_.info(), vulkan::probeLoopLimit(device_));
    return kernelOptions(form, shape, settings, false, 2 * sizeof(std::uint32_t));
  }

  vulkan::Device device_;
  flatten::FlatScene flat_;
  DeviceScene scene_;
  vulkan::ComputePipeline pipeline_;
};

}  // namespace candela::device
