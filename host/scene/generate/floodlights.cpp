// floodlights: equal lamps far away from a small stage, among which no rule of distance or direction can choose.
#include <array>
#include <cmath>

#include "host/scene/generate/many_lights.h"

namespace candela::generate {
namespace {

using glm::dvec3;

// Lengths are in metres. The lamps are in a square around kToLamps * kLampDistance and face the origin, where the stage
// is.
constexpr dvec3 kToLamps{0.48, 0.64, 0.6};
constexpr double kLampDistance = 100, kArraySide = 4;
constexpr double kLampFill = 0.5;       ///< width of a lamp, as a fraction of the distance between lamps
constexpr double kStageIrradiance = 3;  ///< of what faces the lamps, from all together
constexpr std::uint32_t kStagePrimitives = 16;

void writeStage(NffWriter& out) {
  out.diffuse({0.5, 0.48, 0.45});
  out.box({-2, -0.2, -2}, {2, 0, 2});
  out.diffuse({0.7, 0.7, 0.68});
  out.box({-1.98, -0.1, -1.98}, {1.98, 1.8, -1.9});
  out.diffuse({0.65, 0.2, 0.12});
  out.box({-1.5, -0.01, -1.2}, {-0.7, 1.1, -0.4});
  out.diffuse({0.7, 0.66, 0.5});
  out.sphere({0.2, 0.55, -0.2}, 0.55);
  out.diffuse({0.15, 0.35, 0.6});
  out.sphere({1.2, 0.35, 0.5}, 0.35);
  out.diffuse({0.25, 0.5, 0.2});
  out.cone({-0.75, 0, 0.8}, 0.4, {-0.75, 0.9, 0.8}, 0);
  out.diffuse({0.6, 0.55, 0.3});
  for (int i = 0; i < 10; ++i) {  // a fence, whose shadows are narrow
    const double x = -1.8 + 0.4 * i;
    out.cone({x, -0.01, 1.7}, 0.03, {x, 0.45, 1.7}, 0.03);
  }
}

}  // namespace

std::uint64_t floodlightsPrimitives(std::uint32_t size) { return 2 * std::uint64_t{size} + kStagePrimitives; }

void writeFloodlights(NffWriter& out, std::uint32_t size) {
  out.background(dvec3(0));
  out.view({{-1.2, 2.2, 6}, {-0.05, 0.55, 0}, {0, 1, 0}, 30, 0, 960, 540});
  writeStage(out);
  const auto columns = static_cast<std::uint32_t>(std::ceil(std::sqrt(size)));
  const double cell = kArraySide / columns, width = kLampFill * cell;
  const dvec3 u = normalize(cross(dvec3(0, 1, 0), kToLamps)), v = cross(kToLamps, u);
  const double radiance = kStageIrradiance * kLampDistance * kLampDistance / (width * width * size);
  for (std::uint32_t i = 0; i < size; ++i) {
    const double x = (i % columns + 0.5) * cell - kArraySide / 2, y = (i / columns + 0.5) * cell - kArraySide / 2;
    const dvec3 corner = kLampDistance * kToLamps + (x - width / 2) * u + (y - width / 2) * v;
    out.areaLight(corner, width * v, width * u, dvec3(radiance));
  }
}

}  // namespace candela::generate
