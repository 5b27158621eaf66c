// Uploads pictures that are on the host, and dispatches window.comp.
#include "host/app/window/picture_painter.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "host/base/divide_up.h"
#include "spirv/window.h"

namespace candela::window {
namespace {

using vulkan::BindingKind;
using vulkan::Usage;

constexpr std::uint32_t kGroupSide = 8;

glm::uvec2 pointedPixel(const PaintedView& view) {
  const auto pixel = pixelAt(view.state, view.picture, view.state.pointer);
  return pixel ? *pixel : glm::uvec2(gpu::kNoPixel);
}

gpu::WindowConstants constantsOf(const PaintedView& view, const render::Extent& window, bool isBlueFirst) {
  const view::ViewState& state = view.state;
  return {.valueOffset = glm::vec4(view.colours.offset, 0),
          .valueGain = glm::vec4(view.colours.gain, 0),
          .windowSize = {window.width, window.height},
          .pictureSize = {view.picture.width, view.picture.height},
          .origin = glm::vec2(state.placement.origin),
          .pointer = pointedPixel(view),
          .zoom = static_cast<float>(state.placement.zoom),
          .divider = static_cast<float>(state.divider * view.picture.width),
          .falseColourScale = view.colours.scale,
          .differenceGain = std::exp2(static_cast<float>(state.differenceStops)),
          .isBlueFirst = isBlueFirst ? 1u : 0u,
          .repeats = view.colours.repeats ? 1u : 0u,
          .hidesZero = view.colours.hidesZero ? 1u : 0u,
          .isLight = view.isLight ? 1u : 0u};
}

}  // namespace

PicturePainter::PicturePainter(vulkan::Device device)
    : device_(std::move(device)), pointed_(device_, sizeof(gpu::PointedValues), Usage::storage | Usage::readback) {
  std::ranges::fill(pointed_.mapped(), std::byte{0});
}

const vulkan::ComputePipeline& PicturePainter::pipeline(const Variant& variant) {
  if (const auto found = pipelines_.find(variant); found != pipelines_.end()) return found->second;
  const vulkan::PipelineOptions options{
      .bindings = std::vector(4, BindingKind::storageBuffer),
      .pushConstantBytes = sizeof(gpu::WindowConstants),
      .specialisations = {{gpu::kSpecWindowMode, static_cast<std::uint32_t>(variant.first)},
                          {gpu::kSpecWindowToneMap, static_cast<std::uint32_t>(variant.second)}}};
  return pipelines_.try_emplace(variant, device_, spirv::window, options).first->second;
}

void PicturePainter::upload(std::size_t side, const PaintedView& view) {
  const std::shared_ptr<const view::Picture>& picture = view.pictures[side];
  if (picture == uploaded_[side] || !picture) return;
  const auto bytes = std::as_bytes(std::span(picture->pixels));
  std::ranges::copy(bytes, uploads_[side]->mapped().begin());
  uploaded_[side] = picture;
}

void PicturePainter::prepare(const render::Extent& window, const PaintedView& view) {
  const bool resized = !pixels_ || window != window_;
  if (resized) pixels_.emplace(device_, std::uint64_t{4} * window.width * window.height, Usage::storage);
  window_ = window;
  const bool replaced = view.picture != picture_;
  for (std::size_t side = 0; side < view::kSideCount; ++side) {
    if (replaced) {
      const std::uint64_t bytes = sizeof(glm::vec4) * view.picture.width * view.picture.height;
      uploads_[side].emplace(device_, bytes, Usage::storage | Usage::readback);
      std::ranges::fill(uploads_[side]->mapped(), std::byte{0});
      uploaded_[side] = nullptr;
    }
    upload(side, view);
  }
  picture_ = view.picture;
  const vulkan::Buffer& device = view.onDevice ? *view.onDevice : *uploads_[0];
  if (!resized && !replaced && shown_ && shown_->impl() == device.impl()) return;
  shown_ = device;
  bindings_.emplace(pipeline({view.mode, view.colours.toneMap}),
                    std::vector<const vulkan::Buffer*>{&*shown_, &*uploads_[1], &*pixels_, &pointed_});
}

void PicturePainter::record(vulkan::CommandRecorder& recorder, const PaintedView& view, bool isBlueFirst) {
  const gpu::WindowConstants constants = constantsOf(view, window_, isBlueFirst);
  recorder.dispatch(pipeline({view.mode, view.colours.toneMap}), *bindings_, std::as_bytes(std::span(&constants, 1)),
                    {divideUp(window_.width, kGroupSide), divideUp(window_.height, kGroupSide), 1});
}

gpu::PointedValues PicturePainter::pointed() const {
  gpu::PointedValues values;
  std::ranges::copy(pointed_.mapped().first(sizeof values), std::as_writable_bytes(std::span(&values, 1)).begin());
  return values;
}

}  // namespace candela::window
