// The sizes of a band's buffers and the offsets in them: path states; the film with sums of layers and lists of hits;
// and the results, which are counters, queues of the wavefront and path records.
#pragma once
#include <cstdint>

#include "host/trace/device/kernel.h"
#include "host/trace/render/settings.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::device {

/// Returns the bytes of a pixel in the film buffer.
std::uint64_t filmBytesPerPixel(const render::RenderSettings& settings);
/// Returns the bytes of the results of `pixels` pixels.
std::uint64_t resultBytes(const Kernel& kernel, const render::RenderSettings& settings, std::uint64_t pixels);

/// Returns the offset of the lists of hits in the film buffer. The render must have mattes.
std::uint64_t hitListOffset(const render::RenderSettings& settings, std::uint64_t pixels);
/// Returns the offset of the path records in the results.
std::uint64_t recordOffset(const Kernel& kernel, std::uint64_t pixels);

/// Returns the maximum height of a band whose largest buffer has at most `maxBytes` and can be bound by the device, at
/// least 1. Throws FileError if one row of the image is too large.
std::uint32_t bandHeight(const vulkan::DeviceInfo& info, const Kernel& kernel, const render::RenderSettings& settings,
                         std::uint64_t maxBytes);

/// Returns the bytes of all buffers of a band of one row.
std::uint64_t bandRowBytes(const Kernel& kernel, const render::RenderSettings& settings);

}  // namespace candela::device
