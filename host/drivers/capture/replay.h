// Repeats the work of a capture, as reproduce.c does.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "host/drivers/capture/capture.h"
#include "host/trace/vulkan/device_info.h"

namespace candela::capture {

/// Runs the commands on a device that is opened for them, and returns the contents of all buffers afterwards. Throws as
/// vulkan::Device does.
std::vector<Content> replay(const Capture& capture, const vulkan::DeviceInfo& device);

/// Returns the words of a value, least significant first: one, or three for ValueType::sum.
std::span<const std::uint32_t> wordsOf(const Capture& capture, const ExpectedValue& value,
                                       const std::vector<Content>& contents);

/// Returns the value of the words.
double valueOf(ValueType type, std::span<const std::uint32_t> words);

/// Repeats the work on the device where it was captured, and sets Capture::differing and, if a value differs and no
/// text is known, Capture::found.
void check(Capture& capture, const vulkan::DeviceInfo& device);

/// Replaces the expected values by the bits that this device computes.
void expectBitsOf(Capture& capture, const vulkan::DeviceInfo& device);

}  // namespace candela::capture
