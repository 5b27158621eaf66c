// Acquires, records, submits and presents.
#include "host/app/window/presenter.h"

#include <algorithm>
#include <limits>
#include <mutex>

#include "host/base/errors.h"
#include "host/trace/vulkan/buffer_impl.h"
#include "host/trace/vulkan/vulkan_errors.h"

namespace candela::window {
namespace {

using Access = vk::AccessFlagBits;
using Layout = vk::ImageLayout;
using Stage = vk::PipelineStageFlagBits;

constexpr std::uint64_t kSlice = 50'000'000;  // nanoseconds of a wait, after which events and failures are noticed
constexpr vk::ImageUsageFlags kUsage = vk::ImageUsageFlagBits::eTransferDst | vk::ImageUsageFlagBits::eColorAttachment;

constexpr vk::ImageSubresourceRange wholeColour() { return {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}; }

void transition(const vk::raii::CommandBuffer& commands, vk::Image image, Layout from, Layout to) {
  const vk::PipelineStageFlags stages = Stage::eTransfer | Stage::eColorAttachmentOutput;
  const vk::AccessFlags drawing = Access::eColorAttachmentRead | Access::eColorAttachmentWrite;
  const vk::ImageMemoryBarrier barrier(Access::eTransferWrite, Access::eTransferWrite | drawing, from, to,
                                       VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, image, wholeColour());
  commands.pipelineBarrier(stages, stages, {}, {}, {}, barrier);
}

// Frames are opaque, so that the alternatives show the same.
vk::CompositeAlphaFlagBitsKHR compositeAlphaOf(const vk::SurfaceCapabilitiesKHR& surface) {
  using Alpha = vk::CompositeAlphaFlagBitsKHR;
  for (const Alpha alpha : {Alpha::eOpaque, Alpha::eInherit, Alpha::ePreMultiplied}) {
    if (surface.supportedCompositeAlpha & alpha) return alpha;
  }
  return Alpha::ePostMultiplied;
}

}  // namespace

void copyToImage(const Presenter::Frame& frame, const vulkan::Buffer& pixels) {
  transition(frame.commands, frame.image, Layout::eUndefined, Layout::eTransferDstOptimal);
  const vk::Extent3D size(frame.size, 1);
  const vk::BufferImageCopy copy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, size);
  frame.commands.copyBufferToImage(*pixels.impl()->raw.handle, frame.image, Layout::eTransferDstOptimal, copy);
  transition(frame.commands, frame.image, Layout::eTransferDstOptimal, Layout::eColorAttachmentOptimal);
}

Presenter::Presenter(vulkan::Device device, vk::raii::SurfaceKHR surface, const render::Extent& size)
    : device_(std::move(device)), surface_(std::move(surface)), wanted_(size) {
  const vulkan::Device::Impl& impl = *device_.impl();
  vulkan::guarded("open a window's surface", [&] {
    if (!impl.physicalDevice.getSurfaceSupportKHR(impl.queueFamily, *surface_)) {
      throw NoDeviceError(impl.info.name + " cannot present to this display");
    }
    chooseFormat();
    makeRenderPass();
    acquired_ = impl.handle.createSemaphore({});
    fence_ = impl.handle.createFence({vk::FenceCreateFlagBits::eSignaled});
    pool_ = impl.handle.createCommandPool({vk::CommandPoolCreateFlagBits::eTransient, impl.queueFamily});
    const vk::CommandBufferAllocateInfo info(*pool_, vk::CommandBufferLevel::ePrimary, 1);
    commands_ = std::move(impl.handle.allocateCommandBuffers(info).front());
    makeSwapchain();
  });
}

Presenter::~Presenter() {
  try {
    waitForPresentation();
  } catch (const vk::SystemError&) {  // the device is lost, and uses nothing any more
  }
}

void Presenter::waitForPresentation() {
  vulkan::Device::Impl& impl = *device_.impl();
  if (*impl.presentQueue) impl.presentQueue.waitIdle();
  const std::scoped_lock lock(impl.queueMutex);
  impl.queue.waitIdle();
}

// 8 bits without a conversion, because the kernel encodes.
void Presenter::chooseFormat() {
  const std::vector<vk::SurfaceFormatKHR> formats = device_.impl()->physicalDevice.getSurfaceFormatsKHR(*surface_);
  const auto found = std::ranges::find_if(formats, [](const vk::SurfaceFormatKHR& each) {
    return each.format == vk::Format::eB8G8R8A8Unorm || each.format == vk::Format::eR8G8B8A8Unorm;
  });
  if (found == formats.end()) throw NoDeviceError("the display has no format with 8 bits for red, green and blue");
  format_ = found->format;
  colourSpace_ = found->colorSpace;
}

void Presenter::makeRenderPass() {
  const vk::AttachmentDescription colour({}, format_, vk::SampleCountFlagBits::e1, vk::AttachmentLoadOp::eLoad,
                                         vk::AttachmentStoreOp::eStore, vk::AttachmentLoadOp::eDontCare,
                                         vk::AttachmentStoreOp::eDontCare, Layout::eColorAttachmentOptimal,
                                         Layout::ePresentSrcKHR);
  const vk::AttachmentReference reference(0, Layout::eColorAttachmentOptimal);
  const vk::SubpassDescription subpass({}, vk::PipelineBindPoint::eGraphics, {}, reference);
  renderPass_ = device_.impl()->handle.createRenderPass({{}, colour, subpass});
}

// The images of `mailbox` never block. All surfaces have `fifo`.
vk::PresentModeKHR Presenter::presentMode() const {
  const auto modes = device_.impl()->physicalDevice.getSurfacePresentModesKHR(*surface_);
  const bool hasMailbox = std::ranges::find(modes, vk::PresentModeKHR::eMailbox) != modes.end();
  return hasMailbox ? vk::PresentModeKHR::eMailbox : vk::PresentModeKHR::eFifo;
}

void Presenter::makeSwapchain() {
  const vulkan::Device::Impl& impl = *device_.impl();
  const vk::SurfaceCapabilitiesKHR surface = impl.physicalDevice.getSurfaceCapabilitiesKHR(*surface_);
  extent_ = surface.currentExtent;
  if (extent_.width == std::numeric_limits<std::uint32_t>::max()) {
    extent_ = vk::Extent2D(std::clamp(wanted_.width, surface.minImageExtent.width, surface.maxImageExtent.width),
                           std::clamp(wanted_.height, surface.minImageExtent.height, surface.maxImageExtent.height));
  }
  mustRecreate_ = extent_.width == 0 || extent_.height == 0;
  if (mustRecreate_) return;
  if ((surface.supportedUsageFlags & kUsage) != kUsage) {
    throw NoDeviceError(impl.info.name + " cannot copy pictures to windows of this display; choose another device");
  }
  const std::uint32_t maxImageCount = surface.maxImageCount == 0 ? std::numeric_limits<std::uint32_t>::max()
                                                                 : surface.maxImageCount;
  vk::SwapchainCreateInfoKHR info({}, *surface_, std::min(surface.minImageCount + 1, maxImageCount), format_,
                                  colourSpace_, extent_, 1, kUsage);
  info.preTransform = surface.currentTransform;
  info.compositeAlpha = compositeAlphaOf(surface);
  info.presentMode = presentMode();
  info.clipped = VK_TRUE;
  info.oldSwapchain = *swapchain_;
  swapchain_ = vk::raii::SwapchainKHR(impl.handle, info);
  makeTargets();
}

void Presenter::makeTargets() {
  const vk::raii::Device& handle = device_.impl()->handle;
  framebuffers_.clear();
  views_.clear();
  drawn_.clear();
  images_.clear();
  for (const auto image : swapchain_.getImages()) {
    images_.emplace_back(image);
    views_.push_back(handle.createImageView({{}, images_.back(), vk::ImageViewType::e2D, format_, {}, wholeColour()}));
    const vk::ImageView view = *views_.back();
    framebuffers_.push_back(handle.createFramebuffer({{}, *renderPass_, view, extent_.width, extent_.height, 1}));
    drawn_.push_back(handle.createSemaphore({}));
  }
}

void Presenter::waitForLastFrame() {
  vulkan::guarded("wait for a frame", [&] {
    while (device_.impl()->handle.waitForFences(*fence_, VK_TRUE, kSlice) == vk::Result::eTimeout) {
      if (device_.hasFailed()) throw DeviceLostError(device_.info().name + " does not finish a frame of the window");
    }
  });
}

// All frames are finished, so that nothing uses the old swapchain's images.
void Presenter::resize(const render::Extent& size) {
  wanted_ = size;
  waitForLastFrame();
  vulkan::guarded("resize a window", [&] {
    waitForPresentation();
    makeSwapchain();
  });
}

void Presenter::submit(std::uint32_t image) {
  vulkan::Device::Impl& impl = *device_.impl();
  constexpr vk::PipelineStageFlags kWaiting = Stage::eTransfer;
  const vk::Semaphore acquired = *acquired_;
  const vk::Semaphore drawn = *drawn_[image];
  const vk::CommandBuffer commands = *commands_;
  const vk::SubmitInfo submission(acquired, kWaiting, commands, drawn);
  impl.handle.resetFences(*fence_);
  const std::scoped_lock lock(impl.queueMutex);
  try {
    impl.queue.submit(submission, *fence_);
  } catch (const vk::SystemError&) {  // nothing will signal the fence, for which the destructor waits
    fence_ = impl.handle.createFence({vk::FenceCreateFlagBits::eSignaled});
    throw;
  }
}

void Presenter::present(std::uint32_t image) {
  vulkan::Device::Impl& impl = *device_.impl();
  const vk::Semaphore drawn = *drawn_[image];
  const vk::SwapchainKHR swapchain = *swapchain_;
  const vk::PresentInfoKHR info(drawn, swapchain, image);
  const bool isShared = !*impl.presentQueue;
  std::unique_lock lock(impl.queueMutex, std::defer_lock);
  if (isShared) lock.lock();
  const vk::Result result = (isShared ? impl.queue : impl.presentQueue).presentKHR(info);
  mustRecreate_ = mustRecreate_ || result == vk::Result::eSuboptimalKHR;
}

// Returns the index of an image; nothing if none is free.
std::optional<std::uint32_t> Presenter::acquire() {
  const auto [result, image] = swapchain_.acquireNextImage(kSlice, *acquired_);
  if (result == vk::Result::eTimeout || result == vk::Result::eNotReady) return std::nullopt;
  mustRecreate_ = result == vk::Result::eSuboptimalKHR;
  return image;
}

bool Presenter::draw(const std::function<void(const Frame&)>& record) {
  if (extent_.width == 0 || extent_.height == 0) return false;
  waitForLastFrame();
  try {
    const std::optional<std::uint32_t> image = acquire();
    if (!image) return false;
    pool_.reset();
    commands_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
    const Frame frame{{*device_.impl(), commands_}, commands_, images_[*image], *framebuffers_[*image], extent_};
    record(frame);
    frame.recorder.makeVisibleToHost();
    commands_.end();
    submit(*image);
    present(*image);
    return true;
  } catch (const vk::OutOfDateKHRError&) {
    mustRecreate_ = true;
    return false;
  } catch (const vk::SystemError& error) {
    vulkan::throwTranslated(error, "present a frame");
  }
}

}  // namespace candela::window
