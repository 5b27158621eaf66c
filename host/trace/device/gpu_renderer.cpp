// Creates the device renderer.
#include "host/trace/device/gpu_renderer.h"

#include "host/trace/device/gpu_session.h"
#include "host/trace/vulkan/loop_limit.h"

namespace candela::device {
namespace {

class GpuRenderer final : public render::Renderer {
 public:
  explicit GpuRenderer(std::shared_ptr<DeviceContext> context) : context_(std::move(context)) {}

  std::unique_ptr<render::Session> prepare(const scene::Scene& scene, const render::RenderSettings& settings) override {
    return std::make_unique<GpuSession>(context_, scene, settings);
  }

 private:
  std::shared_ptr<DeviceContext> context_;
};

}  // namespace

std::unique_ptr<render::Renderer> makeGpuRenderer(const std::string& selector, const GpuRendererOptions& options) {
  return makeGpuRenderer(vulkan::Device::open(selector), options);
}

std::unique_ptr<render::Renderer> makeGpuRenderer(vulkan::Device device, const GpuRendererOptions& options) {
  const std::uint32_t loopLimit = options.loopLimit ? *options.loopLimit : vulkan::probeLoopLimit(device);
  const CodeForm form = options.form ? *options.form : codeFormOf(device.info(), loopLimit);
  // A context cannot be moved, and Clang 14 does not make aggregates in place by std::make_shared().
  return std::make_unique<GpuRenderer>(
      std::shared_ptr<DeviceContext>(new DeviceContext{std::move(device), loopLimit, form, options.maxBandBytes}));
}

}  // namespace candela::device
