// Draws the pictures of both sides with the display transform, on the device.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "host/app/view/engine.h"
#include "host/app/view/view_state.h"
#include "host/trace/vulkan/binding_set.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"
#include "shaders/shared/window_data.h"

namespace candela::window {

/// The pictures of a frame and their display settings.
struct PaintedView {
  render::Extent picture;
  std::array<std::shared_ptr<const view::Picture>, view::kSideCount> pictures;  ///< null: see `onDevice`
  std::optional<vulkan::Buffer> onDevice;  ///< device::FilmMeans::buffer(), of the device's side
  view::Mode mode;
  view::LayerColours colours;
  bool isLight = true;  ///< view::Picture::isLight
  const view::ViewState& state;
};

/// Converts pictures to 8-bit pixels of a window, within 1/255 of image::toDisplay().
class PicturePainter {
 public:
  explicit PicturePainter(vulkan::Device device);

  /// Allocates buffers for a window, and takes the pictures. No submission that uses the painter may be in flight.
  void prepare(const render::Extent& window, const PaintedView& view);
  /// Records the commands that fill pixels().
  void record(vulkan::CommandRecorder& recorder, const PaintedView& view, bool isBlueFirst);
  /// The pixels of the window, 4 bytes each, row by row from the top.
  const vulkan::Buffer& pixels() const { return *pixels_; }
  /// Returns the values below the pointer in the last finished submission.
  gpu::PointedValues pointed() const;

 private:
  /// The options for which a pipeline is compiled.
  using Variant = std::pair<view::Mode, image::ToneMap>;

  void upload(std::size_t side, const PaintedView& view);
  const vulkan::ComputePipeline& pipeline(const Variant& variant);

  vulkan::Device device_;
  std::map<Variant, vulkan::ComputePipeline> pipelines_;
  render::Extent window_;
  render::Extent picture_;
  std::optional<vulkan::Buffer> pixels_;
  vulkan::Buffer pointed_;
  std::array<std::optional<vulkan::Buffer>, view::kSideCount> uploads_;
  std::array<std::shared_ptr<const view::Picture>, view::kSideCount> uploaded_;
  std::optional<vulkan::Buffer> shown_;  ///< the device's picture that `bindings_` have
  std::optional<vulkan::BindingSet> bindings_;
};

}  // namespace candela::window
