// Stacks storeys of windows around square floors.
#include "host/scene/generate/building_models.h"

#include <cmath>

#include "host/scene/generate/flat_shapes.h"

namespace candela::generate {
namespace {

using glm::dvec2;
using glm::dvec3;

// A part of a building whose storeys are equal. Lengths are in metres.
struct Tier {
  double halfWidth;
  int storeys;
  double storeyHeight;
  int bays;             // windows of a storey on each side
  double windowWidth;   // fraction of a bay
  double sill;          // height of the window's lower edge, as a fraction of the storey
  double head;          // of its upper edge
  double recess;        // depth of the window behind the wall
  double cornice;       // by how much the cornice on top stands out; 0: none
  int balconyInterval;  // every so many bays have balconies; 0: none
  double ribs;          // by how much the piers between bays stand out; 0: none
};

class BuildingBuilder {
 public:
  void add(const Tier& tier) {
    for (int side = 0; side < 4; ++side) addFacade(tier, side);
    const double top = height_ + tier.storeys * tier.storeyHeight, w = tier.halfWidth;
    if (tier.cornice > 0) {
      appendBox(part(BuildingPart::trim), {-w - tier.cornice, top - 0.45, -w - tier.cornice},
                {w + tier.cornice, top + 0.1, w + tier.cornice});
      appendBox(part(BuildingPart::trim), {-w - tier.cornice / 2, top - 0.85, -w - tier.cornice / 2},
                {w + tier.cornice / 2, top - 0.45, w + tier.cornice / 2});
    }
    height_ = top + (tier.cornice > 0 ? 0.1 : 0.0);
  }

  // Adds a level roof behind a parapet.
  void addFlatRoof(double halfWidth) {
    constexpr double kThickness = 0.35, kParapet = 0.9;
    const double w = halfWidth, y = height_, roof = y + 0.04;  // not in the plane of the cornice
    appendQuad(part(BuildingPart::roof), {-w, roof, w}, {w, roof, w}, {w, roof, -w}, {-w, roof, -w});
    for (const double sign : {-1.0, 1.0}) {
      const double outer = sign * w, inner = sign * (w - kThickness);
      const double low = std::min(outer, inner), high = std::max(outer, inner);
      appendBox(part(BuildingPart::wall), {low, y, -w}, {high, y + kParapet, w});
      appendBox(part(BuildingPart::wall), {-w + kThickness, y, low}, {w - kThickness, y + kParapet, high});
    }
  }

  // Adds a roof that rises to a ridge of this half length along x. With a length of 0 it is a pyramid.
  void addHippedRoof(double halfWidth, double rise, double ridge) {
    const double w = halfWidth, y = height_;
    const dvec3 a(-w, y, w), b(w, y, w), c(w, y, -w), d(-w, y, -w), east(ridge, y + rise, 0), west(-ridge, y + rise, 0);
    TriangleMesh& roof = part(BuildingPart::roof);
    appendQuad(roof, a, b, east, west);
    appendQuad(roof, c, d, west, east);
    appendTriangle(roof, b, c, east);
    appendTriangle(roof, d, a, west);
  }

  // Adds a box on the roof, relative to its middle.
  void addOnRoof(BuildingPart of, const dvec2& low, const dvec2& high, double tall) {
    appendBox(part(of), {low.x, height_, low.y}, {high.x, height_ + tall, high.y});
  }

  const BuildingModel& model() const { return model_; }

 private:
  TriangleMesh& part(BuildingPart of) { return model_[static_cast<std::size_t>(of)]; }

  // Points of a facade: along it from the left, up, and out of it.
  struct Facade {
    dvec3 right, out;
    double halfWidth;
    dvec3 at(double x, double y, double z) const { return right * x + dvec3(0, y, 0) + out * (halfWidth + z); }
  };

  void addFacade(const Tier& tier, int side) {
    const dvec3 directions[] = {{1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}};
    const Facade facade{directions[side], directions[(side + 3) % 4], tier.halfWidth};
    const double bay = 2 * tier.halfWidth / tier.bays;
    for (int storey = 0; storey < tier.storeys; ++storey) {
      const double y = height_ + storey * tier.storeyHeight;
      for (int i = 0; i < tier.bays; ++i) {
        const double x = -tier.halfWidth + i * bay;
        addBay(tier, facade, {x, y}, {x + bay, y + tier.storeyHeight});
        const bool hasBalcony = tier.balconyInterval > 0 && storey > 0 && i % tier.balconyInterval == 1;
        if (hasBalcony) addBalcony(facade, x + 0.05 * bay, x + 0.95 * bay, y + tier.sill * tier.storeyHeight - 0.15);
      }
    }
    for (int i = 0; tier.ribs > 0 && i <= tier.bays; ++i) addRib(tier, facade, -tier.halfWidth + i * bay);
  }

  // A window in the middle of a piece of wall.
  void addBay(const Tier& tier, const Facade& f, const dvec2& low, const dvec2& high) {
    const double margin = (high.x - low.x) * (1 - tier.windowWidth) / 2, tall = high.y - low.y;
    const dvec2 a(low.x + margin, low.y + tier.sill * tall), b(high.x - margin, low.y + tier.head * tall);
    TriangleMesh& wall = part(BuildingPart::wall);
    const auto rectangle = [&](TriangleMesh& mesh, const dvec2& p, const dvec2& q, double z) {
      if (q.x - p.x > 1e-9 && q.y - p.y > 1e-9) {
        appendQuad(mesh, f.at(p.x, p.y, z), f.at(q.x, p.y, z), f.at(q.x, q.y, z), f.at(p.x, q.y, z));
      }
    };
    rectangle(wall, low, {high.x, a.y}, 0);
    rectangle(wall, {low.x, b.y}, high, 0);
    rectangle(wall, {low.x, a.y}, {a.x, b.y}, 0);
    rectangle(wall, {b.x, a.y}, {high.x, b.y}, 0);
    const double z = -tier.recess;
    TriangleMesh& frame = part(BuildingPart::trim);
    appendQuad(frame, f.at(a.x, a.y, 0), f.at(b.x, a.y, 0), f.at(b.x, a.y, z), f.at(a.x, a.y, z));
    appendQuad(frame, f.at(a.x, b.y, z), f.at(b.x, b.y, z), f.at(b.x, b.y, 0), f.at(a.x, b.y, 0));
    appendQuad(frame, f.at(a.x, a.y, 0), f.at(a.x, a.y, z), f.at(a.x, b.y, z), f.at(a.x, b.y, 0));
    appendQuad(frame, f.at(b.x, a.y, z), f.at(b.x, a.y, 0), f.at(b.x, b.y, 0), f.at(b.x, b.y, z));
    rectangle(part(BuildingPart::glass), a, b, z);
  }

  void addBlock(TriangleMesh& mesh, const Facade& f, const dvec3& low, const dvec3& high) {
    const dvec3 p = f.at(low.x, low.y, low.z), q = f.at(high.x, high.y, high.z);
    appendBox(mesh, min(p, q), max(p, q));
  }

  void addBalcony(const Facade& f, double left, double right, double y) {
    constexpr double kDepth = 1.1, kRail = 1;
    addBlock(part(BuildingPart::trim), f, {left, y, 0}, {right, y + 0.15, kDepth});
    addBlock(part(BuildingPart::trim), f, {left, y + 0.15, kDepth - 0.06}, {right, y + kRail, kDepth});
    addBlock(part(BuildingPart::trim), f, {left, y + 0.15, 0}, {left + 0.06, y + kRail, kDepth - 0.06});
    addBlock(part(BuildingPart::trim), f, {right - 0.06, y + 0.15, 0}, {right, y + kRail, kDepth - 0.06});
  }

  void addRib(const Tier& tier, const Facade& f, double x) {
    addBlock(part(BuildingPart::trim), f, {x - 0.15, height_, 0},
             {x + 0.15, height_ + tier.storeys * tier.storeyHeight - 0.2, tier.ribs});
  }

  BuildingModel model_;
  double height_ = 0;
};

BuildingModel house() {
  BuildingBuilder b;
  b.add({8.6, 1, 4.4, 4, 0.72, 0.12, 0.8, 0.35, 0.25, 0, 0});
  b.add({8.5, 4, 3.3, 5, 0.42, 0.24, 0.84, 0.28, 0.5, 0, 0});
  b.addHippedRoof(8.8, 4.5, 4.5);
  b.addOnRoof(BuildingPart::wall, {-5, 2}, {-3.8, 3.2}, 4.6);
  b.addOnRoof(BuildingPart::wall, {4.2, -3.6}, {5.4, -2.4}, 4.6);
  return b.model();
}

BuildingModel flats() {
  BuildingBuilder b;
  b.add({8.4, 1, 4.2, 5, 0.7, 0.1, 0.8, 0.4, 0.2, 0, 0});
  b.add({8.3, 8, 3.1, 5, 0.5, 0.08, 0.82, 0.25, 0.35, 2, 0});
  b.addFlatRoof(8.3);
  b.addOnRoof(BuildingPart::wall, {-4, -2.5}, {1, 2}, 2.8);
  b.addOnRoof(BuildingPart::roof, {3, 3}, {5, 6}, 1.4);
  return b.model();
}

BuildingModel office() {
  BuildingBuilder b;
  b.add({8.8, 1, 5, 4, 0.86, 0.06, 0.86, 0.6, 0.15, 0, 0});
  b.add({8.7, 12, 3.7, 6, 0.84, 0.26, 0.86, 0.4, 0.2, 0, 0.22});
  b.addFlatRoof(8.7);
  b.addOnRoof(BuildingPart::trim, {-6, -5}, {2, 1}, 3.5);
  b.addOnRoof(BuildingPart::roof, {4, -6}, {6.5, 5}, 1.8);
  return b.model();
}

BuildingModel setbacks() {
  BuildingBuilder b;
  b.add({8.8, 1, 6, 5, 0.66, 0.1, 0.85, 0.6, 0.35, 0, 0});
  b.add({8.6, 14, 3.6, 7, 0.46, 0.2, 0.86, 0.4, 0.3, 0, 0.3});
  b.addFlatRoof(8.6);
  b.add({6.6, 7, 3.6, 5, 0.48, 0.18, 0.88, 0.4, 0.3, 0, 0.35});
  b.addFlatRoof(6.6);
  b.add({4.6, 5, 3.6, 3, 0.5, 0.15, 0.9, 0.4, 0.4, 0, 0.4});
  b.addHippedRoof(4.8, 9, 0.1);
  b.addOnRoof(BuildingPart::trim, {-0.15, -0.15}, {0.15, 0.15}, 19);
  return b.model();
}

BuildingModel tower() {
  BuildingBuilder b;
  b.add({8.4, 1, 8, 3, 0.9, 0.04, 0.9, 0.8, 0.2, 0, 0});
  b.add({8.7, 30, 3.8, 8, 0.94, 0.05, 0.9, 0.1, 0.15, 0, 0.25});
  b.addFlatRoof(8.5);
  b.add({6.8, 3, 3.8, 6, 0.94, 0.05, 0.9, 0.1, 0.15, 0, 0.25});
  b.addFlatRoof(6.8);
  b.addOnRoof(BuildingPart::trim, {-3, -3}, {3, 3}, 4);
  b.addOnRoof(BuildingPart::trim, {-0.25, -0.25}, {0.25, 0.25}, 22);
  return b.model();
}

}  // namespace

const std::array<BuildingModel, kBuildingCount>& buildingModels() {
  static const std::array<BuildingModel, kBuildingCount> models{house(), flats(), office(), setbacks(), tower()};
  return models;
}

std::array<TriangleMesh, 2> carModel() {
  std::array<TriangleMesh, 2> car;
  appendBox(car[0], {-2.15, 0.3, -0.85}, {2.15, 0.85, 0.85});
  appendBox(car[0], {-1.2, 1.3, -0.68}, {0.8, 1.42, 0.68});
  const double low[] = {-1.75, 1.35}, high[] = {-1.2, 0.8};
  const auto at = [&](int x, int y, double z) {
    return y == 0 ? dvec3(low[x], 0.85, z * 0.8) : dvec3(high[x], 1.3, z * 0.68);
  };
  appendQuad(car[1], at(0, 0, 1), at(1, 0, 1), at(1, 1, 1), at(0, 1, 1));
  appendQuad(car[1], at(1, 0, -1), at(0, 0, -1), at(0, 1, -1), at(1, 1, -1));
  appendQuad(car[1], at(1, 0, 1), at(1, 0, -1), at(1, 1, -1), at(1, 1, 1));
  appendQuad(car[1], at(0, 0, -1), at(0, 0, 1), at(0, 1, 1), at(0, 1, -1));
  for (const double x : {-1.35, 1.35}) appendBox(car[1], {x - 0.3, 0, -0.88}, {x + 0.3, 0.6, 0.88});
  return car;
}

}  // namespace candela::generate
