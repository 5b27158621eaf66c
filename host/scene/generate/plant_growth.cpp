// Grows branches from branches, generation by generation.
#include "host/scene/generate/plant_growth.h"

#include <algorithm>
#include <cmath>

#include "host/scene/generate/hash_sequence.h"
#include "host/scene/generate/rotation.h"

namespace candela::generate {
namespace {

using glm::dvec3;

constexpr double kGoldenAngle = kTurn * 0.381966;
constexpr double kDepth = 0.6;  // of the foot of a trunk below the ground, in metres
const dvec3 kUp{0, 1, 0};

double radians(double degrees) { return degrees * kTurn / 360; }

// Returns a unit vector at right angles to a unit vector.
dvec3 perpendicular(const dvec3& v) {
  const dvec3 other = std::abs(v.x) < 0.7 ? dvec3(1, 0, 0) : dvec3(0, 0, 1);
  return normalize(cross(v, other));
}

dvec3 randomDirection(HashSequence& random) {
  const double height = random.between(-1, 1), turn = random.between(0, kTurn);
  const double radius = std::sqrt(1 - height * height);
  return {radius * std::cos(turn), height, radius * std::sin(turn)};
}

// A ring of a tube.
struct Joint {
  dvec3 point;
  dvec3 direction;
  double radius;
};

void appendTube(TriangleMesh& mesh, const std::vector<Joint>& joints, int sides) {
  dvec3 side = perpendicular(joints.front().direction);
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const auto around = static_cast<std::uint32_t>(sides);
  for (const Joint& joint : joints) {
    side = normalize(side - joint.direction * dot(side, joint.direction));
    const dvec3 other = cross(joint.direction, side);
    for (std::uint32_t i = 0; i < around; ++i) {
      const double turn = kTurn * i / sides;
      const dvec3 normal = side * std::cos(turn) + other * std::sin(turn);
      mesh.positions.emplace_back(joint.point + joint.radius * normal);
      mesh.normals.emplace_back(normal);
    }
  }
  for (std::uint32_t ring = 0; ring + 1 < joints.size(); ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const std::uint32_t a = first + ring * around + i, b = first + ring * around + (i + 1) % around;
      mesh.indices.insert(mesh.indices.end(), {a, b, b + around, a, b + around, a + around});
    }
  }
}

class Grower {
 public:
  Grower(const PlantStyle& style, std::uint32_t seed) : style_(style), random_(seed) {}

  Plant grow() {
    const BranchLevel& trunk = style_.levels.front();
    growBranch({{0, -kDepth, 0},
                normalize(dvec3{random_.between(-0.04, 0.04), 1, random_.between(-0.04, 0.04)}),
                trunk.radius},
               trunk.length + kDepth, 0);
    return std::move(plant_);
  }

 private:
  void growBranch(const Joint& start, double length, std::size_t level) {
    const BranchLevel& own = style_.levels[level];
    std::vector<Joint> joints{start};
    for (int i = 1; i <= own.segments; ++i) {
      Joint joint = joints.back();
      joint.point += joint.direction * (length / own.segments);
      joint.direction = normalize(joint.direction + kUp * (own.lift / own.segments) +
                                  randomDirection(random_) * (own.wander / own.segments));
      joint.radius = start.radius * std::lerp(1, own.taper, static_cast<double>(i) / own.segments);
      joints.push_back(joint);
    }
    if (level == 0) joints.front().radius *= 1.5;  // at the roots
    appendTube(plant_.bark, joints, own.sides);
    if (level + 1 < style_.levels.size()) {
      growChildren(joints, level + 1);
    } else {
      addLeaves(joints);
    }
  }

  void growChildren(const std::vector<Joint>& joints, std::size_t level) {
    const BranchLevel& own = style_.levels[level];
    double turn = random_.between(0, kTurn);
    for (int i = 0; i < own.count; ++i) {
      const double t = (i + random_.next()) / own.count;
      Joint joint = along(joints, std::lerp(own.from, 1, t));
      const dvec3 side = perpendicular(joint.direction), other = cross(joint.direction, side);
      const double angle = radians(std::lerp(own.lowAngle, own.highAngle, t) + random_.between(-8, 8));
      joint.direction = std::cos(angle) * joint.direction +
                        std::sin(angle) * (std::cos(turn) * side + std::sin(turn) * other);
      joint.radius *= own.radius;
      const double length = own.length * (std::lerp(1, own.tipLength, t) + own.middle * 4 * t * (1 - t));
      growBranch(joint, length * random_.between(0.8, 1.15), level);
      turn += kGoldenAngle + random_.between(-0.3, 0.3);
    }
  }

  static Joint along(const std::vector<Joint>& joints, double fraction) {
    const double position = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(joints.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(position), joints.size() - 2);
    const double weight = position - static_cast<double>(i);
    return {mix(joints[i].point, joints[i + 1].point, weight),
            normalize(mix(joints[i].direction, joints[i + 1].direction, weight)),
            std::lerp(joints[i].radius, joints[i + 1].radius, weight)};
  }

  void addLeaves(const std::vector<Joint>& joints) {
    const LeafStyle& leaf = style_.leaves;
    for (int i = 0; i < leaf.count; ++i) {
      const Joint joint = along(joints, std::lerp(leaf.from, 1, (i + random_.next()) / leaf.count));
      const dvec3 side = normalize(cross(joint.direction, kUp) + 1e-3 * randomDirection(random_)) *
                         (i % 2 == 0 ? 1.0 : -1.0);
      const dvec3 ordered = 0.6 * joint.direction + side;
      const dvec3 along = normalize(mix(ordered, randomDirection(random_), leaf.scatter) - leaf.droop * kUp);
      const dvec3 direction = randomDirection(random_);
      addLeaf(joint.point + leaf.spread * std::sqrt(random_.next()) * direction, along);
    }
  }

  // The base, the sides and the tip of a leaf. Its front faces away from the middle of the crown.
  void addLeaf(const dvec3& base, const dvec3& along) {
    const LeafStyle& leaf = style_.leaves;
    const dvec3 outwards = normalize(base - dvec3(0, style_.crownCentre, 0) + 0.3 * randomDirection(random_));
    const dvec3 wanted = outwards + 0.7 * kUp + 0.9 * randomDirection(random_);
    const dvec3 side = normalize(cross(along, wanted) + 1e-3 * perpendicular(along));
    const dvec3 front = cross(side, along);
    const double size = random_.between(0.75, 1.25);
    const dvec3 middle = base + 0.45 * size * leaf.length * along + size * leaf.fold * leaf.width * front;
    const dvec3 halfWidth = 0.5 * size * leaf.width * side;
    TriangleMesh& mesh = plant_.leaves;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const double bend = 1.2 * leaf.fold;
    const auto add = [&](const dvec3& position, const dvec3& normal) {
      mesh.positions.emplace_back(position);
      mesh.normals.emplace_back(normalize(normal + 0.5 * outwards));
    };
    add(base, front);
    add(middle + halfWidth, front - bend * side);
    add(base + size * leaf.length * along, front);
    add(middle - halfWidth, front + bend * side);
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2, first, first + 2, first + 3});
  }

  const PlantStyle& style_;
  HashSequence random_;
  Plant plant_;
};

}  // namespace

Plant growPlant(const PlantStyle& style, std::uint32_t seed) { return Grower(style, seed).grow(); }

TriangleMesh grassTuft(std::uint32_t blades, std::uint32_t seed) {
  constexpr double kHalfWidth = 0.009;
  HashSequence random(seed);
  TriangleMesh mesh;
  for (std::uint32_t blade = 0; blade < blades; ++blade) {
    const double turn = random.between(0, kTurn), distance = 0.3 * std::sqrt(random.next());
    const double height = random.between(0.2, 0.5), lean = random.between(0.05, 0.3);
    const dvec3 outwards(std::cos(turn), 0, std::sin(turn));
    const dvec3 side = dvec3(-outwards.z, 0, outwards.x) * kHalfWidth;
    const dvec3 foot = distance * outwards - 0.05 * kUp;
    const dvec3 middle = foot + 0.6 * height * kUp + 0.3 * lean * outwards;
    const dvec3 tip = foot + height * kUp + lean * outwards;
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const dvec3 normal = normalize(kUp + 0.6 * outwards);
    for (const dvec3& position : {foot - side, foot + side, middle - side, middle + side, tip}) {
      mesh.positions.emplace_back(position);
      mesh.normals.emplace_back(normal);
    }
    mesh.indices.insert(mesh.indices.end(),
                        {first, first + 1, first + 3, first, first + 3, first + 2, first + 2, first + 3, first + 4});
  }
  return mesh;
}

}  // namespace candela::generate
