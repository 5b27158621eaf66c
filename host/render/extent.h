// A size in pixels or lanes.
#pragma once
#include <cstdint>

namespace candela {

struct Extent {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
};

}  // namespace candela
