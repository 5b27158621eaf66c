// Rays, and their origin primitives.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>

namespace candela::reference {

using glm::dvec3;

inline constexpr std::uint32_t kNoPrimitive = 0xffffffffu;
inline constexpr double kNoHit = std::numeric_limits<double>::infinity();

/// Largest coordinate, without its sign.
inline double maxNorm(const dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// How a ray has hit its origin primitive: docs/light-transport.md section 4, coincident surfaces.
enum class Contact : std::uint8_t {
  none,    ///< at a distance
  beyond,  ///< at once, by a ray that went forth
  back,    ///< at once, by a ray that went back
};

/// `direction` is a unit vector. A ray from a surface stores its origin primitive (docs/light-transport.md section 4);
/// `originNormal` is the normal there in the primitive's own orientation, which boxes need.
struct Ray {
  dvec3 origin;
  dvec3 direction;
  std::uint32_t originPrimitive = kNoPrimitive;
  dvec3 originNormal{0};
  std::uint32_t opacityKey = 0;  ///< of the decisions which transparent triangles it hits
  bool crosses = false;  ///< the ray crosses the surface on which it starts; else it stays on the side of the ray
                         ///< before it
  Contact contact = Contact::none;

  dvec3 at(double distance) const { return origin + distance * direction; }
};

struct Hit {
  double distance = kNoHit;
  std::uint32_t primitive = kNoPrimitive;

  explicit operator bool() const { return primitive != kNoPrimitive; }
};

}  // namespace candela::reference
