// The graphics pipeline of the panels.
#include "host/app/window/gui_painter.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "host/base/errors.h"
#include "host/trace/vulkan/vulkan_errors.h"
#include "spirv/gui_fragment.h"
#include "spirv/gui_vertex.h"

namespace candela::window {
namespace {

using Layout = vk::ImageLayout;
using vulkan::MemoryPreference;

constexpr std::uint64_t kMinBufferBytes = 64 << 10;

std::uint32_t memoryTypeFor(const vulkan::Device::Impl& device, std::uint32_t allowed) {
  for (const bool isLocal : {true, false}) {
    for (std::uint32_t type = 0; type < device.memoryProperties.memoryTypeCount; ++type) {
      const vk::MemoryPropertyFlags flags = device.memoryProperties.memoryTypes[type].propertyFlags;
      if ((allowed >> type & 1u) != 0 && (!isLocal || (flags & vk::MemoryPropertyFlagBits::eDeviceLocal))) return type;
    }
  }
  throw InternalError("no type of memory can hold the fonts of a window");
}

struct GuiPush {
  std::array<float, 2> scale;
  std::array<float, 2> offset;
};

}  // namespace

GuiPainter::GuiPainter(vulkan::Device device, vk::RenderPass renderPass) : device_(std::move(device)) {
  vulkan::guarded("prepare the panels of a window", [&] {
    makeFont();
    makeDescriptors();
    makePipeline(renderPass);
  });
}

void GuiPainter::makeFont() {
  vulkan::Device::Impl& device = *device_.impl();
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  fontSize_ = vk::Extent3D(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), 1);
  const std::uint64_t bytes = std::uint64_t{4} * fontSize_.width * fontSize_.height;
  fontPixels_ = allocate(device, bytes, vk::BufferUsageFlagBits::eTransferSrc, MemoryPreference::host);
  std::memcpy(fontPixels_.mapped, pixels, bytes);
  font_ = device.handle.createImage({{},
                                     vk::ImageType::e2D,
                                     vk::Format::eR8G8B8A8Unorm,
                                     fontSize_,
                                     1,
                                     1,
                                     vk::SampleCountFlagBits::e1,
                                     vk::ImageTiling::eOptimal,
                                     vk::ImageUsageFlagBits::eSampled | vk::ImageUsageFlagBits::eTransferDst});
  const vk::MemoryRequirements needs = font_.getMemoryRequirements();
  fontMemory_ = device.handle.allocateMemory({needs.size, memoryTypeFor(device, needs.memoryTypeBits)});
  font_.bindMemory(*fontMemory_, 0);
  fontView_ = device.handle.createImageView({{},
                                             *font_,
                                             vk::ImageViewType::e2D,
                                             vk::Format::eR8G8B8A8Unorm,
                                             {},
                                             {vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1}});
  sampler_ = device.handle.createSampler({{},
                                          vk::Filter::eLinear,
                                          vk::Filter::eLinear,
                                          vk::SamplerMipmapMode::eNearest,
                                          vk::SamplerAddressMode::eClampToEdge,
                                          vk::SamplerAddressMode::eClampToEdge,
                                          vk::SamplerAddressMode::eClampToEdge});
}

void GuiPainter::makeDescriptors() {
  const vk::raii::Device& handle = device_.impl()->handle;
  constexpr auto kKind = vk::DescriptorType::eCombinedImageSampler;
  const vk::DescriptorSetLayoutBinding binding(0, kKind, 1, vk::ShaderStageFlagBits::eFragment);
  setLayout_ = handle.createDescriptorSetLayout({{}, binding});
  const vk::DescriptorPoolSize size(kKind, 1);
  pool_ = handle.createDescriptorPool({vk::DescriptorPoolCreateFlagBits::eFreeDescriptorSet, 1, size});
  const vk::DescriptorSetLayout setLayout = *setLayout_;
  set_ = std::move(handle.allocateDescriptorSets({*pool_, setLayout}).front());
  const vk::DescriptorImageInfo image(*sampler_, *fontView_, Layout::eShaderReadOnlyOptimal);
  handle.updateDescriptorSets(vk::WriteDescriptorSet(*set_, 0, 0, kKind, image), {});
  const vk::PushConstantRange push(vk::ShaderStageFlagBits::eVertex, 0, sizeof(GuiPush));
  layout_ = handle.createPipelineLayout({{}, setLayout, push});
}

void GuiPainter::makePipeline(vk::RenderPass renderPass) {
  const vk::raii::Device& handle = device_.impl()->handle;
  const vk::raii::ShaderModule vertex = handle.createShaderModule(
      {{}, spirv::gui_vertex.size_bytes(), spirv::gui_vertex.data()});
  const vk::raii::ShaderModule fragment = handle.createShaderModule(
      {{}, spirv::gui_fragment.size_bytes(), spirv::gui_fragment.data()});
  const std::array stages{vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eVertex, *vertex, "main"),
                          vk::PipelineShaderStageCreateInfo({}, vk::ShaderStageFlagBits::eFragment, *fragment, "main")};
  const vk::VertexInputBindingDescription binding(0, sizeof(ImDrawVert), vk::VertexInputRate::eVertex);
  const std::array attributes{
      vk::VertexInputAttributeDescription(0, 0, vk::Format::eR32G32Sfloat, offsetof(ImDrawVert, pos)),
      vk::VertexInputAttributeDescription(1, 0, vk::Format::eR32G32Sfloat, offsetof(ImDrawVert, uv)),
      vk::VertexInputAttributeDescription(2, 0, vk::Format::eR8G8B8A8Unorm, offsetof(ImDrawVert, col))};
  const vk::PipelineVertexInputStateCreateInfo input({}, binding, attributes);
  const vk::PipelineInputAssemblyStateCreateInfo assembly({}, vk::PrimitiveTopology::eTriangleList);
  const vk::PipelineViewportStateCreateInfo viewport({}, 1, nullptr, 1, nullptr);
  vk::PipelineRasterizationStateCreateInfo rasterization;
  rasterization.cullMode = vk::CullModeFlagBits::eNone;
  rasterization.lineWidth = 1;
  const vk::PipelineMultisampleStateCreateInfo samples({}, vk::SampleCountFlagBits::e1);
  using Flag = vk::ColorComponentFlagBits;
  const vk::PipelineColorBlendAttachmentState over(
      VK_TRUE, vk::BlendFactor::eSrcAlpha, vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd, vk::BlendFactor::eOne,
      vk::BlendFactor::eOneMinusSrcAlpha, vk::BlendOp::eAdd, Flag::eR | Flag::eG | Flag::eB | Flag::eA);
  const vk::PipelineColorBlendStateCreateInfo blend({}, VK_FALSE, vk::LogicOp::eCopy, over);
  constexpr std::array kDynamic{vk::DynamicState::eViewport, vk::DynamicState::eScissor};
  const vk::PipelineDynamicStateCreateInfo dynamic({}, kDynamic);
  vk::GraphicsPipelineCreateInfo info({}, stages, &input, &assembly, nullptr, &viewport, &rasterization, &samples,
                                      nullptr, &blend, &dynamic, *layout_, renderPass);
  pipeline_ = vk::raii::Pipeline(handle, nullptr, info);
}

void GuiPainter::fillFont(const Presenter::Frame& frame) {
  const vk::ImageSubresourceRange range(vk::ImageAspectFlagBits::eColor, 0, 1, 0, 1);
  vk::ImageMemoryBarrier barrier({}, vk::AccessFlagBits::eTransferWrite, Layout::eUndefined,
                                 Layout::eTransferDstOptimal, VK_QUEUE_FAMILY_IGNORED, VK_QUEUE_FAMILY_IGNORED, *font_,
                                 range);
  frame.commands.pipelineBarrier(vk::PipelineStageFlagBits::eTopOfPipe, vk::PipelineStageFlagBits::eTransfer, {}, {},
                                 {}, barrier);
  const vk::BufferImageCopy copy(0, 0, 0, {vk::ImageAspectFlagBits::eColor, 0, 0, 1}, {}, fontSize_);
  frame.commands.copyBufferToImage(*fontPixels_.handle, *font_, Layout::eTransferDstOptimal, copy);
  barrier.setSrcAccessMask(vk::AccessFlagBits::eTransferWrite).setDstAccessMask(vk::AccessFlagBits::eShaderRead);
  barrier.setOldLayout(Layout::eTransferDstOptimal).setNewLayout(Layout::eShaderReadOnlyOptimal);
  frame.commands.pipelineBarrier(vk::PipelineStageFlagBits::eTransfer, vk::PipelineStageFlagBits::eFragmentShader, {},
                                 {}, {}, barrier);
  isFontFilled_ = true;
}

void GuiPainter::upload(const ImDrawData& data) {
  const auto grow = [&](vulkan::RawBuffer& buffer, std::uint64_t bytes, vk::BufferUsageFlags usage) {
    if (buffer.bytes >= bytes && buffer.bytes > 0) return;
    buffer = allocate(*device_.impl(), std::max(2 * bytes, kMinBufferBytes), usage, MemoryPreference::host);
  };
  grow(vertices_, sizeof(ImDrawVert) * static_cast<std::uint64_t>(data.TotalVtxCount),
       vk::BufferUsageFlagBits::eVertexBuffer);
  grow(indices_, sizeof(ImDrawIdx) * static_cast<std::uint64_t>(data.TotalIdxCount),
       vk::BufferUsageFlagBits::eIndexBuffer);
  std::byte* vertex = vertices_.mapped;
  std::byte* index = indices_.mapped;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    vertex = std::ranges::copy(
                 std::as_bytes(std::span(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.Size))), vertex)
                 .out;
    index = std::ranges::copy(
                std::as_bytes(std::span(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.Size))), index)
                .out;
  }
}

void GuiPainter::drawLists(const vk::raii::CommandBuffer& commands, const ImDrawData& data) const {
  std::int32_t firstVertex = 0;
  std::uint32_t firstIndex = 0;
  for (int i = 0; i < data.CmdListsCount; ++i) {
    const ImDrawList& list = *data.CmdLists[i];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      const ImVec4& clip = command.ClipRect;
      const float left = std::max(clip.x, 0.0f), top = std::max(clip.y, 0.0f);
      const float right = std::min(clip.z, data.DisplaySize.x), bottom = std::min(clip.w, data.DisplaySize.y);
      if (right <= left || bottom <= top) continue;
      commands.setScissor(
          0, vk::Rect2D({static_cast<std::int32_t>(left), static_cast<std::int32_t>(top)},
                        {static_cast<std::uint32_t>(right - left), static_cast<std::uint32_t>(bottom - top)}));
      commands.drawIndexed(command.ElemCount, 1, firstIndex + command.IdxOffset,
                           firstVertex + static_cast<std::int32_t>(command.VtxOffset), 0);
    }
    firstVertex += list.VtxBuffer.Size;
    firstIndex += static_cast<std::uint32_t>(list.IdxBuffer.Size);
  }
}

void GuiPainter::record(const Presenter::Frame& frame, vk::RenderPass renderPass, const ImDrawData& data) {
  if (!isFontFilled_) fillFont(frame);
  upload(data);
  const vk::raii::CommandBuffer& commands = frame.commands;
  commands.beginRenderPass({renderPass, frame.framebuffer, {{0, 0}, frame.size}}, vk::SubpassContents::eInline);
  if (data.TotalVtxCount > 0) {
    commands.bindPipeline(vk::PipelineBindPoint::eGraphics, *pipeline_);
    commands.bindDescriptorSets(vk::PipelineBindPoint::eGraphics, *layout_, 0, *set_, {});
    commands.bindVertexBuffers(0, *vertices_.handle, vk::DeviceSize{0});
    commands.bindIndexBuffer(*indices_.handle, 0,
                             sizeof(ImDrawIdx) == 2 ? vk::IndexType::eUint16 : vk::IndexType::eUint32);
    const auto width = static_cast<float>(frame.size.width), height = static_cast<float>(frame.size.height);
    commands.setViewport(0, vk::Viewport(0, 0, width, height, 0, 1));
    commands.pushConstants<GuiPush>(*layout_, vk::ShaderStageFlagBits::eVertex, 0,
                                    GuiPush{{2 / width, 2 / height}, {-1, -1}});
    drawLists(commands, data);
  }
  commands.endRenderPass();
}

}  // namespace candela::window
