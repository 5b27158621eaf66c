// Converts linear radiance to 8-bit pixels.
#include <algorithm>
#include <cmath>

#include "host/image/colour_transfer.h"
#include "host/image/false_colour.h"
#include "host/image/image.h"

namespace candela::image {
namespace {

using glm::dmat3;
using glm::dvec3;

/// Krzysztof Narkowicz, "ACES Filmic Tone Mapping Curve" (2016), applied per channel.
dvec3 aces(const dvec3& x) { return (x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14); }

/// Stephen Hill's fit of the RRT and the ODT of ACES (in M. Pettineo's BakingLab, 2016) with the exposure 1 / 0.6 that
/// three.js' ACESFilmicToneMapping and glTF's viewers put before it.
dvec3 acesHill(const dvec3& linear) {
  const dmat3 toAces(0.59719, 0.07600, 0.02840,  //
                     0.35458, 0.90834, 0.13383,  //
                     0.04823, 0.01566, 0.83777);
  const dmat3 toDisplay(1.60475, -0.10208, -0.00327,  //
                        -0.53108, 1.10813, -0.07276,  //
                        -0.07367, -0.00605, 1.07602);
  const dvec3 x = toAces * (linear / 0.6);
  return toDisplay * ((x * (x + 0.0245786) - 0.000090537) / (x * (0.983729 * x + 0.4329510) + 0.238081));
}

/// The contrast curve of AgX: the polynomial of degree 6 by Benjamin Wrensch.
dvec3 agxContrast(const dvec3& x) {
  return -0.00232 + x * (0.1191 + x * (0.4298 + x * (-6.868 + x * (31.96 + x * (-40.14 + x * 15.5)))));
}

/// Troy Sobotka's AgX in the approximation by Benjamin Wrensch, "Minimal AgX Implementation" (2023), without a look.
/// Its curve gives a signal for a display of gamma 2.2, which is converted to a linear value.
dvec3 agx(const dvec3& linear) {
  const dmat3 inset(0.842479062253094, 0.0423282422610123, 0.0423756549057051,  //
                    0.0784335999999992, 0.878468636469772, 0.0784336,           //
                    0.0792237451477643, 0.0791661274605434, 0.879142973793104);
  const dmat3 outset(1.19687900512017, -0.0528968517574562, -0.0529716355144438,  //
                     -0.0980208811401368, 1.15190312990417, -0.0980434501171241,  //
                     -0.0990297440797205, -0.0989611768448433, 1.15107367264116);
  constexpr double kMinStop = -12.47393;
  constexpr double kMaxStop = 4.026069;
  const dvec3 stops = glm::clamp(glm::log2(inset * linear), kMinStop, kMaxStop);
  const dvec3 signal = outset * agxContrast((stops - kMinStop) / (kMaxStop - kMinStop));
  return glm::pow(glm::max(signal, 0.0), dvec3(2.2));
}

/// Khronos PBR Neutral, with the symbols of its specification (KhronosGroup/ToneMapping, 2024).
dvec3 neutral(const dvec3& linear) {
  constexpr double kF90 = 0.04;
  constexpr double kS = 0.8 - kF90;
  constexpr double kD = 0.15;
  const double x = std::min({linear.x, linear.y, linear.z});
  const double f = x <= 2 * kF90 ? x - x * x / (4 * kF90) : kF90;
  const dvec3 shifted = linear - f;
  const double p = std::max({shifted.x, shifted.y, shifted.z});
  if (p <= kS) return shifted;
  const double pn = 1 - (1 - kS) * (1 - kS) / (p + 1 - 2 * kS);
  const double g = 1 / (kD * (p - pn) + 1);
  return shifted * (pn / p * g) + pn * (1 - g);
}

dvec3 applyCurve(const dvec3& linear, ToneMap toneMap) {
  switch (toneMap) {
    case ToneMap::none:
    case ToneMap::srgb:
    case ToneMap::depth:
    case ToneMap::heat:
      return linear;
    case ToneMap::aces:
      return aces(linear);
    case ToneMap::acesHill:
      return acesHill(linear);
    case ToneMap::agx:
      return agx(linear);
    case ToneMap::neutral:
      return neutral(linear);
  }
  return linear;
}

/// Clamps to finite values >= 0 before a curve is applied. The limit is far above the value at which any of them
/// becomes white.
double sanitized(double value) {
  constexpr double kLimit = 1e30;
  return std::isnan(value) ? 0 : std::clamp(value, 0.0, kLimit);
}

/// Encodes a linear value >= 0 for the display.
dvec3 toneMapped(const dvec3& linear, ToneMap toneMap) {
  const dvec3 shown = glm::clamp(applyCurve(linear, toneMap), 0.0, 1.0);
  if (toneMap == ToneMap::none) return shown;
  return {srgbEncode(shown.x), srgbEncode(shown.y), srgbEncode(shown.z)};
}

std::uint8_t quantized(double signal) { return static_cast<std::uint8_t>(std::lround(255 * signal)); }

}  // namespace

glm::u8vec3 toDisplay(const glm::vec3& linear, const DisplayTransform& transform) {
  const double gain = std::exp2(double{transform.exposure});
  const dvec3 gained = dvec3(linear) * gain;
  const dvec3 exposed(sanitized(gained.x), sanitized(gained.y), sanitized(gained.z));
  const dvec3 signal = isFalseColour(transform.toneMap) ? falseColour(exposed.x / transform.scale, transform.toneMap)
                                                        : toneMapped(exposed, transform.toneMap);
  return {quantized(signal.x), quantized(signal.y), quantized(signal.z)};
}

}  // namespace candela::image
