// The form of code that GPUs get has the film and the counts of that for processors. Both run on the device under test.
#include "host/trace/device/code_form.h"

#include <catch2/catch.hpp>

#include "host/trace/vulkan/loop_limit.h"
#include "tests/scene/generate/generated_text.h"
#include "tests/trace/render/render_support.h"
#include "tests/trace/vulkan_support/test_device.h"

using namespace candela;
using namespace candela::device;

namespace {

constexpr CodeForm kForProcessors{.masksLanes = true, .limitsLoops = true};
constexpr CodeForm kForGpus{.masksLanes = false, .limitsLoops = false};

class BothForms {
 public:
  void requireSame(const scene::Scene& scene, const render::RenderSettings& settings) {
    const render::RenderResult processors = forProcessors_->render(scene, settings, {});
    const render::RenderResult gpus = forGpus_->render(scene, settings, {});
    CHECK(gpus.film.hash() == processors.film.hash());
    requireEqualCounts(gpus.statistics, processors.statistics);
  }
  void requireSameOfBothKernels(const scene::Scene& scene, render::RenderSettings settings) {
    for (const render::KernelKind kernel : {render::KernelKind::megakernel, render::KernelKind::wavefront}) {
      CAPTURE(static_cast<int>(kernel));
      settings.execution.kernel = kernel;
      requireSame(scene, settings);
    }
  }

 private:
  static std::unique_ptr<render::Renderer> rendererOf(const CodeForm& form) {
    return makeGpuRenderer(testDevice(), {.loopLimit = std::nullopt, .form = form});
  }

  std::unique_ptr<render::Renderer> forProcessors_ = rendererOf(kForProcessors);
  std::unique_ptr<render::Renderer> forGpus_ = rendererOf(kForGpus);
};

render::RenderSettings formSettings() {
  render::RenderSettings settings = squareSettings(40, 3);
  settings.image.size.height = 27;  // not a multiple of any workgroup
  settings.image.maxDepth = 9;
  return settings;
}

vulkan::DeviceInfo deviceOfType(const std::string& type) {
  vulkan::DeviceInfo info;
  info.type = type;
  return info;
}

}  // namespace

TEST_CASE("devices in software get the code for processors, and others that stop loops count the loops") {
  const CodeForm software = codeFormOf(deviceOfType("CPU"), vulkan::kUnlimitedIterations);
  CHECK(software.masksLanes);
  CHECK(software.limitsLoops);
  for (const char* type : {"discrete GPU", "integrated GPU", "virtual GPU", "other"}) {
    CAPTURE(type);
    CHECK_FALSE(codeFormOf(deviceOfType(type), vulkan::kUnlimitedIterations).masksLanes);
    CHECK_FALSE(codeFormOf(deviceOfType(type), vulkan::kUnlimitedIterations).limitsLoops);
    CHECK(codeFormOf(deviceOfType(type), 65535).limitsLoops);
  }
}

TEST_CASE("a scene is read from storage buffers, unless they take clearly longer than texels") {
  // Times of lavapipe in milliseconds: 22.3.6, 25.0.7, 26.1.6.
  CHECK(fasterLoads({.texel = 0.31, .storage = 0.53}) == render::SceneLoads::texel);
  CHECK(fasterLoads({.texel = 0.19, .storage = 0.265}) == render::SceneLoads::texel);
  CHECK(fasterLoads({.texel = 0.208, .storage = 0.227}) == render::SceneLoads::storage);
  vulkan::Device device = openTestDevice();
  const vulkan::LoadTimes times = vulkan::probeLoads(device);
  CHECK(times.texel > 0);
  CHECK(times.storage > 0);
  CHECK(times.texel < 10);
  CHECK(times.storage < 10);
}

TEST_CASE("the code for GPUs gives the same film and counts with every structure and kernel", "[swiftshader-slow]") {
  BothForms forms;
  const scene::Scene scene = primitivesUnderLights();
  for (const render::AccelKind accel : {render::AccelKind::none, render::AccelKind::grid, render::AccelKind::bvh}) {
    CAPTURE(static_cast<int>(accel));
    render::RenderSettings settings = formSettings();
    settings.structure.accel = accel;
    forms.requireSameOfBothKernels(scene, settings);
  }
  render::RenderSettings settings = formSettings();
  settings.structure.bvhLayout = render::BvhLayout::bvh2;
  forms.requireSameOfBothKernels(scene, settings);
}

TEST_CASE("the code for GPUs gives the same film and counts of instances and of a mesh", "[swiftshader-slow]") {
  BothForms forms;
  forms.requireSameOfBothKernels(generatedScene("forest", 6).scene, formSettings());
  forms.requireSameOfBothKernels(generatedScene("sphere", 24).scene, formSettings());
}

TEST_CASE("the code for GPUs gives the same film of Whitted's tracer and of views", "[swiftshader-slow]") {
  BothForms forms;
  render::RenderSettings settings = formSettings();
  settings.image.maxDepth = 4;
  for (const render::Integrator integrator : {render::Integrator::whitted, render::Integrator::ao}) {
    CAPTURE(static_cast<int>(integrator));
    settings.image.integrator = integrator;
    forms.requireSame(primitivesUnderLights(), settings);
  }
}
