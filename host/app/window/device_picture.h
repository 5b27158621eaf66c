// The picture of the device's side, which stays in device memory.
#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "host/trace/device/film_means.h"
#include "host/trace/vulkan/buffer.h"
#include "host/trace/vulkan/device.h"

namespace candela::window {

/// The means of the device's film. The engine's thread updates them, and the window's thread draws them.
class DevicePicture {
 public:
  explicit DevicePicture(vulkan::Device device) : device_(std::move(device)) {}

  /// Converts the film of a session; returns the result of device::FilmMeans::update().
  bool update(render::Session& session, const render::Extent& size) {
    const std::scoped_lock lock(mutex_);
    if (!means_ || means_->size() != size) means_ = std::make_unique<device::FilmMeans>(device_, size);
    return means_->update(session);
  }

  /// Returns the buffer, or nothing if there is no picture of this size.
  std::optional<vulkan::Buffer> buffer(const render::Extent& size) const {
    const std::scoped_lock lock(mutex_);
    return means_ && means_->size() == size ? std::optional(means_->buffer()) : std::nullopt;
  }

 private:
  mutable std::mutex mutex_;
  vulkan::Device device_;
  std::unique_ptr<device::FilmMeans> means_;
};

}  // namespace candela::window
