// The shape of the interface between two media: docs/light-transport.md sections 5.14 and 5.15.
#pragma once
#include <cstdint>

namespace candela::scene {

/// Smooth, or rough with one of two distributions of normals.
enum class Interface : std::uint8_t { smooth, ggx, beckmann };

}  // namespace candela::scene
