// Packets of the protocol by which tev, a viewer of images, is operated (https://github.com/Tom94/tev).
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "host/trace/render/extent.h"

namespace candela::cli {

/// A packet is its size in bytes (4 bytes, with these), a byte for its kind, and its content: whole numbers as
/// little-endian words, texts that end with a zero, and floats.
using TevPacket = std::vector<std::byte>;

/// Makes an image with these channels. One of the same name is replaced.
TevPacket tevCreateImage(const std::string& name, const render::Extent& size, std::span<const std::string> channels);

/// Replaces a window of an image. `values` has the channels of each pixel side by side, row by row from the top.
TevPacket tevUpdateImage(const std::string& name, std::span<const std::string> channels, const render::Window& window,
                         std::span<const float> values);

}  // namespace candela::cli
