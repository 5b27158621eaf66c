// The means of a film on the device, for windows that show it from there.
#pragma once
#include <optional>

#include "host/trace/render/session.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/compute_pipeline.h"
#include "host/trace/vulkan/device.h"

namespace candela::device {

/// A picture in device memory: for each pixel, row by row from the top, red, green, blue and the number of samples as
/// four floats, as in view::Picture.
class FilmMeans {
 public:
  FilmMeans(vulkan::Device device, const render::Extent& size);

  /// Replaces each pixel by the mean of the film's pixel at the same position, if that has samples. A pixel of a film
  /// of lower resolution covers several pixels of the picture. Returns false, and changes nothing, if the film of
  /// `session` is not on this device as a whole. It may be called while the session's advance() reports progress.
  bool update(render::Session& session);

  render::Extent size() const { return size_; }
  const vulkan::Buffer& buffer() const { return buffer_; }

 private:
  vulkan::Device device_;
  render::Extent size_;
  vulkan::Buffer buffer_;
  vulkan::ComputePipeline pipeline_;
};

}  // namespace candela::device
