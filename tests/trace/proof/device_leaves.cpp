// The device's side: each function in a small separate shader, on the device under test.
#include <bit>
#include <catch2/catch.hpp>

#include "spirv/environment_leaf.h"
#include "spirv/light_leaf.h"
#include "spirv/light_tree_leaf.h"
#include "spirv/material_leaf.h"
#include "spirv/ray_leaf.h"
#include "spirv/warps_leaf.h"
#include "tests/trace/device/run_leaf.h"
#include "tests/trace/device/scene_leaf.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/render/render_support.h"

namespace candela::proof {

using glm::vec3;
using glm::vec4;

const double kRounding = 1e-5;

render::RenderResult renderScene(const scene::Scene& scene, const render::RenderSettings& settings) {
  return device::renderOnDevice(scene, settings);
}

WarpValues warps(std::span<const vec3> numbers, float capHeight) {
  std::vector<vec4> inputs;
  for (const vec3& u : numbers) inputs.emplace_back(u, capHeight);
  const auto rows = device::runLeaf<vec4>(spirv::warps_leaf, inputs, 3 * inputs.size(),
                                          {static_cast<std::uint32_t>(inputs.size()), 0});
  WarpValues values;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    values.disc.emplace_back(rows[3 * i].x, rows[3 * i].y);
    values.triangle.emplace_back(rows[3 * i].z, rows[3 * i].w);
    values.cap.emplace_back(vec3(rows[3 * i + 1]));
    values.tent.push_back(rows[3 * i + 1].w);
    values.cosineHemisphere.emplace_back(vec3(rows[3 * i + 2]));
    values.gaussian.push_back(rows[3 * i + 2].w);
  }
  return values;
}

// ---------------------------------------------------------------------------------------------------------------------

namespace {

// Each material is on a separate sphere, so that the scene uses it.
scene::Scene sceneOfMaterials(const std::vector<scene::Material>& materials) {
  scene::Scene scene;
  scene.camera.emplace();
  scene.materials = materials;
  for (std::uint32_t i = 0; i < materials.size(); ++i) {
    scene.spheres.push_back({vec3(0), 1});
    scene.primitives.push_back({scene::PrimitiveKind::sphere, i, i});
  }
  return scene;
}

// Numbers up to 2^24 travel as floats, since bits of small integers are denormal floats, which devices may drop.
float number(std::uint32_t value) { return static_cast<float>(value); }
std::uint32_t count(float value) { return static_cast<std::uint32_t>(value); }

}  // namespace

struct MaterialLeaves::Side {
  device::SceneLeaf leaf;
};

MaterialLeaves::MaterialLeaves(const std::vector<scene::Material>& materials)
    : side_(new Side{device::SceneLeaf(spirv::material_leaf, sceneOfMaterials(materials))}) {}
MaterialLeaves::~MaterialLeaves() = default;

std::vector<Scattered> MaterialLeaves::sample(std::span<const ScatterQuery> queries) const {
  std::vector<vec4> inputs;
  for (const ScatterQuery& query : queries) {
    inputs.emplace_back(vec3(query.wo), number(query.material));
    inputs.emplace_back(query.numbers, query.outside ? 1.0f : 0.0f);
    inputs.emplace_back(query.dispersion.throughput, query.dispersion.number);
    inputs.emplace_back(vec3(query.geometric), 0);
  }
  const auto rows = side_->leaf.run<vec4>(inputs, 2 * queries.size(), queries.size(), 0);
  std::vector<Scattered> samples(queries.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto lobe = static_cast<render::Lobe>(rows[2 * i + 1].w);
    if (lobe != render::Lobe::none) samples[i] = {lobe, vec3(rows[2 * i]), vec3(rows[2 * i + 1]), rows[2 * i].w};
  }
  return samples;
}

std::vector<ScatterValue> MaterialLeaves::evaluate(std::span<const DirectionPair> pairs) const {
  std::vector<vec4> inputs;
  for (const DirectionPair& pair : pairs) {
    inputs.emplace_back(vec3(pair.wo), number(pair.material));
    inputs.emplace_back(vec3(pair.wi), pair.outside ? 1.0f : 0.0f);
    inputs.emplace_back(pair.dispersion.throughput, pair.dispersion.number);
    inputs.emplace_back(vec3(pair.geometric), 0);
  }
  const auto rows = side_->leaf.run<vec4>(inputs, 2 * pairs.size(), pairs.size(), 1);
  std::vector<ScatterValue> values;
  for (std::size_t i = 0; i < pairs.size(); ++i) values.push_back({vec3(rows[2 * i]), rows[2 * i].w});
  return values;
}

// ---------------------------------------------------------------------------------------------------------------------

struct LightLeaves::Side {
  device::SceneLeaf leaf;

  // The tasks of light_leaf.comp.
  static constexpr std::uint32_t kChoose = 0, kSample = 1, kFind = 2;

  template <class Query>
  std::vector<vec4> run(std::uint32_t task, const Viewpoint& from, std::size_t count, const Query& query) {
    std::vector<vec4> inputs;
    for (std::size_t i = 0; i < count; ++i) {
      inputs.emplace_back(vec3(from.position), from.onLight ? 1.0f : 0.0f);
      inputs.push_back(query(i));
    }
    return leaf.run<vec4>(inputs, inputs.size(), count, task);
  }
};

LightLeaves::LightLeaves(const scene::Scene& scene) : side_(new Side{device::SceneLeaf(spirv::light_leaf, scene)}) {}
LightLeaves::~LightLeaves() = default;

std::vector<ChosenLight> LightLeaves::choose(std::span<const std::uint32_t> words) const {
  const auto query = [&](std::size_t i) { return vec4(number(words[i] >> 8)); };
  const auto rows = side_->run(Side::kChoose, {}, words.size(), query);
  std::vector<ChosenLight> chosen;
  std::uint32_t truncated = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    chosen.push_back({count(rows[2 * i].x), rows[2 * i].y});
    truncated += count(rows[2 * i].z);
  }
  REQUIRE(truncated == 0);
  return chosen;
}

struct LightTreeLeaves::Side {
  device::SceneLeaf leaf;

  // The tasks of light_tree_leaf.comp.
  static constexpr std::uint32_t kChoose = 0, kFind = 1;

  static render::RenderSettings settings(bool oneSided) {
    render::RenderSettings settings = render::defaultSettings();
    settings.image.lights = render::LightSelection::tree;
    settings.image.oneSided = oneSided;
    settings.image.sampler = render::SamplerKind::independent;
    return settings;
  }

  template <class Number>
  std::vector<vec4> run(std::uint32_t task, const ReceiverQuery& receiver, std::size_t count, const Number& numberOf) {
    std::vector<vec4> inputs;
    for (std::size_t i = 0; i < count; ++i) {
      inputs.emplace_back(vec3(receiver.position), receiver.transmits ? 1.0f : 0.0f);
      inputs.emplace_back(vec3(receiver.normal), number(numberOf(i)));
    }
    return leaf.run<vec4>(inputs, count, count, task);
  }
};

LightTreeLeaves::LightTreeLeaves(const scene::Scene& scene, bool oneSided)
    : side_(new Side{device::SceneLeaf(spirv::light_tree_leaf, scene, Side::settings(oneSided))}) {}
LightTreeLeaves::~LightTreeLeaves() = default;

std::vector<ChosenLight> LightTreeLeaves::choose(const ReceiverQuery& receiver, std::uint32_t samples) const {
  std::vector<ChosenLight> chosen;
  std::uint32_t truncated = 0;
  const auto sample = [](std::size_t i) { return static_cast<std::uint32_t>(i); };
  for (const vec4& row : side_->run(Side::kChoose, receiver, samples, sample)) {
    chosen.push_back({count(row.x), row.y, count(row.w)});
    truncated += count(row.z);
  }
  REQUIRE(truncated == 0);
  return chosen;
}

std::vector<double> LightTreeLeaves::probabilities(const ReceiverQuery& receiver,
                                                   std::span<const std::uint32_t> primitives) const {
  std::vector<double> probabilities;
  const auto primitive = [&](std::size_t i) { return primitives[i]; };
  for (const vec4& row : side_->run(Side::kFind, receiver, primitives.size(), primitive)) {
    probabilities.push_back(row.y);
  }
  return probabilities;
}

std::vector<LitPoint> LightLeaves::sample(std::uint32_t entry, const Viewpoint& from,
                                          std::span<const vec3> numbers) const {
  const auto query = [&](std::size_t i) { return vec4(numbers[i], number(entry)); };
  const auto rows = side_->run(Side::kSample, from, numbers.size(), query);
  std::vector<LitPoint> points;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    points.push_back({vec3(rows[2 * i]), rows[2 * i + 1].w, rows[2 * i].w, vec3(rows[2 * i + 1])});
  }
  return points;
}

std::vector<FoundLight> LightLeaves::find(std::uint32_t entry, const Viewpoint& from,
                                          std::span<const dvec3> directions) const {
  const auto query = [&](std::size_t i) { return vec4(vec3(directions[i]), number(entry)); };
  const auto rows = side_->run(Side::kFind, from, directions.size(), query);
  std::vector<FoundLight> found;
  for (std::size_t i = 0; i < directions.size(); ++i) found.push_back({rows[2 * i].x, rows[2 * i].y});
  return found;
}

// ---------------------------------------------------------------------------------------------------------------------

struct EnvironmentLeaves::Side {
  device::SceneLeaf leaf;

  // The tasks of environment_leaf.comp.
  static constexpr std::uint32_t kSample = 0, kTap = 1;
};

EnvironmentLeaves::EnvironmentLeaves(const scene::Scene& scene)
    : side_(new Side{device::SceneLeaf(spirv::environment_leaf, scene)}) {}
EnvironmentLeaves::~EnvironmentLeaves() = default;

std::vector<LitPoint> EnvironmentLeaves::sample(std::span<const EnvironmentQuery> queries) const {
  std::vector<glm::uvec4> inputs;
  for (const EnvironmentQuery& query : queries) {
    inputs.emplace_back(query.wordU, query.wordV, std::bit_cast<std::uint32_t>(query.place.x),
                        std::bit_cast<std::uint32_t>(query.place.y));
    inputs.emplace_back(0);
  }
  const auto rows = side_->leaf.run<vec4>(inputs, inputs.size(), queries.size(), Side::kSample);
  std::vector<LitPoint> points;
  for (std::size_t i = 0; i < queries.size(); ++i) {
    points.push_back({vec3(rows[2 * i]), 0, rows[2 * i].w, vec3(rows[2 * i + 1])});
  }
  return points;
}

std::vector<EnvironmentTap> EnvironmentLeaves::tap(std::span<const dvec3> directions,
                                                   std::span<const vec3> jitter) const {
  std::vector<vec4> inputs;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    inputs.emplace_back(vec3(directions[i]), 0.0f);
    inputs.emplace_back(jitter[i], 0.0f);
  }
  const auto rows = side_->leaf.run<vec4>(inputs, inputs.size(), directions.size(), Side::kTap);
  std::vector<EnvironmentTap> taps;
  for (std::size_t i = 0; i < directions.size(); ++i) taps.push_back({vec3(rows[2 * i]), rows[2 * i].w});
  return taps;
}

// ---------------------------------------------------------------------------------------------------------------------

struct RayLeaves::Side {
  device::SceneLeaf leaf;
};

RayLeaves::RayLeaves(const scene::Scene& scene) : side_(new Side{device::SceneLeaf(spirv::ray_leaf, scene)}) {}
RayLeaves::~RayLeaves() = default;

std::vector<TracedHit> RayLeaves::closest(std::span<const ProofRay> rays) const {
  std::vector<vec4> inputs;
  for (const ProofRay& ray : rays) {
    inputs.emplace_back(ray.origin, 0.0f);
    inputs.emplace_back(ray.direction, 0.0f);
  }
  const auto rows = side_->leaf.run<glm::uvec4>(inputs, rays.size(), rays.size());
  std::vector<TracedHit> hits;
  std::uint32_t truncated = 0;
  for (const glm::uvec4& row : rows) {
    hits.push_back({std::bit_cast<float>(row.x), row.y});
    truncated += row.z;
  }
  REQUIRE(truncated == 0);
  return hits;
}

}  // namespace candela::proof
