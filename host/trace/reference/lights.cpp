// Computes the entries and thresholds of the light table.
#include "host/trace/reference/lights.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/scene/coincidence/coincidence.h"
#include "host/trace/reference/light_flux.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/textured_material.h"

namespace candela::reference {
namespace {

constexpr std::uint32_t kChoiceCount = 1u << 24;
constexpr double kMinGroupProbability = 0.2;
constexpr double kMinPointWeight = 0.2;  // of the mean weight

// Emitters, or lights of the tree; lights that no ray finds; and the environment.
enum Group { kEmitters, kPoints, kEnvironment, kGroupCount };

Group groupOf(const Light& light, render::LightSelection selection) {
  if (std::holds_alternative<EnvironmentLight>(light)) return kEnvironment;
  if (std::holds_alternative<PointLight>(light)) return kPoints;
  const auto* const punctual = std::get_if<PunctualLight>(&light);
  if (!punctual) return kEmitters;
  return selection == render::LightSelection::tree && punctual->hasPlace() ? kEmitters : kPoints;
}

}  // namespace

LightTable::LightTable(const scene::Scene& scene, const render::RenderSettings& settings)
    : scene_(&scene), selection_(settings.image.lights), oneSided_(settings.image.oneSided) {
  for (const scene::PrimitiveRun& run : scene.primitives.runs()) {
    if (settings.image.nextEventEstimation && isEmissive(scene.materials[run.start.material])) addEmitters(run);
  }
  for (const scene::PointLight& light : scene.pointLights) add(PointLight(light));
  for (const scene::PunctualLight& light : scene.punctualLights) add(PunctualLight(light));
  if (settings.image.nextEventEstimation && scene.environment) {
    const auto& weights = scene.environment->weights;
    const bool shines = std::ranges::any_of(weights, [](std::uint64_t weight) { return weight > 0; });
    entryOfEnvironment_ = add(EnvironmentLight(shines));
  }
  const std::vector<double> groups = groupProbabilities();
  raisePointWeights();
  if (selection_ == render::LightSelection::tree) buildTree();
  computeThresholds(groups);
}

void LightTable::buildTree() {
  for (std::uint32_t i = 0; i < entries_.size(); ++i) {
    if (groupOf(entries_[i].light, selection_) == kEmitters && entries_[i].weight > 0) entriesOfTree_.push_back(i);
  }
  std::vector<LightBounds> bounds;
  std::vector<double> powers;
  bounds.reserve(entriesOfTree_.size());
  powers.reserve(entriesOfTree_.size());
  for (const std::uint32_t i : entriesOfTree_) {
    const Entry& entry = entries_[i];
    powers.push_back(std::visit([](const auto& light) { return light.intensity(); }, entry.light));
    bounds.push_back(std::visit([&](const auto& light) { return light.bounds(oneSided_); }, entry.light));
  }
  if (!bounds.empty()) tree_.emplace(std::move(bounds), std::move(powers));
}

std::optional<std::uint32_t> LightTable::indexInTree(std::uint32_t entry) const {
  const auto found = std::ranges::lower_bound(entriesOfTree_, entry);
  if (found == entriesOfTree_.end() || *found != entry) return std::nullopt;
  return static_cast<std::uint32_t>(found - entriesOfTree_.begin());
}

void LightTable::addEmitters(const scene::PrimitiveRun& run) {
  if (selection_ == render::LightSelection::tree && isEmissiveInstance(*scene_, run)) return addInstance(run);
  for (std::uint32_t i = 0; i < scene_->primitives.countOf(run); ++i) addEmitter(run.first + i, run.at(run.first + i));
}

void LightTable::addInstance(const scene::PrimitiveRun& run) {
  const auto next = static_cast<std::uint32_t>(meshes_.size());
  const auto [mesh, isNew] = meshOfKey_.try_emplace(LightMesh::keyOf(*scene_, run), next);
  if (isNew) meshes_.emplace_back(*scene_, run, oneSided_);
  const auto index = static_cast<std::uint32_t>(instances_.size());
  instances_.emplace_back(*scene_, run, meshes_[mesh->second], mesh->second, oneSided_);
  entryOfInstance_[run.first] = add(InstanceLight(instances_.back(), index));
}

TriangleLight LightTable::triangleOfInstance(std::uint32_t primitive) const {
  const scene::Primitive triangle = scene_->primitives[primitive];
  const dvec3 emission = scene_->materials[triangle.material].emission;
  return {triangleOf(*scene_, triangle), emission, primitive, oneSided_};
}

std::uint32_t LightTable::entryOf(std::uint32_t primitive) const {
  const auto own = entryOfPrimitive_.find(primitive);
  if (own != entryOfPrimitive_.end()) return own->second;
  const auto after = entryOfInstance_.upper_bound(primitive);
  if (after == entryOfInstance_.begin()) return kNoEntry;
  const auto& [first, entry] = *std::prev(after);
  const std::uint32_t count = scene_->primitives.countOf(scene_->primitives.runOf(first));
  return primitive - first < count ? entry : kNoEntry;
}

const LightInstance* LightTable::instanceOf(std::uint32_t entry) const {
  const auto* const light = std::get_if<InstanceLight>(&entries_[entry].light);
  return light != nullptr ? &instances_[light->instance()] : nullptr;
}

void LightTable::addEmitter(std::uint32_t primitive, const scene::Primitive& emitter) {
  const dvec3 emission = scene_->materials[emitter.material].emission;
  if (emitter.kind == scene::PrimitiveKind::sphere) {
    entryOfPrimitive_[primitive] = add(SphereLight(scene_->spheres[emitter.index], emission, primitive), primitive);
  } else if (emitter.kind == scene::PrimitiveKind::triangle) {
    const TriangleLight light(triangleOf(*scene_, emitter), emission, primitive, oneSided_,
                              meanEmissionTexel(*scene_, emitter));
    if (light.area() > 0) entryOfPrimitive_[primitive] = add(light, primitive);
  }
}

std::uint32_t LightTable::add(const Light& light, std::uint32_t primitive) {
  entries_.push_back({light, std::visit([](const auto& of) { return of.power(); }, light), primitive});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

std::vector<double> LightTable::groupWeights() const {
  std::vector<double> sums(kGroupCount, 0.0);
  for (const Entry& entry : entries_) sums[groupOf(entry.light, selection_)] += entry.weight;
  return sums;
}

std::vector<double> LightTable::groupProbabilities() const {
  std::vector<double> probabilities = groupWeights();
  const auto count = static_cast<double>(std::ranges::count_if(probabilities, [](double sum) { return sum > 0; }));
  if (count <= 1) return {1, 1, 1};
  const double squared = squaredRadius(*scene_);
  const auto flux = [&](const Entry& entry) {  // divided by pi
    if (std::holds_alternative<PointLight>(entry.light)) return entry.weight * kPi * squared;
    const bool isEnvironment = std::holds_alternative<EnvironmentLight>(entry.light) && entry.weight > 0;
    return isEnvironment ? 4 * squared * meanLuminance(*scene_->environment) : entry.weight;
  };
  std::array<double, kGroupCount> fluxes{};
  for (const Entry& entry : entries_) fluxes[groupOf(entry.light, selection_)] += flux(entry);
  const double sum = fluxes[kEmitters] + fluxes[kPoints] + fluxes[kEnvironment];
  for (std::size_t group = 0; group < fluxes.size(); ++group) {
    const double fraction = sum > 0 ? fluxes[group] / sum : 1 / count;
    probabilities[group] = std::lerp(fraction, 1 / count, count * kMinGroupProbability);
  }
  return probabilities;
}

void LightTable::raisePointWeights() {
  const auto isChoosable = [&](const Entry& entry) {
    return groupOf(entry.light, selection_) == kPoints && entry.weight > 0;
  };
  const auto count = static_cast<double>(std::ranges::count_if(entries_, isChoosable));
  const double minimum = kMinPointWeight * groupWeights()[kPoints] / count;
  for (Entry& entry : entries_) {
    if (isChoosable(entry)) entry.weight = std::max(entry.weight, minimum);
  }
}

void LightTable::computeThresholds(const std::vector<double>& groups) {
  const std::vector<double> sums = groupWeights();
  double running = tree_ ? groups[kEmitters] : 0;
  const auto thresholdOf = [](double sum) { return static_cast<std::uint32_t>(std::floor(sum * kChoiceCount + 0.5)); };
  treeThreshold_ = thresholdOf(running);
  std::optional<std::size_t> last;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    const int group = groupOf(entries_[i].light, selection_);
    const double groupSum = sums[group];
    if (entries_[i].weight > 0 && !(tree_ && group == kEmitters)) {
      running += groups[group] * entries_[i].weight / groupSum;
      last = i;
    }
    thresholds_.push_back(thresholdOf(running));
  }
  if (running == 0) return;
  if (!last) treeThreshold_ = kChoiceCount;
  std::fill(thresholds_.begin() + static_cast<std::ptrdiff_t>(last.value_or(0)), thresholds_.end(), kChoiceCount);
}

double LightTable::probability(std::uint32_t entry) const {
  const std::uint32_t below = entry == 0 ? treeThreshold_ : thresholds_[entry - 1];
  return static_cast<double>(thresholds_[entry] - below) / kChoiceCount;
}

double LightTable::probability(std::uint32_t entry, const LightReceiver& receiver, Arithmetic& arithmetic) const {
  const std::optional<std::uint32_t> index = indexInTree(entry);
  if (!index) return probability(entry);
  return treeProbability() * tree_->probability(*index, PlacedReceiver(receiver), arithmetic);
}

double LightTable::probabilityOf(std::uint32_t primitive, const LightReceiver& receiver, Arithmetic& arithmetic) const {
  const std::uint32_t entry = entryOf(primitive);
  if (entry == kNoEntry) return 0;
  const LightInstance* const instance = instanceOf(entry);
  if (instance == nullptr) return probability(entry, receiver, arithmetic);
  const LightMesh& mesh = meshes_[instance->mesh()];
  const std::optional<std::uint32_t> index = mesh.indexInTree(primitive - instance->firstPrimitive());
  if (!index || !indexInTree(entry)) return 0;
  return probability(entry, receiver, arithmetic) *
         mesh.tree()->probability(*index, instance->receiverInMesh(receiver), arithmetic);
}

LightChoice LightTable::choose(const LightReceiver& receiver, const VertexNumbers& u, Arithmetic& arithmetic) const {
  const std::uint32_t word = u.lightChoice();
  if (word >> 8 >= treeThreshold_) return choose(word);
  const LightTree::Choice choice = tree_->choose(PlacedReceiver(receiver), u, arithmetic);
  const std::uint32_t entry = entriesOfTree_[choice.light];
  const double probability = treeProbability() * choice.probability;
  const LightInstance* const instance = instanceOf(entry);
  if (instance == nullptr) return {entry, probability, entries_[entry].primitive};
  const LightMesh& mesh = meshes_[instance->mesh()];
  const LightTree::Choice part = mesh.tree()->choose(instance->receiverInMesh(receiver), u, arithmetic);
  return {entry, probability * part.probability, instance->firstPrimitive() + mesh.parts()[part.light].triangle};
}

LightChoice LightTable::choose(std::uint32_t word) const {
  const auto found = std::upper_bound(thresholds_.begin(), thresholds_.end(), word >> 8);
  const auto entry = static_cast<std::uint32_t>(found - thresholds_.begin());
  return {entry, probability(entry), entries_[entry].primitive};
}

bool LightTable::isOnCopy(std::uint32_t primitive, const Surface& surface) const {
  if (primitive == kNoPrimitive || surface.primitive == kNoPrimitive || primitive == surface.primitive) return false;
  return areCopies(shapeOf(*scene_, scene_->primitives[primitive]),
                   shapeOf(*scene_, scene_->primitives[surface.primitive]));
}

std::optional<LightSample> LightTable::sample(const LightChoice& choice, const Surface& surface, const dvec2& u) const {
  if (isOnCopy(choice.primitive, surface)) return std::nullopt;
  if (instanceOf(choice.entry) != nullptr) return triangleOfInstance(choice.primitive).sample(surface, u);
  return std::visit([&](const auto& light) { return light.sample(surface, u); }, entries_[choice.entry].light);
}

double LightTable::pdf(const Ray& ray, double distance, const Surface& surface, const LightReceiver& receiver,
                       Arithmetic& arithmetic) const {
  const std::uint32_t entry = entryOf(surface.primitive);
  if (entry == kNoEntry) return 0;
  const double chosen = probabilityOf(surface.primitive, receiver, arithmetic);
  if (instanceOf(entry) != nullptr) return triangleOfInstance(surface.primitive).pdf(ray, distance, chosen);
  return std::visit([&](const auto& light) { return light.pdf(ray, distance, chosen); }, entries_[entry].light);
}

double LightTable::environmentProbability() const {
  return entryOfEnvironment_ == kNoEntry ? 0 : probability(entryOfEnvironment_);
}

}  // namespace candela::reference
