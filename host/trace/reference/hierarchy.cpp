// Boxes of primitives, and the construction of the BVH.
#include "host/trace/reference/hierarchy.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/scene/shape.h"

namespace candela::reference {
namespace {

Bounds ofPoints(std::initializer_list<dvec3> points) {
  Bounds bounds;
  for (const dvec3& point : points) bounds.extend({point, point});
  return bounds;
}

Bounds around(const dvec3& centre, const dvec3& halfSize) { return {centre - halfSize, centre + halfSize}; }

// Returns the bounds of the circle with unit normal `axis`, which extends radius * sin(angle between axis and x) along
// x.
Bounds ofCircle(const dvec3& centre, const dvec3& axis, double radius) {
  return around(centre, radius * glm::sqrt(glm::max(dvec3(0), 1.0 - axis * axis)));
}

std::optional<Bounds> exactBounds(const scene::Sphere& sphere) {
  return around(sphere.centre, dvec3(std::abs(sphere.radius)));
}

std::optional<Bounds> exactBounds(const scene::Triangle& triangle) {
  return ofPoints({triangle.p[0], triangle.p[1], triangle.p[2]});
}

std::optional<Bounds> exactBounds(const scene::Box& box) { return Bounds{box.min, box.max}; }

std::optional<Bounds> exactBounds(const scene::Cone& cone) {
  const dvec3 axis = glm::normalize(dvec3(cone.apex) - dvec3(cone.base));
  Bounds bounds = ofCircle(cone.base, axis, cone.baseRadius);
  bounds.extend(ofCircle(cone.apex, axis, cone.apexRadius));
  return bounds;
}

std::optional<Bounds> exactBounds(const scene::Plane&) { return std::nullopt; }

Bounds widened(const Bounds& bounds) {
  const dvec3 reach = glm::max(glm::abs(bounds.min), glm::abs(bounds.max));
  return bounds.padded(kWidening * std::max({reach.x, reach.y, reach.z}));
}

class Builder {
 public:
  Builder(std::span<const Bounds> boxes, render::BvhSplit split) : boxes_(boxes), split_(split) {
    for (const Bounds& box : boxes) twiceCentres_.push_back(box.min + box.max);
    result_.order.resize(boxes.size());
    std::iota(result_.order.begin(), result_.order.end(), 0u);
  }

  Hierarchy build() {
    if (!boxes_.empty()) buildNode(0, static_cast<std::uint32_t>(boxes_.size()), 0);
    return std::move(result_);
  }

 private:
  void buildNode(std::uint32_t begin, std::uint32_t end, std::uint32_t depth) {
    const auto index = static_cast<std::uint32_t>(result_.nodes.size());
    const bool isMidpoint = split_ == render::BvhSplit::midpoint;
    result_.nodes.push_back(summarize(begin, end));
    if (end - begin <= (isMidpoint ? Hierarchy::kMidpointLeafSize : Hierarchy::kLeafSize)) {
      result_.nodes[index].first = begin;
      result_.nodes[index].count = static_cast<std::uint16_t>(end - begin);
      return;
    }
    const Node node = result_.nodes[index];
    const std::uint32_t middle = isMidpoint && depth < Hierarchy::kMidpointDepth ? splitAtMidpoint(node, begin, end)
                                                                                 : halve(node, begin, end);
    buildNode(begin, middle, depth + 1);
    result_.nodes[index].first = static_cast<std::uint32_t>(result_.nodes.size());
    buildNode(middle, end, depth + 1);
  }

  auto at(std::uint32_t index) { return result_.order.begin() + index; }

  // Returns the start of the right half.
  std::uint32_t halve(const Node& node, std::uint32_t begin, std::uint32_t end) {
    const int axis = node.axis;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(at(begin), at(middle), at(end), [&](std::uint32_t a, std::uint32_t b) {
      const double centreA = twiceCentres_[a][axis];
      const double centreB = twiceCentres_[b][axis];
      return centreA != centreB ? centreA < centreB : a < b;
    });
    return middle;
  }

  std::uint32_t splitAtMidpoint(const Node& node, std::uint32_t begin, std::uint32_t end) {
    const int axis = node.axis;
    const auto splitBelow = [&](double twicePlane) {
      const auto isLeft = [&](std::uint32_t item) { return twiceCentres_[item][axis] < twicePlane; };
      return static_cast<std::uint32_t>(std::stable_partition(at(begin), at(end), isLeft) - at(0));
    };
    const auto isOneSided = [&](std::uint32_t middle) { return middle == begin || middle == end; };
    std::uint32_t middle = splitBelow(node.bounds.min[axis] + node.bounds.max[axis]);
    if (isOneSided(middle)) middle = splitBelow(meanTwiceCentre(axis, begin, end));
    return isOneSided(middle) ? begin + 2 : middle;
  }

  double meanTwiceCentre(int axis, std::uint32_t begin, std::uint32_t end) const {
    double sum = 0;
    for (std::uint32_t i = begin; i < end; ++i) sum += twiceCentres_[result_.order[i]][axis];
    return sum / (end - begin);
  }

  // Computes the box of a range, and the axis along which to split it: the axis with the largest extent of the centres
  // or, for midpoint splits, of the box.
  Node summarize(std::uint32_t begin, std::uint32_t end) const {
    Node node;
    Bounds centres;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t item = result_.order[i];
      node.bounds.extend(boxes_[item]);
      centres.extend({twiceCentres_[item], twiceCentres_[item]});
    }
    const Bounds& measured = split_ == render::BvhSplit::midpoint ? node.bounds : centres;
    const dvec3 extent = measured.max - measured.min;
    const bool xyLess = extent.x < extent.y;
    node.axis = std::max(extent.x, extent.y) < extent.z ? 2 : (xyLess ? 1 : 0);
    return node;
  }

  std::span<const Bounds> boxes_;
  render::BvhSplit split_;
  std::vector<dvec3> twiceCentres_;
  Hierarchy result_;
};

}  // namespace

std::optional<Bounds> boundsOf(const scene::Scene& scene, const scene::Primitive& primitive) {
  const auto bounds = std::visit([](const auto& shape) { return exactBounds(shape); },
                                 scene::shapeOf(scene, primitive));
  if (!bounds) return std::nullopt;
  return widened(*bounds);
}

Hierarchy buildHierarchy(std::span<const Bounds> boxes, render::BvhSplit split) {
  return Builder(boxes, split).build();
}

}  // namespace candela::reference
