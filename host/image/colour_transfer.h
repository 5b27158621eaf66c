// The sRGB transfer function, IEC 61966-2-1, in both directions.
#pragma once
#include <cmath>

namespace candela::image {

/// Converts a linear value to an sRGB signal, both in [0, 1].
inline double srgbEncode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// Converts an sRGB signal to a linear value, both in [0, 1].
inline double srgbDecode(double signal) {
  return signal <= 0.04045 ? signal / 12.92 : std::pow((signal + 0.055) / 1.055, 2.4);
}

}  // namespace candela::image
