// Surfaces with a light on them, above a floor: the light lies in a wall, on an edge, in a corner, on a sphere and so
// on, and everything that the camera sees is in front of it.
#pragma once
#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "tests/trace/reference/scene_builder.h"

namespace candela::test {

/// Translates everything that is added to a builder. Coordinates are multiples of 1/64, so that at 10^5 they are exact.
struct Shifted {
  SceneBuilder& builder;
  vec3 by;

  vec3 at(const vec3& p) const { return p + by; }
  void quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) const {
    builder.quad(at(a), at(b), at(c), at(d));
  }
  void triangle(const vec3& a, const vec3& b, const vec3& c) const { builder.triangle(at(a), at(b), at(c)); }
};

struct TouchedSurface {
  std::string name;
  vec3 light;   ///< on the surface
  vec3 inward;  ///< direction from there into it, or behind it
  std::function<void(const Shifted&)> add;
};

inline void addWallInX(const Shifted& s) { s.quad({-4, -4, 0}, {-4, 4, 0}, {-4, 4, 4}, {-4, -4, 4}); }
inline void addWallInY(const Shifted& s) { s.quad({-4, -4, 0}, {-4, -4, 4}, {4, -4, 4}, {4, -4, 0}); }
inline void addCeiling(const Shifted& s) { s.quad({-4, -4, 4}, {-4, 4, 4}, {4, 4, 4}, {4, -4, 4}); }
inline void addSlab(const Shifted& s) { s.builder.box(s.at({-3, -3, 2}), s.at({3, 3, 3})); }

/// A closed mesh of eight triangles, one vertex down.
inline void addDiamond(const Shifted& s) {
  const vec3 low(0.25f, 0.5f, 1.75f), high(0.25f, 0.5f, 4.5f);
  const vec3 ring[4] = {{1.25f, 0.5f, 3}, {0.25f, 1.5f, 3}, {-0.75f, 0.5f, 3}, {0.25f, -0.5f, 3}};
  for (int i = 0; i < 4; ++i) {
    s.triangle(low, ring[(i + 1) % 4], ring[i]);
    s.triangle(high, ring[i], ring[(i + 1) % 4]);
  }
}

inline std::vector<TouchedSurface> touchedSurfaces() {
  return {
      {"the plane of a wall", {1.5f, -4, 2}, {0, -1, 0}, addWallInY},
      {"an oblique triangle",
       {0, 0.25f, 3.125f},
       {0, 0, 1},
       [](const Shifted& s) {
         s.triangle({-4, -3, 2.5f}, {0, 3, 4}, {4, -2, 2});
       }},
      {"an infinite plane",
       {1.5f, -4, 2},
       {0, -1, 0},
       [](const Shifted& s) {
         s.builder.plane(s.at({0, -4, 0}), s.at({0, -4, 1}), s.at({1, -4, 0}));
       }},
      {"an edge between walls", {-4, -4, 2}, {-1, -1, 0}, [](const Shifted& s) { addWallInX(s), addWallInY(s); }},
      {"a corner", {-4, -4, 4}, {-1, -1, 1}, [](const Shifted& s) { addWallInX(s), addWallInY(s), addCeiling(s); }},
      {"the face of a box", {1, 0.5f, 2}, {0, 0, 1}, addSlab},
      {"the edge of a box", {3, -1, 2}, {-1, 0, 1}, addSlab},
      {"the corner of a box", {3, 3, 2}, {-1, -1, 1}, addSlab},
      {"a sphere",
       {0.5f, 0.25f, 1.75f},
       {0, 0, 1},
       [](const Shifted& s) {
         s.builder.sphere(s.at({0.5f, 0.25f, 3}), 1.25f);
       }},
      {"a sphere around everything",
       {0, 3.75f, 6},
       {0, 0.75f, 1},
       [](const Shifted& s) {
         s.builder.sphere(s.at({0, 0, 1}), 6.25f);
       }},
      {"a huge sphere",
       {0, 0, 2},
       {0, 0, 1},
       [](const Shifted& s) {
         s.builder.sphere(s.at({0, 0, 100002}), 100000);
       }},
      {"a cylinder",
       {0.5f, 0.25f, 1.75f},
       {0, 0, 1},
       [](const Shifted& s) {
         s.builder.cone(s.at({-3, 0.25f, 3}), 1.25f, s.at({3, 0.25f, 3}), 1.25f);
       }},
      {"a cone",
       {4, 0, 2.5f},
       {0, 0, 1},
       [](const Shifted& s) {
         s.builder.cone(s.at({0, 0, 4}), 16, s.at({0, 0, 2}), 0);
       }},
      {"a vertex of a mesh", {0.25f, 0.5f, 1.75f}, {0, 0, 1}, addDiamond},
  };
}

/// An upper bound of the margin at `light`: for the coordinates of everything that touchedSurfaces() adds except
/// huge spheres, whose part near the eye counts.
inline float marginNear(const vec3& shift) {
  return 0x1p-19f * (20 + std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)}));
}

/// A white floor at z = 0 seen from above, wide enough that rays graze walls at x, y = +-4, and below everything that
/// touches a light.
inline SceneBuilder floorUnder(const vec3& shift) {
  SceneBuilder b;
  const Shifted s{b, shift};
  b.material(diffuseMaterial(vec3(0.8f)));
  s.quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0});
  b.view(s.at({0.125f, 0.0625f, 1}), s.at({0.125f, 0.0625f, 0}), {0, 1, 0}, 149);
  b.scene.name = "floor";
  return b;
}

}  // namespace candela::test
