// The hash of a scene file, which is computed while the file is read.
#pragma once
#include <cstdint>
#include <future>
#include <string_view>

namespace candela::scene {

/// Starts to compute the 64-bit FNV-1a hash of the bytes, which must stay until the result is there. That of a large
/// file takes about as long as reading it, and is computed on another thread.
std::shared_future<std::uint64_t> startHash(std::string_view bytes);

}  // namespace candela::scene
