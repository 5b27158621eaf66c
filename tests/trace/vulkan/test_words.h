// Writes and reads words of buffers, for tests.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "host/trace/vulkan/buffer.h"

namespace candela::vulkan {

using Words = std::vector<std::uint32_t>;

/// Returns `count` words that differ from each other and from common contents of memory.
inline Words makeWords(std::size_t count, std::uint32_t seed = 1) {
  Words words(count);
  for (std::size_t i = 0; i < count; ++i) words[i] = (static_cast<std::uint32_t>(i) + seed) * 2654435761u;
  return words;
}

inline void upload(vulkan::Buffer& buffer, const Words& words, std::uint64_t offset = 0) {
  buffer.upload(std::as_bytes(std::span(words)), offset);
}

inline Words download(const vulkan::Buffer& buffer) {
  Words words(buffer.bytes() / sizeof(std::uint32_t));
  buffer.download(std::as_writable_bytes(std::span(words)));
  return words;
}

}  // namespace candela::vulkan
