// corridor: rooms on both sides of a corridor, lit by lamps of very unequal power, most of them behind walls.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "host/scene/generate/hash_sequence.h"
#include "host/scene/generate/many_lights.h"
#include "host/scene/generate/rotation.h"

namespace candela::generate {
namespace {

using glm::dvec3;

// Lengths are in metres. A corridor runs along z, with the middle of its floor at x = y = 0. Rooms are in pairs, one on
// either side. Walls are boxes that enter the floor, the ceiling and each other, so that none of their faces coincide.
constexpr double kRoomHeight = 2.7;
constexpr double kHalfCorridor = 1.4, kWallFar = 1.52, kWallMiddle = 1.46;  // |x| of the walls beside the corridor
constexpr double kOuterWall = 6.02;                                         // |x| of the far walls of rooms
constexpr double kRoomWidth = 4;                                            // along z
constexpr double kDoorBegin = 0.4, kDoorEnd = 1.6, kDoorHeight = 2.1;
constexpr double kLampHang = 0.02;  // distance of lamps from the ceiling

constexpr std::uint32_t kLampsPerRoom = 10, kLampsPerPair = 2 * kLampsPerRoom;
constexpr std::uint32_t kSphereInterval = 5;
constexpr std::uint32_t kMinPairs = 6;
constexpr std::uint32_t kPairsPerCorridor = 50;
constexpr std::uint32_t kBuildingStoreys = 30;
constexpr double kStoreyHeight = 3.2, kWingWidth = 14;
constexpr std::uint32_t kBoxesPerRoom = 5, kBoxesPerCorridor = 2, kShellTriangles = 16;
constexpr std::uint32_t kLampSeed = 94, kRoomSeed = 42;

std::uint32_t pairCount(std::uint32_t lamps) {
  return std::max(kMinPairs, lamps / kLampsPerPair + (lamps % kLampsPerPair > 0 ? 1 : 0));
}

// Returns the origin of a corridor. The first one is at the origin; the others are above it, and in further wings.
dvec3 corridorOrigin(std::uint32_t corridor) {
  return {kWingWidth * (corridor / kBuildingStoreys), kStoreyHeight * (corridor % kBuildingStoreys), 0};
}

// Writes in the coordinates of a corridor, or of a room and the corridor before it: z counts from the middle of its
// first wall, and x is mirrored on the left, where `side` is -1.
class Placed {
 public:
  Placed(NffWriter& out, const dvec3& origin, double side = 1) : out_(out), origin_(origin), side_(side) {}

  dvec3 at(const dvec3& local) const { return origin_ + dvec3(side_ * local.x, local.y, local.z); }

  void box(const dvec3& low, const dvec3& high) {
    const dvec3 a = at(low), b = at(high);
    out_.box(min(a, b), max(a, b));
  }

  // Writes a rectangle between two points that share a coordinate. Its front is on the side of `normal`.
  void rectangle(const dvec3& low, const dvec3& high, const dvec3& normal) {
    const dvec3 across = high - low;
    dvec3 u(0);
    for (int axis = 0; axis < 3 && u == dvec3(0); ++axis) u[axis] = across[axis];
    dvec3 v = across - u;
    if (dot(cross(u, v), normal) < 0) std::swap(u, v);
    out_.polygon(std::array{at(low), at(low + u), at(low + u + v), at(low + v)});
  }

  NffWriter& out() { return out_; }

 private:
  NffWriter& out_;
  dvec3 origin_;
  double side_;
};

Placed placeOf(NffWriter& out, std::uint32_t room) {
  const std::uint32_t pair = room / 2;
  return {out, corridorOrigin(pair / kPairsPerCorridor) + dvec3(0, 0, kRoomWidth * (pair % kPairsPerCorridor)),
          room % 2 == 0 ? 1.0 : -1.0};
}

// Writes floors, ceiling and outer walls: a closed box around a corridor and its rooms.
void writeShell(NffWriter& out, const dvec3& origin, double length) {
  Placed place(out, origin);
  constexpr double kBeyond = 0.08;
  const double near = -kBeyond, far = length + kBeyond, side = kOuterWall + kBeyond;
  out.diffuse({0.24, 0.12, 0.1});
  place.rectangle({-kWallMiddle, 0, near}, {kWallMiddle, 0, far}, {0, 1, 0});
  out.diffuse({0.42, 0.32, 0.22});
  place.rectangle({-side, 0, near}, {-kWallMiddle, 0, far}, {0, 1, 0});
  place.rectangle({kWallMiddle, 0, near}, {side, 0, far}, {0, 1, 0});
  out.diffuse(dvec3(0.8));
  place.rectangle({-side, kRoomHeight, near}, {side, kRoomHeight, far}, {0, -1, 0});
  out.diffuse({0.7, 0.68, 0.62});
  for (const double sign : {-1.0, 1.0}) {
    place.rectangle({sign * kOuterWall, -kBeyond, near}, {sign * kOuterWall, kRoomHeight + kBeyond, far},
                    {-sign, 0, 0});
  }
  place.rectangle({-side, -kBeyond, 0}, {side, kRoomHeight + kBeyond, 0}, {0, 0, 1});
  place.rectangle({-side, -kBeyond, length}, {side, kRoomHeight + kBeyond, length}, {0, 0, -1});
  for (const double sign : {-1.0, 1.0}) {  // the walls before the first doors
    Placed(out, origin, sign).box({kHalfCorridor, -0.05, -0.06}, {kWallFar, kRoomHeight + 0.1, kDoorBegin});
  }
}

// Writes the walls of rooms and what stands in them. Boxes of one material follow each other, so that a file has few
// materials.
void writeRooms(NffWriter& out, std::uint32_t firstPair, std::uint32_t pairs) {
  static constexpr std::array kRoomPaints{dvec3(0.75, 0.72, 0.66), dvec3(0.45, 0.55, 0.7), dvec3(0.72, 0.5, 0.4),
                                          dvec3(0.5, 0.66, 0.48), dvec3(0.7, 0.66, 0.4)};
  const auto forEachRoom = [&](const auto& write) {
    for (std::uint32_t room = 2 * firstPair; room < 2 * (firstPair + pairs); ++room) {
      Placed place = placeOf(out, room);
      HashSequence random(kRoomSeed, static_cast<std::int32_t>(room));
      write(place, random, room / 2 % kRoomPaints.size());
    }
  };
  out.diffuse({0.72, 0.7, 0.64});
  forEachRoom([](Placed& place, HashSequence&, std::size_t) {
    place.box({kHalfCorridor, -0.05, kDoorEnd}, {kWallFar, kRoomHeight + 0.1, kRoomWidth + kDoorBegin});
  });
  out.diffuse({0.3, 0.2, 0.12});
  forEachRoom([](Placed& place, HashSequence& random, std::size_t) {
    place.box({kHalfCorridor - 0.02, kDoorHeight, kDoorBegin - 0.05},
              {kWallFar + 0.02, kRoomHeight + 0.08, kDoorEnd + 0.05});
    place.box({1.58, -0.02, 1.9}, {2.15, random.between(1, 1.9), 3.4});
  });
  for (std::size_t i = 0; i < kRoomPaints.size(); ++i) {
    out.diffuse(kRoomPaints[i]);
    forEachRoom([&](Placed& place, HashSequence& random, std::size_t paint) {
      if (paint == i) place.box({kWallMiddle, -0.04, -0.05}, {kOuterWall + 0.05, kRoomHeight + 0.05, 0.05});
      const double bed = random.between(3.4, 3.9), height = random.between(0.4, 0.55);
      if ((paint + 2) % kRoomPaints.size() == i) place.box({bed, -0.01, 2.7}, {bed + 2, height, 3.85});
    });
  }
}

// Returns the power of a lamp by channels. Their mean is between 2^-6 and 2^6, its logarithm nearly uniform.
dvec3 lampPower(HashSequence& random) {
  static constexpr std::array kLampTints{dvec3(1.4, 1, 0.6), dvec3(1.2, 1, 0.8), dvec3(1, 1, 1), dvec3(0.8, 1, 1.2)};
  const int octave = static_cast<int>(12 * random.next()) - 6;
  const double power = std::ldexp(1 + random.next(), octave);
  return power * kLampTints[static_cast<std::size_t>(kLampTints.size() * random.next())];
}

// Writes a lamp below the ceiling, which emits its power on both sides.
void writePanel(Placed& place, const dvec3& middle, HashSequence& random) {
  const double width = random.between(0.15, 0.55), depth = random.between(0.15, 0.55);
  place.out().areaLight(place.at(middle) - dvec3(width, 0, depth) / 2.0, {width, 0, 0}, {0, 0, depth},
                        lampPower(random) / (kTurn * width * depth));
}

// Writes a spherical lamp in front of the point `foot` of a wall with this normal.
void writeBulb(Placed& place, const dvec3& foot, const dvec3& normal, HashSequence& random) {
  const double radius = random.between(0.04, 0.08);
  place.out().emitter(lampPower(random) / (kTurn * kTurn * radius * radius));
  place.out().sphere(place.at(foot + (radius + 0.03) * normal), radius);
}

// Writes one of the lamps of a room and of the corridor before it.
void writeLamp(NffWriter& out, std::uint32_t index) {
  Placed place = placeOf(out, index / kLampsPerRoom);
  HashSequence random(kLampSeed, static_cast<std::int32_t>(index));
  const std::uint32_t lamp = index % kLampsPerRoom;
  if (lamp == 0) {
    writePanel(place, {random.between(0.3, 0.8), kRoomHeight - kLampHang, random.between(0.4, 1.6)}, random);
  } else if (lamp == 4) {
    writeBulb(place, {kHalfCorridor, random.between(1.7, 2), random.between(1.9, 3.8)}, {-1, 0, 0}, random);
  } else if (lamp == 9) {
    writeBulb(place, {random.between(2.2, 5), random.between(1.4, 2), kRoomWidth - 0.05}, {0, 0, -1}, random);
  } else {
    const std::uint32_t cell = lamp < 4 ? lamp - 1 : lamp - 2;  // of four by two, of which the last is empty
    const dvec3 middle(2.15 + 1.05 * (cell % 4), kRoomHeight - kLampHang, cell < 4 ? 1.15 : 2.85);
    writePanel(place, middle + dvec3{random.between(-0.2, 0.2), 0, random.between(-0.5, 0.5)}, random);
  }
}

}  // namespace

std::uint64_t corridorPrimitives(std::uint32_t size) {
  const std::uint64_t spheres = size / kSphereInterval, quads = size - spheres;
  const std::uint64_t pairs = pairCount(size), corridors = (pairs + kPairsPerCorridor - 1) / kPairsPerCorridor;
  return 2 * quads + spheres + 2 * kBoxesPerRoom * pairs + (kBoxesPerCorridor + kShellTriangles) * corridors;
}

void writeCorridor(NffWriter& out, std::uint32_t size) {
  out.background(dvec3(0));
  out.view({{-0.95, 1.6, 0.3}, {0.45, 1.35, 9}, {0, 1, 0}, 55, 0, 960, 540});
  const std::uint32_t pairs = pairCount(size);
  for (std::uint32_t first = 0; first < pairs; first += kPairsPerCorridor) {
    const std::uint32_t count = std::min(kPairsPerCorridor, pairs - first);
    writeShell(out, corridorOrigin(first / kPairsPerCorridor), kRoomWidth * count);
    writeRooms(out, first, count);
  }
  for (std::uint32_t lamp = 0; lamp < size; ++lamp) writeLamp(out, lamp);
}

}  // namespace candela::generate
