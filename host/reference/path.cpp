// Path tracing with next-event estimation and multiple importance sampling.
#include "host/reference/path.h"

#include <algorithm>

#include "host/reference/sampling.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

// Veach 1997, exponent 2. `pdf` > 0.
double powerHeuristic(double pdf, double otherPdf) {
  const double ratio = otherPdf / pdf;
  return 1 / (1 + ratio * ratio);
}

double largestChannel(const dvec3& c) { return std::max({c.x, c.y, c.z}); }

// The next of a path's vertices in its record, or `spare` where it is not kept.
VertexRecord& nextVertex(PathRecord* record, VertexRecord& spare) {
  spare = {};
  if (!record || record->vertexCount == PathRecord::kRecordedVertices) return spare;
  return record->vertices[record->vertexCount++] = {};
}

}  // namespace

struct PathTracer::VertexNumbers {
  SampleNumbers& numbers;
  std::uint32_t block;

  VertexNumbers(SampleNumbers& pathNumbers, std::uint32_t depth)
      : numbers(pathNumbers), block(kCameraDimensionCount + (depth - 1) * kVertexDimensionCount) {}

  std::uint32_t lightChoice() const { return numbers.word(block + kDimensionLightChoice); }
  dvec2 light() const { return {numbers.unit(block + kDimensionLightU), numbers.unit(block + kDimensionLightV)}; }
  double lobe() const { return numbers.unit(block + kDimensionLobe); }
  dvec2 bsdf() const { return {numbers.unit(block + kDimensionBsdfU), numbers.unit(block + kDimensionBsdfV)}; }
  double roulette() const { return numbers.unit(block + kDimensionRoulette); }
};

struct PathTracer::Vertex {
  const Surface& surface;
  const Bsdf& bsdf;
  Frame frame;
  dvec3 wo;  ///< in the frame

  Vertex(const Surface& at, const Bsdf& material, const dvec3& rayDirection)
      : surface(at), bsdf(material), frame(at.shadingNormal), wo(frame.toLocal(-rayDirection)) {}

  bool isAboveSurface(const dvec3& wi) const { return dot(wi, surface.facingNormal) > 0; }
  bool isBelowSurface(const dvec3& wi) const { return dot(wi, surface.facingNormal) < 0; }
  Ray rayTowards(const dvec3& wi) const { return {surface.position, wi, surface.primitive, surface.outwardNormal}; }
};

PathTracer::PathTracer(const Scene& scene, const RenderSettings& settings)
    : PixelTracer(scene, settings),
      settings_(settings),
      background_(scene),
      lights_(scene, settings) {
  for (const Material& material : scene.materials) bsdfs_.emplace_back(material);
}

dvec3 PathTracer::radiance(const Ray& cameraRay, SampleNumbers& numbers, Counters& counters,
                           PathRecord* record) const {
  Ray ray = cameraRay;
  dvec3 radiance(0);
  dvec3 beta(1);
  std::optional<double> pdf;
  VertexRecord unrecorded;
  for (std::uint32_t depth = 1;; ++depth) {
    const Hit hit = tracing().closest(ray, counters);
    VertexRecord& vertexRecord = nextVertex(record, unrecorded);
    vertexRecord.primitive = hit.primitive;
    if (!hit) return radiance + beta * background_.radiance(ray.direction);

    ++counters.vertices;
    const Surface surface = surfaceAt(scene(), ray, hit);
    radiance += beta * emission(ray, hit.distance, surface, pdf);
    if (depth == settings_.maxDepth) return radiance;

    const Vertex vertex(surface, bsdfs_[surface.material], ray.direction);
    const VertexNumbers u(numbers, depth);
    if (vertex.bsdf.hasSmoothLobe() && lights_.canChoose()) {
      radiance += beta * directLight(vertex, u, counters, vertexRecord);
    }
    const Scattering next = scatter(vertex, u);
    vertexRecord.lobe = next.lobe;
    beta *= next.weight;
    if (beta == dvec3(0)) return radiance;

    if (depth > settings_.rouletteStart) {
      const double survival = std::min(1.0, largestChannel(beta));
      vertexRecord.survivedRoulette = u.roulette() < survival;
      if (!vertexRecord.survivedRoulette) return radiance;
      beta /= survival;
    }
    ray = vertex.rayTowards(next.wi);
    pdf = next.pdf;
    ++counters.bounceRays;
  }
}

dvec3 PathTracer::emission(const Ray& ray, double distance, const Surface& surface, std::optional<double> pdf) const {
  const Material& material = scene().materials[surface.material];
  if (!isEmissive(material)) return dvec3(0);
  const bool isTriangle = scene().primitives[surface.primitive].kind == PrimitiveKind::triangle;
  if (settings_.oneSided && isTriangle && !surface.fromOutside) return dvec3(0);
  if (!pdf) return material.emission;
  return powerHeuristic(*pdf, lights_.pdf(ray, distance, surface)) * dvec3(material.emission);
}

dvec3 PathTracer::directLight(const Vertex& vertex, VertexNumbers u, Counters& counters, VertexRecord& record) const {
  const LightChoice choice = lights_.choose(u.lightChoice());
  const std::optional<LightSample> light = lights_.sample(choice.entry, vertex.surface, u.light());
  if (!light || !vertex.isAboveSurface(light->wi)) return dvec3(0);
  const dvec3 wi = vertex.frame.toLocal(light->wi);
  const BsdfValue bsdf = vertex.bsdf.evaluate(vertex.wo, wi);
  if (bsdf.f == dvec3(0)) return dvec3(0);

  ++counters.shadowRays;
  const bool occluded = tracing().isOccluded(vertex.rayTowards(light->wi), light->distance, light->primitive, counters);
  record.shadow = occluded ? ShadowOutcome::occluded : ShadowOutcome::visible;
  if (occluded) return dvec3(0);

  const dvec3 contribution = bsdf.f * wi.z * light->radiance;
  if (!light->pdf) return contribution / choice.probability;
  const double lightPdf = choice.probability * *light->pdf;
  return contribution * powerHeuristic(lightPdf, bsdf.pdf) / lightPdf;
}

PathTracer::Scattering PathTracer::scatter(const Vertex& vertex, VertexNumbers u) const {
  if (vertex.bsdf.isBlack()) return {};
  const bool mirror = vertex.bsdf.isMirror();
  const Lobe lobe = mirror ? Lobe::mirror : vertex.bsdf.chooseLobe(u.lobe());
  if (lobe == Lobe::diffuse || lobe == Lobe::glossy) return scatterSmooth(vertex, lobe, u);

  const DeltaSample sample = mirror ? vertex.bsdf.sampleMirror(vertex.wo)
                                    : vertex.bsdf.sampleDielectric(vertex.wo, vertex.surface.fromOutside, u.bsdf().x);
  const dvec3 wi = vertex.frame.toWorld(sample.wi);
  const bool onItsSide = sample.lobe == Lobe::refract ? vertex.isBelowSurface(wi) : vertex.isAboveSurface(wi);
  return {sample.lobe, wi, onItsSide ? sample.weight : dvec3(0), std::nullopt};
}

PathTracer::Scattering PathTracer::scatterSmooth(const Vertex& vertex, Lobe lobe, VertexNumbers u) const {
  const dvec3 local = vertex.bsdf.sampleSmooth(lobe, vertex.wo, u.bsdf());
  const dvec3 wi = vertex.frame.toWorld(local);
  const BsdfValue bsdf = vertex.bsdf.evaluate(vertex.wo, local);
  if (bsdf.pdf == 0 || !vertex.isAboveSurface(wi)) return {.lobe = lobe, .pdf = 0.0};
  return {lobe, wi, bsdf.f * local.z / bsdf.pdf, bsdf.pdf};
}

}  // namespace candela::reference
