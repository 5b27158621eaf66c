// Streets at night with their houses, lamps, signs and cars, of which many parts emit light.
#pragma once
#include <array>
#include <cstdint>

#include "host/scene/generate/gltf_document.h"
#include "host/scene/generate/lit_signs.h"

namespace candela::generate {

inline constexpr std::size_t kLanternColours = 2, kHouseColours = 5, kCarColours = 4;
inline constexpr std::size_t kShopWindowKinds = 4, kWindowKinds = 12;

/// The materials of a street, each with a mesh of its own. Those of which there are several follow each other.
struct StreetPart {
  enum Index : std::size_t {
    asphalt,
    paving,
    paint,
    trim,
    frame,
    glass,
    door,
    roof,
    iron,
    carDark,
    headlamp,
    tailLamp,
    warning,
    lantern,
    house = lantern + kLanternColours,
    car = house + kHouseColours,
    shopWindow = car + kCarColours,
    window = shopWindow + kShopWindowKinds,
    sign = window + kWindowKinds,
    count = sign + kSignCount
  };
};

/// The points of a house front: along it from the left, up, and out of it.
struct HouseFront {
  glm::dvec3 origin, right, out;

  glm::dvec3 at(double x, double y, double z) const { return origin + right * x + glm::dvec3(0, y, 0) + out * z; }
  void appendBlock(TriangleMesh& mesh, const glm::dvec3& low, const glm::dvec3& high) const;
  /// Appends a rectangle parallel to the front.
  void appendPanel(TriangleMesh& mesh, const glm::dvec2& low, const glm::dvec2& high, double z) const;
};

/// Builds streets of plots, each with two houses, two lamps, a sign and a car. Lengths are in metres. Streets run along
/// -z from z = 0 and are beside each other.
class StreetBuilder {
 public:
  static constexpr double kPlotLength = 12;
  static constexpr std::uint32_t kPlotEmitters = 256;  ///< emissive triangles of a plot
  static constexpr std::uint32_t kPlotsPerStreet = 40;

  /// In what is added, `emitters` triangles emit light: those that are added first. Further lamps and windows are dark.
  /// If their number is odd, one of them is a triangular sign, which is added here.
  explicit StreetBuilder(std::uint32_t emitters);

  /// Adds the road and the pavements of a street with this number of plots, which begins with the plot `first`.
  void addRoad(std::uint32_t first, std::uint32_t plots);
  void addPlot(std::uint32_t plot);

  /// Meshes are indexed by StreetPart.
  const std::array<TriangleMesh, StreetPart::count>& meshes() const { return meshes_; }
  std::uint64_t triangleCount() const;

 private:
  /// Returns the mesh of a quad that emits light, or that of glass if enough triangles do.
  TriangleMesh& emissive(std::size_t part);
  void addWarning();
  void addStreetLamp(const HouseFront& front, double x, std::size_t part);
  /// Adds a sign across the pavement, which is lit on both faces.
  void addSign(const HouseFront& front, std::size_t part);
  void addCar(const glm::dvec3& middle, bool isLeaving, std::size_t part);
  void addHouse(const HouseFront& front, std::uint32_t house);
  /// Adds the wall around an opening from `a` to `b`, and its reveal.
  void addOpening(const HouseFront& front, std::size_t wall, const glm::dvec2& low, const glm::dvec2& high,
                  const glm::dvec2& a, const glm::dvec2& b);
  /// Adds the panes of a window and the bars between them, in one plane.
  void addPanes(const HouseFront& front, const glm::dvec2& low, const glm::dvec2& high, bool isLit, std::size_t part);
  void addSides(const HouseFront& front, std::size_t wall, double height);

  std::array<TriangleMesh, StreetPart::count> meshes_;
  std::uint32_t emitters_;  ///< that are still to be added
};

}  // namespace candela::generate
