// A size in pixels or invocations.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace candela::render {

struct Extent {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  bool operator==(const Extent&) const = default;
};

/// Returns for example "512x384".
inline std::string extentText(const Extent& extent) { return fmt::format("{}x{}", extent.width, extent.height); }

}  // namespace candela::render
