// Three cut stones that differ in their dispersion, between lamps.
#include <algorithm>
#include <array>
#include <cmath>

#include "host/scene/generate/gltf_material.h"
#include "host/scene/generate/gltf_scenes.h"
#include "host/scene/generate/lathe.h"
#include "host/scene/generate/rotation.h"

namespace candela::generate {
namespace {

using glm::dvec3;

// Proportions of a round brilliant, relative to the radius of its girdle.
constexpr double kTableRadius = 0.57, kCrownHeight = 0.325, kGirdleHeight = 0.04, kPavilionDepth = 0.862;
constexpr double kStar = 0.5;    // length of the star facets along the bezels
constexpr double kLower = 0.78;  // length of the lower halves along the mains of the pavilion
constexpr std::uint64_t kLampTriangles = 2;
constexpr int kLowLamps = 12, kHighLamps = 7;

struct Stone {
  double dispersion;
  double x, z;
  double yaw;  // in degrees
};
// Without dispersion, with that of diamond, and with that of rutile.
constexpr std::array kStones{Stone{0, -2.3, 0.25, 248}, Stone{0.36, 0, 0, 262}, Stone{2.04, 2.3, 0.25, 281}};

// Appends flat facets, each a triangle with vertices of its own.
class Facets {
 public:
  void add(const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 normal = normalize(cross(b - a, c - a));
    for (const dvec3& corner : {a, b, c}) {
      mesh_.indices.push_back(static_cast<std::uint32_t>(mesh_.positions.size()));
      mesh_.positions.emplace_back(corner);
      mesh_.normals.emplace_back(normal);
    }
  }
  void add(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
    add(a, b, c);
    add(a, c, d);
  }
  const TriangleMesh& mesh() const { return mesh_; }

 private:
  TriangleMesh mesh_;
};

// A round brilliant with `mains` bezels, as it lies on a main of its pavilion, turned by `yaw` degrees.
class Brilliant {
 public:
  Brilliant(std::uint32_t mains, double yaw) : mains_(mains), yaw_(yaw * kTurn / 360) {}

  TriangleMesh mesh() const {
    Facets facets;
    for (std::uint32_t i = 1; i + 1 < mains_; ++i) facets.add(table(0), table(i), table(i + 1.0));
    for (std::uint32_t i = 0; i < mains_; ++i) {
      addCrown(i, facets);
      addGirdle(i, facets);
      addGirdle(i + 0.5, facets);
      addPavilion(i, facets);
    }
    return facets.mesh();
  }

 private:
  // Facets lie between radii at whole indices of the mains and at halves. Bezels and mains of the pavilion are plane:
  // the middle of their two side corners is on the line between the others.
  void addCrown(double i, Facets& facets) const {
    facets.add(table(i), star(i), table(i + 1));
    facets.add(table(i), star(i - 1), girdle(i), star(i));
    facets.add(star(i), girdle(i), girdle(i + 0.5));
    facets.add(star(i), girdle(i + 0.5), girdle(i + 1));
  }
  void addGirdle(double i, Facets& facets) const { facets.add(girdle(i), below(i), below(i + 0.5), girdle(i + 0.5)); }
  void addPavilion(double i, Facets& facets) const {
    facets.add(lower(i), below(i + 0.5), below(i));
    facets.add(lower(i), below(i + 1), below(i + 0.5));
    facets.add(at(0, -kGirdleHeight - kPavilionDepth, 0), lower(i), below(i), lower(i - 1));
  }

  dvec3 table(double i) const { return at(kTableRadius, kCrownHeight, i); }
  dvec3 star(double i) const {
    return at(std::lerp(kTableRadius, 1, kStar) / middle(), kCrownHeight * (1 - kStar), i + 0.5);
  }
  dvec3 girdle(double i) const { return at(1, 0, i); }
  dvec3 below(double i) const { return at(1, -kGirdleHeight, i); }
  dvec3 lower(double i) const { return at((1 - kLower) / middle(), -kGirdleHeight - kPavilionDepth * kLower, i + 0.5); }
  double middle() const { return std::cos(kTurn / 2 / mains_); }

  // Returns a point of the stone whose main at index 0 lies on the floor.
  dvec3 at(double radius, double height, double index) const {
    const double azimuth = kTurn * index / mains_, tilt = -std::atan(kPavilionDepth);
    const double x = radius * std::cos(azimuth), z = -radius * std::sin(azimuth);
    const double floor = std::cos(tilt) * (-kGirdleHeight - kPavilionDepth);
    const double along = x * std::cos(tilt) - height * std::sin(tilt);
    const double up = x * std::sin(tilt) + height * std::cos(tilt) - floor;
    return {along * std::cos(yaw_) + z * std::sin(yaw_), up + kLift, z * std::cos(yaw_) - along * std::sin(yaw_)};
  }

  static constexpr double kLift = 1e-3;  // above the floor
  std::uint32_t mains_;
  double yaw_;
};

// A lamp of this half width and half height that faces the origin.
void addLamp(const dvec3& centre, double halfWidth, double halfHeight, Facets& facets) {
  const dvec3 normal = -normalize(centre);
  const dvec3 u = halfWidth * normalize(cross(dvec3(0, 1, 0), normal));
  const dvec3 v = halfHeight * normalize(cross(normal, u));
  facets.add(centre - u - v, centre + u - v, centre + u + v, centre - u + v);
}

void addRing(int lamps, double radius, double height, double halfWidth, double halfHeight, Facets& facets) {
  for (int i = 0; i < lamps; ++i) {
    const double azimuth = kTurn * (i + 0.25) / lamps;
    addLamp({radius * std::cos(azimuth), height, radius * std::sin(azimuth)}, halfWidth, halfHeight, facets);
  }
}

}  // namespace

std::uint64_t brilliantsPrimitives(std::uint32_t size) {
  return kStones.size() * (14 * std::uint64_t{size} - 2) + kLampTriangles * (kLowLamps + kHighLamps + 2) + 2;
}

void writeBrilliants(NffWriter& out, std::uint32_t size) {
  GltfDocument document;
  for (const Stone& stone : kStones) {
    const std::size_t material = document.addMaterial(gltfMaterial(
        {.roughness = 0, .transmission = 1, .ior = 2.417, .thickness = 1, .dispersion = stone.dispersion}));
    document.addNode(document.addShape(Brilliant(size, stone.yaw).mesh()), material, {stone.x, 0, stone.z});
  }
  const std::size_t floor = document.addMaterial(gltfMaterial({.colour = {0.03, 0.035, 0.05}, .roughness = 0.35}));
  document.addNode(document.addShape(square(14, 1)), floor, dvec3(0));
  Facets lamps;
  addRing(kLowLamps, 7, 6.5, 0.7, 0.45, lamps);
  addRing(kHighLamps, 3.4, 9, 0.6, 0.6, lamps);
  addLamp({-9, 4, -6}, 2.2, 1.2, lamps);
  addLamp({9, 3, 4}, 1, 2, lamps);
  const std::size_t lamp = document.addMaterial(gltfMaterial({.colour = dvec3(0), .emission = dvec3(25)}));
  document.addNode(document.addShape(lamps.mesh()), lamp, dvec3(0));
  document.addCamera({0, 6.1, 7.1}, {0, 0.55, 0}, 19, 2.4);
  out.text(document.text());
}

}  // namespace candela::generate
