// The map of radiance that surrounds a scene, as both tracers read it: docs/light-transport.md section 6.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace candela::scene {

/// The source of an environment, and its placement.
struct EnvironmentRequest {
  std::string source;   ///< image file, "white" or "sun:ELEVATION,AZIMUTH,TURBIDITY"; empty: no environment
  double rotation = 0;  ///< degrees about the axis that points up, counterclockwise seen from above
  double scale = 1;     ///< factor of all radiances, >= 0
  /// The first and the last row of the image lie at the poles, if it has two or more: Environment::hasRowsAtPoles.
  bool hasRowsAtPoles = false;
};

/// Equirectangular map in its own frame, whose y axis points up.
struct Environment {
  /// C = 2^24: the weight of a texel that is chosen with the mean probability.
  static constexpr std::uint64_t kMeanWeight = std::uint64_t{1} << 24;

  std::string name;  ///< for reports
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<glm::vec3> texels;       ///< linear radiance >= 0, finite, row by row from the top
  std::vector<std::uint64_t> weights;  ///< of the choice of each texel; their sum is kMeanWeight times the number of
                                       ///< texels, or 0 if the map is black
  /// The centres of the first and the last row lie at the poles, as in Mitsuba's maps, instead of half a row from them.
  bool hasRowsAtPoles = false;
  glm::vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};  ///< x, y and z axis of the map's frame, in the scene

  /// Returns the offset o of the poles from the upper and the lower edge of the map, in rows.
  double offsetOfPoles() const { return hasRowsAtPoles ? 0.5 : 0; }

  bool operator==(const Environment&) const = default;
};

}  // namespace candela::scene
