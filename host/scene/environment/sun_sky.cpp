// Evaluates the model for every texel, and adds the disc of the sun.
#include "host/scene/environment/sun_sky.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "host/base/errors.h"
#include "host/scene/environment/placement.h"
#include "host/scene/environment/preetham.h"

namespace candela::environment {
namespace {

using glm::dvec3;

using std::numbers::pi;
constexpr std::uint32_t kWidth = 2048;
constexpr std::uint32_t kHeight = 1024;
constexpr double kSunRadius = 0.5 * 0.533 * pi / 180;  // as seen from the earth
constexpr double kGroundAlbedo = 0.2;
constexpr double kUnit = pi / 100;  // a white diffuse surface under 100 klx has radiance 1

struct SunSkyParameters {
  double elevation;
  double azimuth;
  double turbidity;
};

std::optional<SunSkyParameters> parse(std::string_view text) {
  std::array<double, 3> values{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) return std::nullopt;
    const auto [next, error] = std::from_chars(at, end, values[i]);
    if (error != std::errc{}) return std::nullopt;
    at = next;
  }
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  const bool isValid = at == end && within(values[0], 0, 90) && within(values[1], -360, 360) &&
                       within(values[2], 2, 10);
  if (!isValid) return std::nullopt;
  return SunSkyParameters{values[0], values[1], values[2]};
}

dvec3 sunDirection(const SunSkyParameters& parameters) {
  const double elevation = parameters.elevation * pi / 180;
  const double azimuth = parameters.azimuth * pi / 180;
  return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), -std::cos(elevation) * std::cos(azimuth)};
}

// Returns the integral, over all directions, of the weight that bilinear interpolation gives to a texel of the row: of
// a tent over two texels in each dimension. Above the pole, the tents of row 0 continue on the other side, so that
// these texels have 13/12 of the solid angle of their own area.
double texelSolidAngle(std::uint32_t row) {
  constexpr double kStep = pi / kHeight;
  constexpr double kPart = 0.5;  // of a texel that the tents of row 0 reach beyond the pole
  const double sinc = std::sin(kStep / 2) / (kStep / 2);
  const double beyondPole = row == 0 ? 2 * (kPart - std::sin(kStep * kPart) / kStep) / kStep : 0;
  return 2 * pi / kWidth * kStep * (sinc * sinc * std::sin(kStep * (row + 0.5)) + beyondPole);
}

// Distributes the irradiance of the disc among the texels that contain it, by points that are uniform on it. The part
// of a low sun that is below the horizon is hidden.
void addSun(const dvec3& direction, const dvec3& irradiance, std::vector<dvec3>& texels) {
  constexpr int kRings = 128;
  constexpr int kSpokes = 256;
  const dvec3 across = std::abs(direction.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
  const dvec3 u = normalize(cross(across, direction));
  const dvec3 v = cross(direction, u);
  for (int ring = 0; ring < kRings; ++ring) {
    const double radius = kSunRadius * std::sqrt((ring + 0.5) / kRings);
    for (int spoke = 0; spoke < kSpokes; ++spoke) {
      const double angle = 2 * pi * (spoke + 0.5) / kSpokes;
      const dvec3 point = normalize(direction + radius * (std::cos(angle) * u + std::sin(angle) * v));
      const double s = kWidth * (0.5 + std::atan2(point.z, point.x) / (2 * pi));
      const double t = kHeight * (0.5 - std::asin(point.y) / pi);
      const auto row = std::min(static_cast<std::uint32_t>(t), kHeight - 1);
      if (row >= kHeight / 2) continue;
      const auto column = static_cast<std::uint32_t>(s) % kWidth;
      texels[std::size_t{row} * kWidth + column] += irradiance / (texelSolidAngle(row) * kRings * kSpokes);
    }
  }
}

// The irradiance of the horizontal ground.
dvec3 groundIrradiance(const std::vector<dvec3>& texels) {
  dvec3 sum(0);
  for (std::uint32_t row = 0; row < kHeight / 2; ++row) {
    const double cosine = std::cos(pi * (row + 0.5) / kHeight);
    for (std::uint32_t column = 0; column < kWidth; ++column) {
      sum += cosine * texelSolidAngle(row) * texels[std::size_t{row} * kWidth + column];
    }
  }
  return sum;
}

}  // namespace

scene::Environment makeSunSky(std::string_view numbers) {
  const std::optional<SunSkyParameters> parameters = parse(numbers);
  if (!parameters) {
    throw UsageError(
        fmt::format("the environment sun:{}: expected sun:ELEVATION,AZIMUTH,TURBIDITY with an elevation from 0 to 90 "
                    "and an azimuth "
                    "from -360 to 360 degrees, and a turbidity from 2 to 10",
                    numbers));
  }
  const dvec3 sun = sunDirection(*parameters);
  const PreethamSky model(sun, parameters->turbidity);
  std::vector<dvec3> texels(std::size_t{kWidth} * kHeight, dvec3(0));
  for (std::uint32_t row = 0; row < kHeight / 2; ++row) {
    for (std::uint32_t column = 0; column < kWidth; ++column) {
      texels[std::size_t{row} * kWidth + column] = model.sky(directionOf(column + 0.5, row + 0.5, kWidth, kHeight));
    }
  }
  addSun(sun, model.sun(), texels);
  const dvec3 ground = kGroundAlbedo / pi * groundIrradiance(texels);
  std::fill(texels.begin() + kWidth * (kHeight / 2), texels.end(), ground);
  scene::Environment environment{
      .name = fmt::format("sun:{}", numbers), .width = kWidth, .height = kHeight, .texels = {}, .weights = {}};
  for (const dvec3& texel : texels) environment.texels.emplace_back(kUnit * texel);
  return environment;
}

}  // namespace candela::environment
