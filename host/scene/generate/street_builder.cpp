// Adds what touches so that it enters what it touches a little: no surfaces coincide.
#include "host/scene/generate/street_builder.h"

#include "host/scene/generate/building_models.h"
#include "host/scene/generate/flat_shapes.h"
#include "host/scene/generate/hash_sequence.h"

namespace candela::generate {
namespace {

using glm::dvec2;
using glm::dvec3;
using Part = StreetPart;

constexpr double kHalfRoad = 4, kHalfStreet = 7;  // |x| of kerbs and of house fronts
constexpr double kPavement = 0.12;                // height
constexpr double kNearEnd = 20;                   // z of the road's end behind the camera
constexpr double kStreetPitch = 36;
constexpr double kHouseWidth = 11.94, kHouseDepth = 10, kReveal = 0.2;

constexpr std::uint32_t kHouseStoreys = 5, kHouseBays = 4, kDoorBay = 1;
constexpr std::uint32_t kHouseWindows = kHouseStoreys * kHouseBays - 1;
constexpr std::uint32_t kLitWindows = 10;  // of a house
constexpr std::uint32_t kPaneColumns = 2, kPaneRows = 3;
constexpr std::uint32_t kLampEmitters = 2, kSignEmitters = 4, kCarEmitters = 8;
static_assert(StreetBuilder::kPlotEmitters ==
              2 * kLampEmitters + kSignEmitters + kCarEmitters + 2 * kLitWindows * 2 * kPaneColumns * kPaneRows);
constexpr std::uint32_t kHouseSeed = 44, kPlotSeed = 45;

dvec3 plotOrigin(std::uint32_t plot) {
  return {kStreetPitch * (plot / StreetBuilder::kPlotsPerStreet), 0,
          -StreetBuilder::kPlotLength * (plot % StreetBuilder::kPlotsPerStreet)};
}

std::size_t oneOf(std::size_t first, std::size_t count, HashSequence& random) {
  return first + static_cast<std::size_t>(static_cast<double>(count) * random.next());
}

}  // namespace

void HouseFront::appendBlock(TriangleMesh& mesh, const dvec3& low, const dvec3& high) const {
  const dvec3 a = at(low.x, low.y, low.z), b = at(high.x, high.y, high.z);
  appendBox(mesh, min(a, b), max(a, b));
}

void HouseFront::appendPanel(TriangleMesh& mesh, const dvec2& low, const dvec2& high, double z) const {
  appendQuad(mesh, at(low.x, low.y, z), at(high.x, low.y, z), at(high.x, high.y, z), at(low.x, high.y, z));
}

StreetBuilder::StreetBuilder(std::uint32_t emitters) : emitters_(emitters) {
  if (emitters % 2 == 1) addWarning();
}

void StreetBuilder::addRoad(std::uint32_t first, std::uint32_t plots) {
  const dvec3 origin = plotOrigin(first);
  const auto at = [&](double x, double y, double z) { return origin + dvec3(x, y, z); };
  const double length = kPlotLength * plots, w = kHalfRoad + 0.05;
  appendQuad(meshes_[Part::asphalt], at(-w, 0, kNearEnd), at(w, 0, kNearEnd), at(w, 0, -length), at(-w, 0, -length));
  appendBox(meshes_[Part::paving], at(-kHalfStreet - 0.1, -0.1, -length), at(-kHalfRoad, kPavement, kNearEnd));
  appendBox(meshes_[Part::paving], at(kHalfRoad, -0.1, -length), at(kHalfStreet + 0.1, kPavement, kNearEnd));
}

void StreetBuilder::addPlot(std::uint32_t plot) {
  const dvec3 origin = plotOrigin(plot), margin(0, 0, (kPlotLength - kHouseWidth) / 2);
  HashSequence random(kPlotSeed, static_cast<std::int32_t>(plot));
  const HouseFront right{origin + dvec3(kHalfStreet, 0, -kPlotLength) + margin, {0, 0, 1}, {-1, 0, 0}};
  const HouseFront left{origin + dvec3(-kHalfStreet, 0, 0) - margin, {0, 0, -1}, {1, 0, 0}};
  const std::size_t lantern = oneOf(Part::lantern, kLanternColours, random);
  addStreetLamp(right, 9, lantern);
  addStreetLamp(left, 9, lantern);
  addSign(plot % 2 == 0 ? right : left, oneOf(Part::sign, kSignCount, random));
  const bool isLeaving = random.next() < 0.5;
  const double lane = (isLeaving ? 2 : -2) + random.between(-0.2, 0.2), along = random.between(3, 9);
  addCar(origin + dvec3(lane, -0.01, -along), isLeaving, oneOf(Part::car, kCarColours, random));
  appendBox(meshes_[Part::paint], origin + dvec3(-0.06, -0.02, -7.5), origin + dvec3(0.06, 0.01, -4.5));
  addHouse(right, 2 * plot);
  addHouse(left, 2 * plot + 1);
}

std::uint64_t StreetBuilder::triangleCount() const {
  std::uint64_t count = 0;
  for (const TriangleMesh& mesh : meshes_) count += mesh.triangleCount();
  return count;
}

TriangleMesh& StreetBuilder::emissive(std::size_t part) {
  if (emitters_ < 2) return meshes_[Part::glass];
  emitters_ -= 2;
  return meshes_[part];
}

void StreetBuilder::addWarning() {
  constexpr double x = 5.4, z = -4;
  appendBox(meshes_[Part::iron], {x - 0.04, 0.1, z - 0.04}, {x + 0.04, 2.2, z + 0.04});
  appendTriangle(meshes_[Part::warning], {x - 0.45, 2, z + 0.06}, {x + 0.45, 2, z + 0.06}, {x, 2.78, z + 0.06});
  --emitters_;
}

void StreetBuilder::addStreetLamp(const HouseFront& f, double x, std::size_t part) {
  f.appendBlock(meshes_[Part::iron], {x - 0.06, 0.1, 2.44}, {x + 0.06, 6.5, 2.56});
  f.appendBlock(meshes_[Part::iron], {x - 0.04, 6.41, 2.5}, {x + 0.04, 6.48, 4.5});
  f.appendBlock(meshes_[Part::iron], {x - 0.16, 6.38, 4.1}, {x + 0.16, 6.52, 4.8});
  appendQuad(emissive(part), f.at(x - 0.12, 6.36, 4.15), f.at(x + 0.12, 6.36, 4.15), f.at(x + 0.12, 6.36, 4.75),
             f.at(x - 0.12, 6.36, 4.75));
}

void StreetBuilder::addSign(const HouseFront& f, std::size_t part) {
  constexpr double x = 6, low = 4.3, high = 4.92, inner = 0.35, outer = 2.45;
  f.appendBlock(meshes_[Part::iron], {x - 0.03, 4.55, -0.1}, {x + 0.03, 4.65, 0.5});
  f.appendBlock(meshes_[Part::iron], {x - 0.06, low - 0.04, inner - 0.04}, {x + 0.06, high + 0.04, outer + 0.04});
  for (const double side : {-1.0, 1.0}) {
    const double face = x + 0.08 * side, begin = side < 0 ? inner : outer, end = side < 0 ? outer : inner;
    TriangleMesh& mesh = emissive(part);
    appendQuad(mesh, f.at(face, low, begin), f.at(face, low, end), f.at(face, high, end), f.at(face, high, begin));
    if (&mesh == &meshes_[part]) mesh.texCoords.insert(mesh.texCoords.end(), {{0, 1}, {1, 1}, {1, 0}, {0, 0}});
  }
}

void StreetBuilder::addCar(const dvec3& middle, bool isLeaving, std::size_t part) {
  const double sign = isLeaving ? 1 : -1;
  const auto turned = [&](const dvec3& v) { return dvec3(sign * v.z, v.y, -sign * v.x); };
  const std::array<TriangleMesh, 2> model = carModel();
  for (std::size_t i = 0; i < model.size(); ++i) {
    TriangleMesh& mesh = meshes_[i == 0 ? part : Part::carDark];
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& p : model[i].positions) mesh.positions.emplace_back(middle + turned(p));
    for (const glm::vec3& n : model[i].normals) mesh.normals.emplace_back(turned(n));
    for (const std::uint32_t index : model[i].indices) mesh.indices.push_back(first + index);
  }
  for (const double end : {1.0, -1.0}) {
    for (const double z : {-0.6, 0.6}) {
      const double x = 2.17 * end, w = 0.14 * end;
      const auto at = [&](double y, double across) { return middle + turned({x, y, across}); };
      appendQuad(emissive(end > 0 ? Part::headlamp : Part::tailLamp), at(0.56, z + w), at(0.56, z - w), at(0.7, z - w),
                 at(0.7, z + w));
    }
  }
}

void StreetBuilder::addHouse(const HouseFront& f, std::uint32_t house) {
  HashSequence random(kHouseSeed, static_cast<std::int32_t>(house));
  const std::size_t wall = oneOf(Part::house, kHouseColours, random);
  const double ground = random.between(3.8, 4.4), upper = random.between(2.9, 3.5);
  const double windowWidth = random.between(1, 1.5), bayWidth = kHouseWidth / kHouseBays;
  std::uint32_t windows = kHouseWindows, lit = kLitWindows;  // that are still to be added
  for (std::uint32_t storey = 0; storey < kHouseStoreys; ++storey) {
    const bool isShop = storey == 0;
    const double bottom = isShop ? 0 : ground + (storey - 1) * upper, top = ground + storey * upper;
    for (std::uint32_t bay = 0; bay < kHouseBays; ++bay) {
      const dvec2 low(bay * bayWidth, bottom), high((bay + 1) * bayWidth, top);
      const double middle = (low.x + high.x) / 2;
      if (isShop && bay == kDoorBay) {
        const dvec2 a(middle - 0.55, kPavement + 0.05), b(middle + 0.55, 2.5);
        addOpening(f, wall, low, high, a, b);
        f.appendPanel(meshes_[Part::door], a, b, -kReveal);
        continue;
      }
      const double half = isShop ? 1.1 : windowWidth / 2;
      const dvec2 a(middle - half, bottom + 0.8), b(middle + half, isShop ? 3 : top - 0.5);
      addOpening(f, wall, low, high, a, b);
      const bool isLit = random.next() * windows < lit;
      addPanes(f, a, b, isLit,
               isShop ? oneOf(Part::shopWindow, kShopWindowKinds, random) : oneOf(Part::window, kWindowKinds, random));
      --windows;
      if (isLit) --lit;
    }
  }
  addSides(f, wall, ground + (kHouseStoreys - 1) * upper);
}

void StreetBuilder::addOpening(const HouseFront& f, std::size_t wall, const dvec2& low, const dvec2& high,
                               const dvec2& a, const dvec2& b) {
  TriangleMesh& mesh = meshes_[wall];
  f.appendPanel(mesh, low, {high.x, a.y}, 0);
  f.appendPanel(mesh, {low.x, b.y}, high, 0);
  f.appendPanel(mesh, {low.x, a.y}, {a.x, b.y}, 0);
  f.appendPanel(mesh, {b.x, a.y}, {high.x, b.y}, 0);
  TriangleMesh& trim = meshes_[Part::trim];
  constexpr double z = -kReveal;
  appendQuad(trim, f.at(a.x, a.y, 0), f.at(b.x, a.y, 0), f.at(b.x, a.y, z), f.at(a.x, a.y, z));
  appendQuad(trim, f.at(a.x, b.y, z), f.at(b.x, b.y, z), f.at(b.x, b.y, 0), f.at(a.x, b.y, 0));
  appendQuad(trim, f.at(a.x, a.y, 0), f.at(a.x, a.y, z), f.at(a.x, b.y, z), f.at(a.x, b.y, 0));
  appendQuad(trim, f.at(b.x, a.y, z), f.at(b.x, a.y, 0), f.at(b.x, b.y, 0), f.at(b.x, b.y, z));
}

void StreetBuilder::addPanes(const HouseFront& f, const dvec2& low, const dvec2& high, bool isLit, std::size_t part) {
  constexpr double kBar = 0.06;
  const double width = (high.x - low.x - (kPaneColumns - 1) * kBar) / kPaneColumns;
  const double height = (high.y - low.y - (kPaneRows - 1) * kBar) / kPaneRows;
  TriangleMesh& bars = meshes_[Part::frame];
  for (std::uint32_t row = 0; row < kPaneRows; ++row) {
    const double y = low.y + row * (height + kBar);
    if (row > 0) f.appendPanel(bars, {low.x, y - kBar}, {high.x, y}, -kReveal);
    for (std::uint32_t column = 0; column < kPaneColumns; ++column) {
      const double x = low.x + column * (width + kBar);
      if (column > 0) f.appendPanel(bars, {x - kBar, y}, {x, y + height}, -kReveal);
      f.appendPanel(isLit ? emissive(part) : meshes_[Part::glass], {x, y}, {x + width, y + height}, -kReveal);
    }
  }
}

void StreetBuilder::addSides(const HouseFront& f, std::size_t wall, double height) {
  constexpr double w = kHouseWidth, d = -kHouseDepth;
  TriangleMesh& mesh = meshes_[wall];
  appendQuad(mesh, f.at(0, 0, d), f.at(0, 0, 0), f.at(0, height, 0), f.at(0, height, d));
  appendQuad(mesh, f.at(w, 0, 0), f.at(w, 0, d), f.at(w, height, d), f.at(w, height, 0));
  appendQuad(mesh, f.at(w, 0, d), f.at(0, 0, d), f.at(0, height, d), f.at(w, height, d));
  appendQuad(meshes_[Part::roof], f.at(0, height, 0), f.at(w, height, 0), f.at(w, height, d), f.at(0, height, d));
  f.appendBlock(meshes_[Part::trim], {0.02, height - 0.35, -0.4}, {w - 0.02, height + 0.3, 0.35});
}

}  // namespace candela::generate
