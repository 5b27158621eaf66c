// The reference's side.
#include <optional>
#include <tuple>

#include "host/trace/reference/bsdf.h"
#include "host/trace/reference/environment_map.h"
#include "host/trace/reference/facet_scattering.h"
#include "host/trace/reference/lights.h"
#include "host/trace/reference/reference_renderer.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/surface.h"
#include "host/trace/reference/surface_material.h"
#include "host/trace/reference/tracing.h"
#include "tests/trace/proof/leaves.h"
#include "tests/trace/reference/default_settings.h"

namespace candela::proof {

const double kRounding = 1e-12;

render::RenderResult renderScene(const scene::Scene& scene, const render::RenderSettings& settings) {
  return reference::makeReferenceRenderer()->render(scene, settings, {});
}

WarpValues warps(std::span<const glm::vec3> numbers, float capHeight) {
  WarpValues values;
  for (const glm::vec3& number : numbers) {
    const dvec2 u(number);
    values.disc.push_back(reference::sampleDisc(u));
    values.triangle.push_back(reference::sampleTriangle(u));
    values.cap.push_back(reference::sampleCap(u, capHeight));
    values.cosineHemisphere.push_back(reference::sampleCosineHemisphere(u));
    values.tent.push_back(reference::sampleTent(u.x));
    values.gaussian.push_back(reference::sampleGaussian(u.x));
  }
  return values;
}

// ---------------------------------------------------------------------------------------------------------------------

struct MaterialLeaves::Side {
  std::vector<reference::SurfaceMaterial> materials;

  // The BSDF of the last requested vertex, since many consecutive queries have the same.
  class Vertex {
   public:
    explicit Vertex(const Side& side) : side_(side) {}

    template <class Query>
    const reference::Bsdf& bsdf(const Query& query) {
      const auto key = std::tie(query.material, query.wo, query.outside, query.dispersion);
      if (bsdf_ && key == std::tie(material_, wo_, outside_, dispersion_)) return *bsdf_;
      std::tie(material_, wo_, outside_, dispersion_) = key;
      const reference::SurfaceMaterial& description = side_.materials[material_];
      bsdf_ = description.bsdf;
      if (!description.surface) return *bsdf_;
      std::optional<reference::ChannelChoice> choice;
      if (description.surface->disperses())
        choice = reference::chooseChannel(dispersion_.throughput, dispersion_.number);
      bsdf_->setSurface(*description.surface, wo_, outside_, false, choice);
      return *bsdf_;
    }

   private:
    const Side& side_;
    std::optional<reference::Bsdf> bsdf_;
    std::uint32_t material_ = 0;
    dvec3 wo_{0};
    bool outside_ = true;
    ChannelQuery dispersion_;
  };

  // A path that continues from a vertex whose geometric and shading normals are equal.
  static Scattered sample(const reference::Bsdf& bsdf, const ScatterQuery& query) {
    if (bsdf.isBlack()) return {};
    if (bsdf.interface() != nullptr && bsdf.interface()->isSmooth()) return ofSmoothInterface(bsdf, query);
    if (bsdf.surface() != nullptr || bsdf.interface() != nullptr) return ofSurface(bsdf, query);
    const render::Lobe lobe = bsdf.isMirror() ? render::Lobe::mirror : bsdf.chooseLobe(query.numbers.x);
    if (lobe == render::Lobe::mirror) return ofDelta(bsdf.sampleMirror(query.wo));
    if (lobe == render::Lobe::refract) return ofDelta(bsdf.sampleDielectric(query.wo, query.outside, query.numbers.y));
    const dvec3 wi = bsdf.sampleSmooth(lobe, query.wo, {query.numbers.y, query.numbers.z});
    const reference::BsdfValue value = bsdf.evaluate(query.wo, wi);
    if (value.pdf == 0) return {};
    return {lobe, wi, value.f * wi.z / value.pdf, value.pdf};
  }

  static std::optional<reference::NormalMapFacets> facetsOf(const dvec3& geometric) {
    if (geometric == dvec3(0)) return std::nullopt;
    return reference::NormalMapFacets(geometric);
  }

  static Scattered ofSmoothInterface(const reference::Bsdf& bsdf, const ScatterQuery& query) {
    const reference::DeltaSample sample = bsdf.interface()->sampleSmooth(query.numbers.x);
    const dvec3 wi = leavingDirection(facetsOf(query.geometric), {sample.lobe, sample.wi, 0});
    return {sample.lobe, wi, sample.weight, 0};
  }

  static Scattered ofSurface(const reference::Bsdf& bsdf, const ScatterQuery& query) {
    const dvec2 u(query.numbers.y, query.numbers.z);
    const reference::SurfaceSample sample = bsdf.interface() != nullptr ? bsdf.interface()->sample(query.numbers.x, u)
                                                                        : bsdf.surface()->sample(query.numbers.x, u);
    if (!sample.isOnItsSide()) return {};
    const auto facets = facetsOf(query.geometric);
    const dvec3 wi = leavingDirection(facets, sample);
    const reference::BsdfValue value = scatteredValue(bsdf, facets, query.wo, wi, reference::sideOf(sample.wi));
    if (value.pdf == 0) return {};
    return {sample.lobe, wi, value.f / value.pdf, value.pdf};
  }

  static ScatterValue evaluate(const reference::Bsdf& bsdf, const DirectionPair& pair) {
    if (pair.geometric == dvec3(0)) {
      const reference::BsdfValue value = bsdf.evaluate(pair.wo, pair.wi);
      return {value.f, value.pdf};
    }
    const double cosine = dot(pair.wi, pair.geometric);
    const reference::Side side = cosine < 0 ? reference::Side::transmission : reference::Side::reflection;
    const reference::BsdfValue value = scatteredValue(bsdf, facetsOf(pair.geometric), pair.wo, pair.wi, side);
    return {value.f / std::abs(cosine), value.pdf};
  }

  static Scattered ofDelta(const reference::DeltaSample& sample) { return {sample.lobe, sample.wi, sample.weight, 0}; }
};

MaterialLeaves::MaterialLeaves(const std::vector<scene::Material>& materials) : side_(std::make_unique<Side>()) {
  for (const scene::Material& material : materials) side_->materials.emplace_back(material);
}

MaterialLeaves::~MaterialLeaves() = default;

std::vector<Scattered> MaterialLeaves::sample(std::span<const ScatterQuery> queries) const {
  std::vector<Scattered> samples;
  Side::Vertex vertex(*side_);
  for (const ScatterQuery& query : queries) {
    samples.push_back(Side::sample(vertex.bsdf(query), query));
  }
  return samples;
}

std::vector<ScatterValue> MaterialLeaves::evaluate(std::span<const DirectionPair> pairs) const {
  std::vector<ScatterValue> values;
  Side::Vertex vertex(*side_);
  for (const DirectionPair& pair : pairs) values.push_back(Side::evaluate(vertex.bsdf(pair), pair));
  return values;
}

// ---------------------------------------------------------------------------------------------------------------------

struct LightLeaves::Side {
  scene::Scene scene;
  reference::LightTable table;

  explicit Side(const scene::Scene& lights) : scene(lights), table(scene, render::defaultSettings()) {}

  double probability(std::uint32_t entry) const {
    const std::uint32_t below = entry == 0 ? 0 : table.thresholds()[entry - 1];
    return (table.thresholds()[entry] - below) * 0x1p-24;
  }

  LitPoint sample(std::uint32_t entry, const Viewpoint& from, const dvec2& u) const {
    const std::uint32_t primitive = from.onLight ? entry : reference::kNoPrimitive;
    const dvec3 up(0, 0, 1);  // lights are sampled without regard to the surface's normal
    const auto lit = table.sample(table.choiceOf(entry), {from.position, up, up, up, true, primitive, 0}, u);
    if (!lit) return {};
    return {lit->wi, lit->distance, probability(entry) * lit->pdf.value_or(1), lit->radiance};
  }

  FoundLight find(std::uint32_t entry, const Viewpoint& from, const dvec3& direction) const {
    const std::uint32_t originPrimitive = from.onLight ? entry : reference::kNoPrimitive;
    const reference::Ray ray{from.position, direction, originPrimitive};
    const double distance = distanceTo(scene.primitives[entry], ray, from.onLight);
    if (distance == reference::kNoHit) return {};
    const reference::Surface surface = reference::surfaceAt(scene, ray, {distance, entry});
    reference::Arithmetic exact;
    return {distance, table.pdf(ray, distance, surface, {}, exact)};
  }

  double distanceTo(const scene::Primitive& primitive, const reference::Ray& ray, bool startsHere) const {
    if (primitive.kind == scene::PrimitiveKind::sphere) {
      return reference::SphereShape(scene.spheres[primitive.index]).distance(ray, startsHere);
    }
    return startsHere ? reference::kNoHit : reference::TriangleShape(triangleOf(scene, primitive)).distance(ray);
  }
};

LightLeaves::LightLeaves(const scene::Scene& scene) : side_(std::make_unique<Side>(scene)) {}
LightLeaves::~LightLeaves() = default;

std::vector<ChosenLight> LightLeaves::choose(std::span<const std::uint32_t> words) const {
  std::vector<ChosenLight> chosen;
  for (const std::uint32_t word : words) {
    const reference::LightChoice choice = side_->table.choose(word);
    chosen.push_back({choice.entry, choice.probability});
  }
  return chosen;
}

std::vector<LitPoint> LightLeaves::sample(std::uint32_t entry, const Viewpoint& from,
                                          std::span<const glm::vec3> numbers) const {
  std::vector<LitPoint> points;
  for (const glm::vec3& u : numbers) points.push_back(side_->sample(entry, from, dvec2(u)));
  return points;
}

struct LightTreeLeaves::Side {
  static render::RenderSettings settings(bool oneSided) {
    render::RenderSettings settings = render::defaultSettings();
    settings.image.lights = render::LightSelection::tree;
    settings.image.oneSided = oneSided;
    return settings;
  }
  static reference::LightReceiver receiverOf(const ReceiverQuery& query) {
    return {query.position, reference::StoredDirection(query.normal), query.transmits};
  }

  scene::Scene scene;
  reference::LightTable table;
  reference::Arithmetic exact{};
  reference::Sampler sampler{render::SamplerKind::independent, 0, 1};

  Side(const scene::Scene& lights, bool oneSided) : scene(lights), table(scene, settings(oneSided)) {}
};

LightTreeLeaves::LightTreeLeaves(const scene::Scene& scene, bool oneSided)
    : side_(std::make_unique<Side>(scene, oneSided)) {}
LightTreeLeaves::~LightTreeLeaves() = default;

std::vector<ChosenLight> LightTreeLeaves::choose(const ReceiverQuery& receiver, std::uint32_t count) const {
  std::vector<ChosenLight> chosen;
  for (std::uint32_t sample = 0; sample < count; ++sample) {
    reference::SampleNumbers numbers(side_->sampler, 0, 0, sample);
    const auto choice = side_->table.choose(Side::receiverOf(receiver), {numbers, 1}, side_->exact);
    chosen.push_back({choice.entry, choice.probability, choice.primitive});
  }
  return chosen;
}

std::vector<double> LightTreeLeaves::probabilities(const ReceiverQuery& receiver,
                                                   std::span<const std::uint32_t> primitives) const {
  std::vector<double> probabilities;
  for (const std::uint32_t primitive : primitives) {
    probabilities.push_back(side_->table.probabilityOf(primitive, Side::receiverOf(receiver), side_->exact));
  }
  return probabilities;
}

std::vector<FoundLight> LightLeaves::find(std::uint32_t entry, const Viewpoint& from,
                                          std::span<const dvec3> directions) const {
  std::vector<FoundLight> found;
  for (const dvec3& direction : directions) found.push_back(side_->find(entry, from, direction));
  return found;
}

// ---------------------------------------------------------------------------------------------------------------------

struct EnvironmentLeaves::Side {
  scene::Scene scene;
  reference::EnvironmentMap map;
  double probability;

  explicit Side(const scene::Scene& lights)
      : scene(lights),
        map(*scene.environment),
        probability(reference::LightTable(scene, render::defaultSettings()).environmentProbability()) {}
};

EnvironmentLeaves::EnvironmentLeaves(const scene::Scene& scene) : side_(std::make_unique<Side>(scene)) {}
EnvironmentLeaves::~EnvironmentLeaves() = default;

std::vector<LitPoint> EnvironmentLeaves::sample(std::span<const EnvironmentQuery> queries) const {
  std::vector<LitPoint> points;
  for (const EnvironmentQuery& query : queries) {
    const auto lit = side_->map.sample({query.wordU, query.wordV}, dvec2(query.place));
    points.push_back(lit ? LitPoint{lit->wi, 0, side_->probability * lit->pdf.value(), lit->radiance} : LitPoint{});
  }
  return points;
}

std::vector<EnvironmentTap> EnvironmentLeaves::tap(std::span<const dvec3> directions,
                                                   std::span<const glm::vec3> jitter) const {
  std::vector<EnvironmentTap> taps;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const reference::EnvironmentMap::Tap tap = side_->map.tap(directions[i], dvec2(jitter[i]));
    taps.push_back({tap.radiance, side_->probability * tap.pdf});
  }
  return taps;
}

// ---------------------------------------------------------------------------------------------------------------------

struct RayLeaves::Side {
  scene::Scene scene;
  reference::Tracing tracing;

  explicit Side(const scene::Scene& traced) : scene(traced), tracing(scene, render::defaultSettings()) {}
};

RayLeaves::RayLeaves(const scene::Scene& scene) : side_(std::make_unique<Side>(scene)) {}
RayLeaves::~RayLeaves() = default;

std::vector<TracedHit> RayLeaves::closest(std::span<const ProofRay> rays) const {
  std::vector<TracedHit> hits;
  reference::Counters counters;
  for (const ProofRay& ray : rays) {
    const reference::Hit hit = side_->tracing.closest({ray.origin, normalize(dvec3(ray.direction))}, counters);
    hits.push_back({hit ? hit.distance : 0, hit.primitive});
  }
  return hits;
}

}  // namespace candela::proof
