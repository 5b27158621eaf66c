// Builds the light tree from the top by a surface area orientation heuristic with bins.
#include "host/trace/flatten/light_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "host/trace/flatten/light_table.h"
#include "shaders/shared/scene_rows.h"

namespace candela::flatten {
namespace {

using glm::dvec3;

constexpr double kSlack = 0x1p-20;
constexpr double kOctahedronSteps = 8192;
constexpr std::uint32_t kMaxDepth = 31;  // of a leaf

float rounded(double value) { return static_cast<float>(value); }

double signOf(double value) { return value < 0 ? -1 : 1; }

std::uint32_t packDirection(const dvec3& v) {
  const double s = (std::abs(v.x) + std::abs(v.y)) + std::abs(v.z);
  double p = v.x / s, q = v.y / s;
  if (v.z < 0) {
    const double folded = (1 - std::abs(q)) * signOf(v.x);
    q = (1 - std::abs(p)) * signOf(v.y);
    p = folded;
  }
  const auto step = [](double u) { return static_cast<std::uint32_t>(std::floor(kOctahedronSteps * (u + 1) + 0.5)); };
  return step(p) | step(q) << gpu::kDirectionBits;
}

dvec3 unpackDirection(std::uint32_t word) {
  const auto coordinate = [](std::uint32_t step) { return step / kOctahedronSteps - 1; };
  double x = coordinate(word & gpu::kDirectionMask);
  double y = coordinate(word >> gpu::kDirectionBits & gpu::kDirectionMask);
  const double z = 1 - std::abs(x) - std::abs(y);
  if (z < 0) {
    const double folded = (1 - std::abs(y)) * signOf(x);
    y = (1 - std::abs(x)) * signOf(y);
    x = folded;
  }
  const dvec3 v(x, y, z);
  return v / glm::length(v);
}

// The cosine of the angle of a cone around `direction` with the cosine `cone`, as seen from `axis`.
float widened(double cone, const dvec3& direction, const dvec3& axis) {
  if (cone == -1) return -1;
  const double k = std::min(glm::dot(axis, direction), 1.0);
  const double kSine = std::sqrt(std::max(0.0, 1 - k * k));
  const double coneSine = std::sqrt(std::max(0.0, 1 - cone * cone));
  if (kSine * cone + coneSine * k < 0) return -1;
  const double cosine = std::max(-1.0, k * cone - kSine * coneSine);
  return rounded(std::max(-1.0, cosine - kSlack));
}

void setTriangle(const scene::Triangle& triangle, bool oneSided, LightNode& leaf) {
  const std::array<dvec3, 3> p{dvec3(triangle.p[0]), dvec3(triangle.p[1]), dvec3(triangle.p[2])};
  const dvec3 low = glm::min(glm::min(p[0], p[1]), p[2]), high = glm::max(glm::max(p[0], p[1]), p[2]);
  leaf.centre = glm::vec3((low + high) / 2.0);
  double radius = 0;
  for (const dvec3& vertex : p) radius = std::max(radius, glm::length(vertex - dvec3(leaf.centre)));
  leaf.radius = rounded(radius * (1 + kSlack));
  const dvec3 across = glm::cross(p[1] - p[0], p[2] - p[0]);
  const std::uint32_t axis = packDirection(across);
  leaf.cosine = rounded(std::min(glm::dot(unpackDirection(axis), across / glm::length(across)), 1.0) - kSlack);
  leaf.axis = axis | gpu::kLightNodeCosine | (oneSided ? 0 : gpu::kLightNodeTwoSided);
}

void setSphere(const scene::Sphere& sphere, LightNode& leaf) {
  leaf.centre = sphere.centre;
  leaf.radius = std::abs(sphere.radius);
  leaf.axis = packDirection({0, 0, 1}) | gpu::kLightNodeCosine;
}

void setPunctual(const scene::PunctualLight& light, LightNode& leaf) {
  leaf.centre = light.position;
  leaf.axis = packDirection({0, 0, 1});
  if (light.kind != scene::PunctualLight::Kind::spot) return;
  const dvec3 direction(light.direction);
  leaf.axis = packDirection(direction);
  leaf.cosine = widened(1 - double{light.versineOuter}, direction / glm::length(direction), unpackDirection(leaf.axis));
}

// Sets the powers of leaves from their intensities.
void setPowers(std::span<const double> intensities, std::span<LightNode> leaves) {
  const double sum = std::accumulate(intensities.begin(), intensities.end(), 0.0);
  for (std::size_t i = 0; i < leaves.size(); ++i) leaves[i].power = rounded(intensities[i] / sum);
}

double intensityOf(const LightEntry& entry) { return entry.kind == LightKind::sphere ? entry.power / 4 : entry.power; }

// The sums over a set of leaves on which the costs of splits depend. Uninitialised unless set.
struct Sums {
  std::uint32_t count;
  double power;
  dvec3 axes;
  dvec3 low, high;
  double radius;

  void add(const Sums& other) {
    count += other.count;
    power += other.power;
    axes += other.axes;
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
    radius = std::max(radius, other.radius);
  }

  double cost() const {
    const double reach = glm::length(high - low) / 2 + radius;
    return reach * reach * (4 * power - 3 * glm::length(axes));
  }
};

constexpr std::uint32_t kBins = 12;

// The bins of an axis. Most nodes have few leaves, so that only the bins that have some are set and read.
class Bins {
 public:
  void add(std::uint32_t bin, const Sums& one) {
    if (filled_ & 1u << bin) {
      sums_[bin].add(one);
    } else {
      filled_ |= 1u << bin;
      sums_[bin] = one;
    }
  }
  // Returns the bins that have leaves, in ascending order.
  std::span<const std::uint32_t> filled(std::array<std::uint32_t, kBins>& bins) const {
    std::size_t count = 0;
    for (std::uint32_t rest = filled_; rest != 0; rest &= rest - 1) bins[count++] = std::countr_zero(rest);
    return std::span(bins).first(count);
  }
  const Sums& operator[](std::uint32_t bin) const { return sums_[bin]; }

 private:
  std::uint32_t filled_ = 0;  // a bit for each bin
  std::array<Sums, kBins> sums_;
};

struct Split {
  double cost;
  int axis;
  std::uint32_t bin;    // the last one of the lower side
  std::uint32_t lower;  // number of leaves there
};

class Builder {
 public:
  explicit Builder(std::vector<LightNode> leaves) : leaves_(std::move(leaves)), order_(leaves_.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    axes_.reserve(leaves_.size());
    for (const LightNode& leaf : leaves_) axes_.push_back(unpackDirection(leaf.axis));
  }

  // Sets the trails of the leaves, in the order of the tree.
  LightTree build(std::vector<std::uint32_t>& trails) {
    const auto count = static_cast<std::uint32_t>(leaves_.size());
    trails_.resize(count);
    inner_.resize(count - 1);
    if (count == 1) {
      setTrail(0, 0);
    } else {
      buildNode(0, count, 0, 0, 0);
    }
    axes_ = {};
    trails = std::move(trails_);
    sortLeaves();
    return {std::move(leaves_), std::move(inner_)};
  }

  LightNode root() const {
    const auto count = static_cast<std::uint32_t>(leaves_.size());
    return count == 1 ? leaves_.front() : nodeOf(rangeOf(0, count));
  }

 private:
  // The leaves of a range as they count in their node.
  struct Range {
    std::uint32_t begin, end;
    bool isTwoSided = false;
    dvec3 firstAxis;
    dvec3 low, high;  // of the box of the centres
  };

  const LightNode& leaf(std::uint32_t position) const { return leaves_[order_[position]]; }

  dvec3 axisOf(std::uint32_t position, const Range& range) const {
    const dvec3& axis = axes_[order_[position]];
    return range.isTwoSided && glm::dot(axis, range.firstAxis) < 0 ? -axis : axis;
  }

  static double axisWeight(const LightNode& leaf) { return double{leaf.power} * (1 + double{leaf.cosine}) / 2; }

  Range rangeOf(std::uint32_t begin, std::uint32_t end) const {
    Range range{begin, end, false, axes_[order_[begin]], dvec3(leaf(begin).centre), dvec3(leaf(begin).centre)};
    for (std::uint32_t i = begin; i < end; ++i) {
      range.isTwoSided |= (leaf(i).axis & gpu::kLightNodeTwoSided) != 0;
      range.low = glm::min(range.low, dvec3(leaf(i).centre));
      range.high = glm::max(range.high, dvec3(leaf(i).centre));
    }
    return range;
  }

  LightNode nodeOf(const Range& range) const {
    LightNode node;
    node.centre = glm::vec3((range.low + range.high) / 2.0);
    double power = 0, radius = 0;
    dvec3 axes(0);
    std::uint32_t flags = 0;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const LightNode& one = leaf(i);
      power += one.power;
      radius = std::max(radius, glm::length(dvec3(one.centre) - dvec3(node.centre)) + one.radius);
      axes += axisWeight(one) * axisOf(i, range);
      flags |= one.axis & (gpu::kLightNodeCosine | gpu::kLightNodeTwoSided);
    }
    node.power = rounded(power);
    node.radius = rounded(radius * (1 + kSlack));
    const std::uint32_t stored = packDirection(glm::length(axes) <= kSlack * power ? range.firstAxis : axes);
    const dvec3 axis = unpackDirection(stored);
    node.axis = stored | flags;
    node.cosine = 1;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      node.cosine = std::min(node.cosine, widened(leaf(i).cosine, axisOf(i, range), axis));
    }
    return node;
  }

  static std::uint32_t binOf(const LightNode& leaf, const Range& range, int axis) {
    const double place = (double{leaf.centre[axis]} - range.low[axis]) / (range.high[axis] - range.low[axis]);
    return std::min(kBins - 1, static_cast<std::uint32_t>(std::floor(kBins * place)));
  }

  std::array<Bins, 3> binsOf(const Range& range) const {
    std::array<Bins, 3> bins;
    for (std::uint32_t i = range.begin; i < range.end; ++i) {
      const LightNode& one = leaf(i);
      const dvec3 centre(one.centre);
      const Sums sums{1, one.power, axisWeight(one) * axisOf(i, range), centre, centre, one.radius};
      for (int axis = 0; axis < 3; ++axis) {
        if (range.high[axis] > range.low[axis]) bins[axis].add(binOf(one, range, axis), sums);
      }
    }
    return bins;
  }

  static void improve(std::optional<Split>& best, const Bins& bins, int axis, double stretch) {
    std::array<std::uint32_t, kBins> places;
    const std::span<const std::uint32_t> filled = bins.filled(places);
    std::array<Sums, kBins> upper;  // of each of these bins and those after it
    for (std::size_t i = filled.size(); i-- > 0;) {
      upper[i] = bins[filled[i]];
      if (i + 1 == filled.size()) continue;
      upper[i] = upper[i + 1];
      upper[i].add(bins[filled[i]]);
    }
    Sums lower = bins[filled[0]];
    for (std::size_t i = 0; i + 1 < filled.size(); ++i) {
      if (i > 0) lower.add(bins[filled[i]]);
      const double cost = (lower.cost() + upper[i + 1].cost()) * stretch;
      if (!best || cost < best->cost) best = Split{cost, axis, filled[i], lower.count};
    }
  }

  // Returns the end of the left range.
  std::uint32_t split(const Range& range, std::uint32_t depth) {
    const dvec3 extent = range.high - range.low;
    const double longest = std::max({extent.x, extent.y, extent.z});
    const std::array<Bins, 3> bins = binsOf(range);
    std::optional<Split> best;
    for (int axis = 0; axis < 3; ++axis) {
      if (extent[axis] > 0) improve(best, bins[axis], axis, longest / extent[axis]);
    }
    if (best) {
      const auto isLower = [&](std::uint32_t one) { return binOf(leaves_[one], range, best->axis) <= best->bin; };
      const auto first = order_.begin() + range.begin, last = order_.begin() + range.end;
      const std::uint32_t lower = best->lower;
      const std::uint32_t upper = range.end - range.begin - lower;
      if (std::max(lower, upper) <= 1u << (kMaxDepth - 1 - depth)) {
        std::stable_partition(first, last, isLower);
        return range.begin + lower;
      }
    }
    return range.begin + (range.end - range.begin) / 2;
  }

  void buildNode(std::uint32_t begin, std::uint32_t end, std::uint32_t self, std::uint32_t depth, std::uint32_t trail) {
    const Range range = rangeOf(begin, end);
    inner_[self] = nodeOf(range);
    const std::uint32_t middle = split(range, depth);
    const std::uint32_t right = trail | 1u << depth;
    inner_[self].next = middle | (middle - begin == 1 ? gpu::kLightNodeLeftLeaf : 0) |
                        (end - middle == 1 ? gpu::kLightNodeRightLeaf : 0);
    if (middle - begin == 1) {
      setTrail(begin, trail);
    } else {
      buildNode(begin, middle, middle - 1, depth + 1, trail);
    }
    if (end - middle == 1) {
      setTrail(middle, right);
    } else {
      buildNode(middle, end, middle, depth + 1, right);
    }
  }

  void setTrail(std::uint32_t position, std::uint32_t trail) { trails_[position] = trail; }

  // Puts the leaves in the order of the tree, along the cycles of the permutation.
  void sortLeaves() {
    for (std::uint32_t start = 0; start < order_.size(); ++start) {
      const LightNode first = leaves_[start];
      std::uint32_t place = start;
      for (std::uint32_t from = order_[place]; from != start; from = order_[place]) {
        leaves_[place] = leaves_[from];
        order_[place] = place;
        place = from;
      }
      leaves_[place] = first;
      order_[place] = place;
    }
  }

  std::vector<LightNode> leaves_;  // in the order of the light table until they are sorted
  std::vector<dvec3> axes_;        // of the leaves
  std::vector<std::uint32_t> order_;
  std::vector<LightNode> inner_;
  std::vector<std::uint32_t> trails_;
};

// The leaf of an instance that emits, without its power.
LightNode instanceLeaf(const scene::Scene& scene, const scene::PrimitiveRun& run, const LightMesh& mesh,
                       bool oneSided) {
  std::vector<LightNode> leaves;
  std::vector<double> intensities;
  for (std::uint32_t i = 0; i < mesh.luminances.size(); ++i) {
    if (mesh.intensities[i] <= 0) continue;
    const scene::Triangle triangle = triangleOf(scene, run.at(run.first + i));
    const double intensity = triangleArea(triangle) * mesh.luminances[i];
    if (intensity <= 0) continue;
    intensities.push_back(intensity);
    setTriangle(triangle, oneSided, leaves.emplace_back());
  }
  setPowers(intensities, leaves);
  return Builder(std::move(leaves)).root();
}

LightNode leafOf(const scene::Scene& scene, const LightTable& table, const LightEntry& entry, bool oneSided) {
  LightNode leaf;
  if (!entry.isEmitter()) {
    setPunctual(scene.punctualLights[entry.index], leaf);
    return leaf;
  }
  if (entry.isInstance()) {
    return instanceLeaf(scene, scene.primitives.runOf(entry.index), table.meshes[entry.mesh], oneSided);
  }
  const scene::Primitive primitive = scene.primitives[entry.index];
  if (entry.kind == LightKind::sphere) {
    setSphere(scene.spheres[primitive.index], leaf);
  } else {
    setTriangle(triangleOf(scene, primitive), oneSided, leaf);
  }
  return leaf;
}

void buildTree(const scene::Scene& scene, bool oneSided, LightMesh& mesh) {
  std::vector<LightNode> leaves;
  std::vector<double> intensities;
  for (std::uint32_t i = 0; i < mesh.intensities.size(); ++i) {
    if (mesh.intensities[i] <= 0) continue;
    scene::Triangle triangle = triangleOf(scene, mesh, i);
    if (mesh.mirrors) std::swap(triangle.p[1], triangle.p[2]);
    intensities.push_back(mesh.intensities[i]);
    setTriangle(triangle, oneSided, leaves.emplace_back());
    leaves.back().next = i;
  }
  mesh.trails.assign(mesh.intensities.size(), gpu::kNoTrail);
  if (leaves.empty()) return;
  setPowers(intensities, leaves);
  std::vector<std::uint32_t> trails;
  mesh.tree = Builder(std::move(leaves)).build(trails);
  for (std::size_t i = 0; i < trails.size(); ++i) mesh.trails[mesh.tree.leaves[i].next] = trails[i];
}

}  // namespace

LightTree buildLightTree(const scene::Scene& scene, LightTable& table, bool oneSided) {
  for (LightMesh& mesh : table.meshes) buildTree(scene, oneSided, mesh);
  std::vector<LightNode> leaves;
  std::vector<double> intensities;
  const auto count = static_cast<std::size_t>(std::ranges::count_if(table.entries, &LightEntry::inTree));
  leaves.reserve(count);
  intensities.reserve(count);
  for (std::uint32_t i = 0; i < table.entries.size(); ++i) {
    if (!table.entries[i].inTree) continue;
    leaves.push_back(leafOf(scene, table, table.entries[i], oneSided));
    leaves.back().next = i;
    intensities.push_back(intensityOf(table.entries[i]));
  }
  setPowers(intensities, leaves);
  intensities = {};
  std::vector<std::uint32_t> trails;
  LightTree tree = Builder(std::move(leaves)).build(trails);
  for (std::size_t i = 0; i < trails.size(); ++i) table.entries[tree.leaves[i].next].trail = trails[i];
  return tree;
}

}  // namespace candela::flatten
