// Texts that all comparisons of two reports share.
#pragma once
#include <fmt/format.h>

#include <optional>
#include <string>

namespace candela::bench {

/// Returns the devices of both reports, once if they are equal.
inline std::string devicesText(const std::string& before, const std::string& after) {
  return before == after ? after : before + " before, now " + after;
}

/// Returns the relative change; empty if a value is missing or the old one is not positive.
inline std::string changeText(const std::optional<double>& before, const std::optional<double>& after) {
  if (!before || !after || *before <= 0) return "";
  return fmt::format("{:+.1f} %", 100 * (*after / *before - 1));
}

}  // namespace candela::bench
