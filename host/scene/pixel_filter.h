// The filter of a film's pixels: docs/light-transport.md section 3.
#pragma once
#include <cstdint>

namespace candela::scene {

enum class FilterKind : std::uint8_t { box, tent, gaussian };

/// The distribution of camera rays around a pixel's origin.
struct PixelFilter {
  FilterKind kind = FilterKind::box;
  float deviation = 0.5f;  ///< standard deviation in pixels, > 0, of FilterKind::gaussian only

  bool operator==(const PixelFilter&) const = default;
};

/// Limits of deviations.
inline constexpr float kMinDeviation = 0.01f;
inline constexpr float kMaxDeviation = 100;

}  // namespace candela::scene
