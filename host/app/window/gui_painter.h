// Draws the triangles of Dear ImGui.
#pragma once
#include <vulkan/vulkan_raii.hpp>

#include "host/app/window/presenter.h"
#include "host/trace/vulkan/device_impl.h"

struct ImDrawData;

namespace candela::window {

/// The atlas of fonts, the pipeline, and buffers that grow with the number of vertices. The context of Dear ImGui must
/// exist, and its fonts must not change.
class GuiPainter {
 public:
  GuiPainter(vulkan::Device device, vk::RenderPass renderPass);

  /// Records the render pass of a frame. No earlier frame may be in flight.
  void record(const Presenter::Frame& frame, vk::RenderPass renderPass, const ImDrawData& data);

 private:
  void makeFont();
  void makeDescriptors();
  void makePipeline(vk::RenderPass renderPass);
  void fillFont(const Presenter::Frame& frame);
  void upload(const ImDrawData& data);
  void drawLists(const vk::raii::CommandBuffer& commands, const ImDrawData& data) const;

  vulkan::Device device_;
  vk::raii::DeviceMemory fontMemory_{nullptr};
  vk::raii::Image font_{nullptr};
  vk::raii::ImageView fontView_{nullptr};
  vk::raii::Sampler sampler_{nullptr};
  vk::Extent3D fontSize_;
  vulkan::RawBuffer fontPixels_;
  bool isFontFilled_ = false;
  vk::raii::DescriptorSetLayout setLayout_{nullptr};
  vk::raii::DescriptorPool pool_{nullptr};
  vk::raii::DescriptorSet set_{nullptr};
  vk::raii::PipelineLayout layout_{nullptr};
  vk::raii::Pipeline pipeline_{nullptr};
  vulkan::RawBuffer vertices_;
  vulkan::RawBuffer indices_;
};

}  // namespace candela::window
