// Numbers of things in messages.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

namespace candela {

/// Returns "1 ray" or "2 rays". The plural of `noun` must end with "s" alone.
inline std::string counted(std::uint64_t count, const char* noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

}  // namespace candela
