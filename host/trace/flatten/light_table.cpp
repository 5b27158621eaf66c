// Computes the table by which lights are sampled.
#include "host/trace/flatten/light_table.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <tuple>

#include "host/image/film.h"
#include "host/scene/emission_mean.h"
#include "host/trace/flatten/light_groups.h"
#include "shaders/shared/scene_rows.h"

namespace candela::flatten {
namespace {

constexpr double kThresholdScale = 16777216.0;  // 2^24: the resolution of the random numbers
constexpr std::size_t kTreeGroup = 0;           // lights of the tree, if there is one
constexpr std::size_t kUnhitGroup = 1;          // lights without extent, which no ray hits, and which no tree has
constexpr double kMinPart = 0.2;                // lowest weight of such a light, relative to their mean

// Returns nothing for primitives that light sampling does not choose. The material emits.
std::optional<LightKind> emitterKind(const scene::Scene& scene, const scene::Primitive& primitive) {
  if (primitive.kind == scene::PrimitiveKind::sphere && scene.spheres[primitive.index].radius != 0) {
    return LightKind::sphere;
  }
  if (primitive.kind == scene::PrimitiveKind::triangle && triangleArea(triangleOf(scene, primitive)) > 0) {
    return LightKind::triangle;
  }
  return std::nullopt;
}

LightKind kindOf(const scene::PunctualLight& light) {
  if (light.kind == scene::PunctualLight::Kind::spot) return LightKind::spot;
  return light.kind == scene::PunctualLight::Kind::directional ? LightKind::directional : LightKind::punctual;
}

bool mirrors(const scene::Placement& placement) { return glm::determinant(linearPartOf(placement)) < 0; }

double luminanceOf(const scene::Scene& scene, const scene::Primitive& triangle) {
  const glm::dvec3 emission(scene.materials[triangle.material].emission);
  return image::luminance(emission * meanEmissionTexel(scene, triangle));
}

// Collects the meshes of instances that emit.
class LightMeshes {
 public:
  explicit LightMeshes(const scene::Scene& scene) : scene_(scene) {}

  // Returns the index of the mesh of an instance.
  std::uint32_t of(const scene::PrimitiveRun& run) {
    const bool isMirrored = mirrors(scene_.placements[run.start.placement]);
    const std::uint32_t count = scene_.primitives.countOf(run);
    const Key key{run.start.mesh, run.start.index, count, run.start.material, isMirrored};
    const auto [entry, isNew] = indices_.try_emplace(key, static_cast<std::uint32_t>(meshes_.size()));
    if (isNew) meshes_.push_back(meshOf(run, count, isMirrored));
    return entry->second;
  }

  // Returns the weight of an instance of a mesh.
  double power(const scene::PrimitiveRun& run, std::uint32_t mesh) const {
    double sum = 0;
    const LightMesh& shared = meshes_[mesh];
    for (std::uint32_t i = 0; i < shared.luminances.size(); ++i) {
      if (shared.intensities[i] <= 0) continue;
      sum += triangleArea(triangleOf(scene_, run.at(run.first + i))) * shared.luminances[i];
    }
    return sum;
  }

  std::vector<LightMesh> release() { return std::move(meshes_); }

 private:
  using Key = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool>;

  LightMesh meshOf(const scene::PrimitiveRun& run, std::uint32_t count, bool isMirrored) const {
    LightMesh mesh{run.start, isMirrored, {}, {}, {}, {}};
    mesh.start.placement = scene::Primitive::kUnplaced;
    for (std::uint32_t i = 0; i < count; ++i) {
      mesh.luminances.push_back(luminanceOf(scene_, run.at(run.first + i)));
      mesh.intensities.push_back(triangleArea(triangleOf(scene_, mesh, i)) * mesh.luminances.back());
    }
    return mesh;
  }

  const scene::Scene& scene_;
  std::map<Key, std::uint32_t> indices_;
  std::vector<LightMesh> meshes_;
};

double punctualPower(const scene::PunctualLight& light) {
  const double reach = light.kind == scene::PunctualLight::Kind::directional ? double{light.reach} : 1.0;
  return reach * reach * image::luminance(glm::dvec3(light.intensity));
}

// The environment's weight is 1 if any texel can be chosen.
double environmentPower(const scene::Environment& environment) {
  return std::ranges::any_of(environment.weights, [](std::uint64_t weight) { return weight > 0; }) ? 1 : 0;
}

// Raises low weights of a group, so that none of its lights is lost beside a much brighter one. Returns the sum.
double raiseWeights(const std::vector<std::size_t>& groups, std::size_t group, std::vector<double>& weights,
                    double sum) {
  std::vector<double*> raisable;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (groups[i] == group && weights[i] > 0) raisable.push_back(&weights[i]);
  }
  const double minimum = kMinPart * sum / static_cast<double>(raisable.size());
  double raised = 0;
  for (double* weight : raisable) {
    *weight = std::max(*weight, minimum);
    raised += *weight;
  }
  return raised;
}

// Begins with the probability of a tree, and is 2^24 from the last entry of positive probability on.
void setThresholds(LightTable& table, double ofTree, const std::vector<double>& probabilities) {
  std::size_t lastPositive = 0;
  bool hasOthers = false;
  for (std::size_t i = 0; i < probabilities.size(); ++i) {
    if (probabilities[i] <= 0) continue;
    lastPositive = i;
    hasOthers = true;
  }
  const auto thresholdOf = [](double sum) { return std::floor(kThresholdScale * sum + 0.5); };
  double sum = ofTree;
  std::uint32_t previous = static_cast<std::uint32_t>(hasOthers ? thresholdOf(sum) : kThresholdScale * (sum > 0));
  table.treeThreshold = previous;
  for (std::size_t i = 0; i < table.entries.size(); ++i) {
    sum += probabilities[i];
    const double threshold = i >= lastPositive ? kThresholdScale : thresholdOf(sum);
    table.entries[i].threshold = static_cast<std::uint32_t>(threshold);
    table.entries[i].probability = static_cast<float>((threshold - previous) / kThresholdScale);
    previous = table.entries[i].threshold;
  }
}

}  // namespace

double triangleArea(const scene::Triangle& triangle) {
  const glm::dvec3 p0(triangle.p[0]);
  return 0.5 * glm::length(glm::cross(glm::dvec3(triangle.p[1]) - p0, glm::dvec3(triangle.p[2]) - p0));
}

scene::Triangle triangleOf(const scene::Scene& scene, const LightMesh& mesh, std::uint32_t triangle) {
  scene::Primitive primitive = mesh.start;
  primitive.index += triangle;
  return triangleOf(scene, primitive);
}

double lightPower(const scene::Scene& scene, LightKind kind, std::uint32_t index) {
  if (kind == LightKind::environment) return environmentPower(*scene.environment);
  if (kind == LightKind::point) return image::luminance(glm::dvec3(scene.pointLights[index].colour));
  if (kind > LightKind::point) return punctualPower(scene.punctualLights[index]);
  const scene::Primitive& primitive = scene.primitives[index];
  const glm::dvec3 emission(scene.materials[primitive.material].emission);
  if (kind == LightKind::triangle) {
    return triangleArea(triangleOf(scene, primitive)) * luminanceOf(scene, primitive);
  }
  const double emitted = image::luminance(emission);
  const double radius = scene.spheres[primitive.index].radius;
  return 4 * std::numbers::pi * radius * radius * emitted;
}

LightTable buildLightTable(const scene::Scene& scene, bool withEmitters, render::LightSelection selection) {
  LightTable table;
  std::vector<double> weights;
  std::vector<std::size_t> groups;
  GroupValues sums{};
  LightMeshes meshes(scene);
  const auto addEntry = [&](const LightEntry& entry) {
    table.entries.push_back(entry);
    weights.push_back(table.entries.back().power);
    groups.push_back(groupOf(entry.kind, selection));
    sums[groups.back()] += weights.back();
  };
  const auto add = [&](LightKind kind, std::uint32_t index) {
    addEntry({.kind = kind, .index = index, .power = lightPower(scene, kind, index)});
  };
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    if (!withEmitters || !isEmissive(scene.materials[run.start.material])) continue;
    if (selection == render::LightSelection::tree && isEmissiveInstance(scene, run)) {
      const std::uint32_t mesh = meshes.of(run);
      addEntry({.kind = LightKind::triangle, .index = run.first, .power = meshes.power(run, mesh), .mesh = mesh});
      continue;
    }
    const std::uint32_t end = run.first + scene.primitives.countOf(run);
    for (std::uint32_t i = run.first; i < end; ++i) {
      if (const std::optional<LightKind> kind = emitterKind(scene, run.at(i))) add(*kind, i);
    }
  }
  for (std::uint32_t i = 0; i < scene.pointLights.size(); ++i) add(LightKind::point, i);
  for (std::uint32_t i = 0; i < scene.punctualLights.size(); ++i) add(kindOf(scene.punctualLights[i]), i);
  if (withEmitters && scene.environment) add(LightKind::environment, 0);
  if (sums == GroupValues{}) return {};
  table.meshes = meshes.release();
  const GroupValues probabilities = groupProbabilities(scene, table.entries, selection, sums);
  sums[kUnhitGroup] = raiseWeights(groups, kUnhitGroup, weights, sums[kUnhitGroup]);
  for (std::size_t i = 0; i < weights.size(); ++i) {
    LightEntry& entry = table.entries[i];
    if (selection == render::LightSelection::tree && groups[i] == kTreeGroup) entry.trail = gpu::kNoTrail;
    entry.inTree = entry.trail && weights[i] > 0;
    const double part = sums[groups[i]] > 0 ? weights[i] / sums[groups[i]] * probabilities[groups[i]] : 0;
    weights[i] = entry.inTree ? 0 : part;
  }
  setThresholds(table, selection == render::LightSelection::tree ? probabilities[kTreeGroup] : 0, weights);
  return table;
}

UnsampledLights unsampledLights(const LightTable& table) {
  UnsampledLights result;
  for (const LightEntry& entry : table.entries) {
    if (entry.inTree || entry.power <= 0 || entry.probability > 0) continue;
    ++(entry.isEmitter() ? result.emitters : result.others);
  }
  return result;
}

}  // namespace candela::flatten
