// Divides lights by the cost of each division, and walks through the tree.
#include "host/trace/reference/light_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "host/trace/reference/arithmetic.h"

namespace candela::reference {
namespace {

constexpr std::uint32_t kDeepestLight = 31;
constexpr double kWords = 0x1p32;

}  // namespace

// Divides lists of lights, which stay in the order of the constructor.
class LightTree::Builder {
 public:
  explicit Builder(LightTree& tree) : tree_(tree) {
    axes_.reserve(tree_.lights_.size());
    for (const LightBounds& light : tree.lights_) axes_.push_back(light.axis.vector());
  }

  Node build(const std::vector<std::uint32_t>& members, std::uint32_t depth, std::uint32_t trail) {
    if (members.size() == 1) {
      tree_.trails_[members.front()] = trail;
      return {members.front(), true};
    }
    const Group group(*this, members);
    const auto self = static_cast<std::uint32_t>(tree_.inner_.size());
    tree_.inner_.push_back({group.bounds(), {}, {}});
    std::vector<std::uint32_t> low, high;
    group.divide(depth, low, high);
    tree_.inner_[self].low = build(low, depth + 1, trail);
    tree_.inner_[self].high = build(high, depth + 1, trail | 1u << depth);
    return {self, false};
  }

  LightBounds boundsOfAll() const {
    std::vector<std::uint32_t> members(tree_.lights_.size());
    std::iota(members.begin(), members.end(), 0u);
    return members.size() == 1 ? tree_.lights_.front() : Group(*this, members).bounds();
  }

 private:
  // The sums over a part of a group on which its cost depends.
  struct Part {
    std::size_t count = 0;
    double power = 0;
    dvec3 axis{0};
    Extent centres;
    double radius = 0;

    void join(const Part& other) {
      count += other.count;
      power += other.power;
      axis += other.axis;
      centres.include(other.centres.low);
      centres.include(other.centres.high);
      radius = std::max(radius, other.radius);
    }
    double cost() const {
      const double reach = length(centres.high - centres.low) / 2 + radius;
      return reach * reach * (4 * power - 3 * length(axis));
    }
  };

  static constexpr std::size_t kBins = 12;

  // The lights of a node.
  class Group {
   public:
    Group(const Builder& builder, const std::vector<std::uint32_t>& members) : builder_(builder), members_(members) {
      for (const std::uint32_t member : members) {
        centres_.include(dvec3(light(member).centre));
        isTwoSided_ |= light(member).isTwoSided;
      }
    }

    LightBounds bounds() const {
      LightBounds bounds;
      bounds.centre = centres_.middle();
      bounds.isTwoSided = isTwoSided_;
      double power = 0, reach = 0;
      dvec3 axis(0);
      for (const std::uint32_t member : members_) {
        power += light(member).power;
        reach = std::max(reach, length(dvec3(light(member).centre) - dvec3(bounds.centre)) + light(member).radius);
        axis += weightedAxis(member);
        bounds.byCosine |= light(member).byCosine;
      }
      bounds.power = static_cast<float>(power);
      bounds.radius = widerBy(reach);
      bounds.axis = StoredDirection(length(axis) <= kBoundsMargin * power ? axisOf(members_.front()) : axis);
      bounds.cosine = 1;
      const dvec3 stored = bounds.axis.vector();
      for (const std::uint32_t member : members_) {
        bounds.cosine = std::min(bounds.cosine, containing(stored, axisOf(member), light(member).cosine));
      }
      return bounds;
    }

    // Both parts are empty.
    void divide(std::uint32_t depth, std::vector<std::uint32_t>& low, std::vector<std::uint32_t>& high) const {
      const dvec3 size = centres_.high - centres_.low;
      double lowest = std::numeric_limits<double>::max();
      int axis = 0;
      std::size_t bin = kBins;
      for (int along = 0; along < 3; ++along) {
        if (size[along] <= 0) continue;
        const double stretch = std::max({size.x, size.y, size.z}) / size[along];
        const std::array<double, kBins - 1> costs = costsAlong(along);
        for (std::size_t i = 0; i < costs.size(); ++i) {
          if (costs[i] < 0 || !(costs[i] * stretch < lowest)) continue;
          lowest = costs[i] * stretch;
          axis = along;
          bin = i;
        }
      }
      if (bin < kBins) {
        for (const std::uint32_t member : members_) (binOf(member, axis) <= bin ? low : high).push_back(member);
        if (std::max(low.size(), high.size()) <= std::size_t{1} << (kDeepestLight - 1 - depth)) return;
      }
      const auto middle = members_.begin() + static_cast<std::ptrdiff_t>(members_.size() / 2);
      low.assign(members_.begin(), middle);
      high.assign(middle, members_.end());
    }

   private:
    const LightBounds& light(std::uint32_t member) const { return builder_.tree_.lights_[member]; }

    dvec3 axisOf(std::uint32_t member) const {
      const dvec3& own = builder_.axes_[member];
      return isTwoSided_ && dot(own, builder_.axes_[members_.front()]) < 0 ? -own : own;
    }

    dvec3 weightedAxis(std::uint32_t member) const {
      return double{light(member).power} * (1 + double{light(member).cosine}) / 2 * axisOf(member);
    }

    std::size_t binOf(std::uint32_t member, int axis) const {
      const double within = light(member).centre[axis] - centres_.low[axis];
      const double width = centres_.high[axis] - centres_.low[axis];
      return std::min(kBins - 1, static_cast<std::size_t>(kBins * (within / width)));
    }

    // Returns the sum of the costs of both parts of each division; negative without a light in one of them.
    std::array<double, kBins - 1> costsAlong(int axis) const {
      std::array<Part, kBins> bins;
      for (const std::uint32_t member : members_) {
        Part one{1, light(member).power, weightedAxis(member), {}, light(member).radius};
        one.centres.include(dvec3(light(member).centre));
        bins[binOf(member, axis)].join(one);
      }
      std::array<double, kBins - 1> costs;
      Part below, above;
      double costBelow = -1, costAbove = -1;
      for (std::size_t i = 0; i + 1 < kBins; ++i) {
        if (bins[i].count > 0) {
          below.join(bins[i]);
          costBelow = below.cost();
        }
        costs[i] = costBelow;
      }
      for (std::size_t i = kBins - 1; i > 0; --i) {
        if (bins[i].count > 0) {
          above.join(bins[i]);
          costAbove = above.cost();
        }
        costs[i - 1] = costs[i - 1] < 0 || costAbove < 0 ? -1 : costs[i - 1] + costAbove;
      }
      return costs;
    }

    const Builder& builder_;
    const std::vector<std::uint32_t>& members_;
    Extent centres_;
    bool isTwoSided_ = false;
  };

  LightTree& tree_;
  std::vector<dvec3> axes_;
};

void LightTree::setLights(std::vector<LightBounds> lights, const std::vector<double>& powers) {
  lights_ = std::move(lights);
  double sum = 0;
  for (const double power : powers) sum += power;
  for (std::size_t i = 0; i < lights_.size(); ++i) lights_[i].power = static_cast<float>(powers[i] / sum);
}

LightTree::LightTree(std::vector<LightBounds> lights, std::vector<double> powers, std::uint32_t dimensions)
    : dimensions_(dimensions) {
  setLights(std::move(lights), powers);
  powers = {};
  trails_.resize(lights_.size());
  inner_.reserve(lights_.size() - 1);
  std::vector<std::uint32_t> members(lights_.size());
  std::iota(members.begin(), members.end(), 0u);
  root_ = Builder(*this).build(members, 0, 0);
}

LightBounds LightTree::boundsOf(std::vector<LightBounds> lights, const std::vector<double>& powers) {
  LightTree tree;
  tree.setLights(std::move(lights), powers);
  return Builder(tree).boundsOfAll();
}

std::uint64_t LightTree::lowWords(const Inner& inner, const PlacedReceiver& receiver, Arithmetic& arithmetic) const {
  double low = boundsOf(inner.low).importance(receiver, arithmetic);
  double high = boundsOf(inner.high).importance(receiver, arithmetic);
  if (low == 0 && high == 0) {
    low = boundsOf(inner.low).power;
    high = boundsOf(inner.high).power;
  }
  if (high == 0) return std::uint64_t{1} << 32;
  if (low == 0) return 0;
  return static_cast<std::uint64_t>(kWords * std::clamp(low / (low + high), 0x1p-16, 1 - 0x1p-16));
}

LightTree::Choice LightTree::choose(const PlacedReceiver& receiver, const VertexNumbers& u,
                                    Arithmetic& arithmetic) const {
  double probability = 1;
  Node node = root_;
  for (std::uint32_t depth = 0; !node.isLight; ++depth) {
    const Inner& inner = inner_[node.index];
    const std::uint64_t words = lowWords(inner, receiver, arithmetic);
    const bool isLow = u.lightTree(dimensions_, depth) < words;
    arithmetic.decide(isLow);
    const double low = static_cast<double>(words) / kWords;
    probability *= isLow ? low : 1 - low;
    node = isLow ? inner.low : inner.high;
  }
  return {node.index, probability};
}

double LightTree::probability(std::uint32_t light, const PlacedReceiver& receiver, Arithmetic& arithmetic) const {
  double probability = 1;
  Node node = root_;
  for (std::uint32_t trail = trails_[light]; !node.isLight; trail >>= 1) {
    const Inner& inner = inner_[node.index];
    const double low = static_cast<double>(lowWords(inner, receiver, arithmetic)) / kWords;
    probability *= trail & 1 ? 1 - low : low;
    node = trail & 1 ? inner.high : inner.low;
  }
  return probability;
}

}  // namespace candela::reference
