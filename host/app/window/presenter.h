// Frames of a window: the swapchain, and the submission of each frame.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vulkan/vulkan_raii.hpp>

#include "host/trace/render/extent.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/command_recorder_impl.h"

namespace candela::window {

/// Presents frames on the queue that the device renders with, from the thread of the window. One frame is in flight at
/// a time. Errors of Vulkan are thrown as in host/trace/vulkan.
class Presenter {
 public:
  /// The commands of a frame: `recorder` records compute commands and copies, `commands` all others.
  struct Frame {
    vulkan::CommandRecorder::Impl recorder;
    const vk::raii::CommandBuffer& commands;
    vk::Image image;
    vk::Framebuffer framebuffer;
    vk::Extent2D size;
  };

  /// The device must be able to present (Device::canPresent). Throws NoDeviceError if it cannot present to this
  /// surface.
  Presenter(vulkan::Device device, vk::raii::SurfaceKHR surface, const render::Extent& size);
  ~Presenter();
  Presenter(const Presenter&) = delete;
  Presenter& operator=(const Presenter&) = delete;

  /// Sets the size of the following frames, if the surface permits it.
  void resize(const render::Extent& size);
  /// Returns whether frames of another size were requested last, or the surface has changed: resize() must be called.
  bool mustResize(const render::Extent& size) const { return mustRecreate_ || size != wanted_; }
  /// Size of the frames; 0 x 0 while the window is minimised.
  render::Extent size() const { return {extent_.width, extent_.height}; }
  bool isBlueFirst() const { return format_ == vk::Format::eB8G8R8A8Unorm; }
  /// Into which `Frame::framebuffer` is drawn: one colour attachment, which preserves its content and is in the layout
  /// eColorAttachmentOptimal before.
  vk::RenderPass renderPass() const { return *renderPass_; }
  vulkan::Device& device() { return device_; }

  /// Waits until the last frame is finished: its inputs may then be overwritten. Throws DeviceLostError if work on the
  /// device fails meanwhile, on whichever thread.
  void waitForLastFrame();
  /// Records and presents a frame. Returns false if the window has no room for one, if the surface has changed, or if
  /// no image of the swapchain becomes free, for example while the window is hidden: the frame is then to be drawn
  /// later.
  bool draw(const std::function<void(const Frame&)>& record);

 private:
  void chooseFormat();
  void makeRenderPass();
  void makeSwapchain();
  void makeTargets();
  vk::PresentModeKHR presentMode() const;
  void waitForPresentation();
  std::optional<std::uint32_t> acquire();
  void submit(std::uint32_t image);
  void present(std::uint32_t image);

  vulkan::Device device_;
  vk::raii::SurfaceKHR surface_;
  render::Extent wanted_;  ///< the size that was requested last
  bool mustRecreate_ = false;
  vk::Format format_{};
  vk::ColorSpaceKHR colourSpace_{};
  vk::Extent2D extent_;
  vk::raii::RenderPass renderPass_{nullptr};
  vk::raii::SwapchainKHR swapchain_{nullptr};
  std::vector<vk::Image> images_;
  std::vector<vk::raii::ImageView> views_;
  std::vector<vk::raii::Framebuffer> framebuffers_;
  std::vector<vk::raii::Semaphore> drawn_;  ///< one for each image
  vk::raii::Semaphore acquired_{nullptr};
  vk::raii::CommandPool pool_{nullptr};
  vk::raii::CommandBuffer commands_{nullptr};
  vk::raii::Fence fence_{nullptr};
};

/// Records the copy of pixels to the frame's image, which is then in the layout eColorAttachmentOptimal.
void copyToImage(const Presenter::Frame& frame, const vulkan::Buffer& pixels);

}  // namespace candela::window
