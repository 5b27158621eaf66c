// Fills blocks with buildings, taller towards the centre.
#include "host/scene/generate/city_plan.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "host/scene/generate/hash_sequence.h"
#include "host/scene/generate/rotation.h"
#include "host/scene/generate/value_noise.h"

namespace candela::generate {
namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double kStreet = 12, kHalfAvenue = 13;  // widths of roads, in metres
constexpr double kLot = 19;
constexpr dvec2 kCityCentre{70, -210};
constexpr std::uint32_t kLotSeed = 31, kCarSeed = 32, kStreetTreeSeed = 33;
constexpr double kAvenueNear = 330, kAvenueFar = -1500;  // ends of what moves and grows on the avenue

// Returns the middle of a block. Columns 0 and -1 are beside the avenue.
dvec2 blockMiddle(int column, int row) {
  const double x = column >= 0 ? kHalfAvenue + column * (CityPlan::kBlockWidth + kStreet) + CityPlan::kBlockWidth / 2
                               : -blockMiddle(-1 - column, 0).x;
  return {x, row * (CityPlan::kBlockDepth + kStreet)};
}

struct Lot {
  double rank;
  dvec2 place;
  dvec2 block;
  HashSequence random;
};

std::vector<Lot> lotsWithin(double reach) {
  const int columns = static_cast<int>(reach / (CityPlan::kBlockWidth + kStreet)) + 3;
  const int rows = static_cast<int>((reach - kCityCentre.y) / (CityPlan::kBlockDepth + kStreet)) + 3;
  std::vector<Lot> lots;
  for (int row = -rows; row <= rows; ++row) {
    for (int column = -columns; column < columns; ++column) {
      const dvec2 middle = blockMiddle(column, row);
      for (int i = 0; i < 6; ++i) {
        const dvec2 place = middle + kLot * dvec2(i % 3 - 1, i / 3 - 0.5);
        const double edge = 0.85 + 0.3 * fractalNoise({place / 150.0, 1.5}, 3);
        lots.push_back(
            {length(place - kCityCentre) * edge, place, middle, HashSequence(kLotSeed, 6 * column + i, row)});
      }
    }
  }
  std::ranges::stable_sort(lots, {}, &Lot::rank);
  return lots;
}

BuildingPlace buildingOn(Lot& lot) {
  HashSequence& random = lot.random;
  const double groups = fractalNoise({lot.place / 110.0, 5.5}, 3) - 0.5;
  const double central = length(lot.place - kCityCentre) / 330 + 0.9 * groups + random.between(-0.22, 0.22);
  constexpr double kLimits[] = {0.24, 0.5, 0.85, 1.45};  // of towers, buildings with setbacks, offices and flats
  std::size_t rank = 0;
  while (rank < 4 && central > kLimits[rank]) ++rank;
  BuildingPlace result;
  result.building = static_cast<Building>(kBuildingCount - 1 - rank);
  const double height = random.between(0.82, 1.2) * (1 + 0.35 * smoothStep(0.5, -0.1, central));
  result.place = {
      {lot.place.x, CityPlan::kKerb, lot.place.y}, kTurn / 4 * std::floor(4 * random.next()), {1, height, 1}};
  result.tint = static_cast<std::size_t>(kFacadeTints * random.next());
  return result;
}

MeshInstance treeOn(double x, double z, HashSequence& random) {
  const double size = random.between(0.5, 0.72);
  return {{x, CityPlan::kKerb, z}, random.between(0, kTurn), {size, 1.1 * size, size}};
}

void addPlaza(const Lot& lot, CityPlan& plan) {
  HashSequence random = lot.random;
  for (int i = 0; i < 6; ++i) {
    plan.trees.push_back(treeOn(lot.place.x + 6 * (i % 3 - 1) + random.between(-1.5, 1.5),
                                lot.place.y + 9 * (i / 3 - 0.5) + random.between(-1.5, 1.5), random));
  }
}

bool isJunction(double z) {
  constexpr double kPitch = CityPlan::kBlockDepth + kStreet;
  return std::abs(std::remainder(z, kPitch)) > CityPlan::kBlockDepth / 2 - 1;
}

void addAvenue(CityPlan& plan) {
  for (std::int32_t i = 0; kAvenueNear - 9 * i > kAvenueFar; ++i) {
    const double z = kAvenueNear - 9 * i;
    for (const int side : {-1, 1}) {
      HashSequence random(kStreetTreeSeed, i, side);
      if (!isJunction(z) && random.next() < 0.9) plan.trees.push_back(treeOn(side * (kHalfAvenue + 1.3), z, random));
      for (const double x : {4.0, 7.6}) {
        if (!isJunction(z)) plan.dashes.push_back({{side * x, 0, z}});
      }
      for (const double x : {2.1, 5.8, 10.2}) {
        const bool isParked = x > 9;
        if (random.next() > (isParked ? 0.45 : 0.22) || (isParked && isJunction(z))) continue;
        plan.cars.push_back(
            {{side * x + random.between(-0.2, 0.2), 0, z + random.between(-1.5, 1.5)}, side * kTurn / 4});
      }
    }
  }
}

// Cars on the streets across the avenue.
void addCrossTraffic(CityPlan& plan) {
  constexpr double kPitch = CityPlan::kBlockDepth + kStreet;
  for (int row = -24; row <= 5; ++row) {
    for (int i = -36; i <= 36; ++i) {
      HashSequence random(kCarSeed, i, row);
      const double x = 8.0 * i + random.between(-1, 1), side = random.next() < 0.5 ? -1 : 1;
      if (std::abs(x) < kHalfAvenue + 3 || random.next() > 0.35) continue;
      plan.cars.push_back({{x, 0, (row + 0.5) * kPitch + side * 2.4}, side > 0 ? 0 : kTurn / 2});
    }
  }
}

}  // namespace

CityPlan planCity(std::uint32_t count) {
  // The area of a circle with twice as many lots as are needed.
  std::vector<Lot> lots = lotsWithin(120 + std::sqrt(2.0 * 700 * count / 3));
  CityPlan plan;
  std::set<std::pair<double, double>> blocks;
  for (Lot& lot : lots) {
    if (plan.buildings.size() == count) break;
    if (blocks.insert({lot.block.x, lot.block.y}).second) plan.blocks.push_back({{lot.block.x, 0, lot.block.y}});
    plan.radius = std::max(plan.radius, length(lot.block) + CityPlan::kBlockWidth);
    if (lot.random.next() < 0.035) {
      addPlaza(lot, plan);
    } else {
      plan.buildings.push_back(buildingOn(lot));
    }
  }
  addAvenue(plan);
  addCrossTraffic(plan);
  return plan;
}

}  // namespace candela::generate
