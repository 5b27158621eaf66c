// Path tracing with next-event estimation and multiple importance sampling.
#include "host/reference/path.h"

#include <algorithm>
#include <cmath>

#include "host/reference/anisotropy.h"
#include "host/reference/facet_scattering.h"
#include "host/reference/reflectance.h"
#include "host/reference/shading_frame.h"
#include "host/reference/vertex_numbers.h"
#include "host/reference/volumes.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

// Power heuristic with exponent 2 (Veach 1997). `pdf` > 0.
double powerHeuristic(double pdf, double otherPdf) {
  const double ratio = otherPdf / pdf;
  return 1 / (1 + ratio * ratio);
}

// A mirror, or smooth glass without another lobe: light-transport.md section 10.1.
bool isPerfect(const scene::Material& material) {
  if (material.surface) return false;
  return material.mirror || (material.dielectric && !material.diffuse && !material.glossy);
}

}  // namespace

struct PathTracer::Vertex : ShadingFrame {
  const Surface& surface;
  Bsdf bsdf;

  /// `choice`: nothing if the surface does not disperse light.
  Vertex(const Surface& at, const SurfaceMaterial& material, const dvec3& rayDirection,
         const std::optional<ChannelChoice>& choice, Rounding& rounding)
      : ShadingFrame(at, rayDirection, rounding), surface(at), bsdf(material.bsdf) {
    if (material.surface) bsdf.setSurface(*material.surface, wo, at.fromOutside, material.isCoatAlone, choice);
  }

  /// Returns f times the cosine for `wi`, which is in the local frame and on this side.
  BsdfValue valueOf(const dvec3& wi, Side side, Rounding& rounding) const {
    return rounding.bsdfValue(scatteredValue(bsdf, facets, wo, wi, side), roundingUnits());
  }

  /// Returns the bound of the rounding error of f and pdf.
  double roundingUnits() const {
    const SurfaceBsdf* const surfaceBsdf = bsdf.surface();
    if (surfaceBsdf == nullptr) return kRoundingBounds.bsdf;
    const double sheen = kRoundingBounds.sheen * surfaceBsdf->sheenSteepness();
    return std::hypot(kRoundingBounds.surface, sheen, kRoundingBounds.film * surfaceBsdf->filmThickness());
  }

  /// Returns whether `wi`, in world space, is on this side of the geometric normal, too.
  bool isOn(Side side, const dvec3& wi) const {
    const double cosine = dot(wi, surface.facingNormal);
    return side == Side::reflection ? cosine > 0 : cosine < 0;
  }
  Ray rayTowards(const dvec3& wi, Side side) const {
    return {surface.position, wi, surface.primitive, surface.outwardNormal, 0, side == Side::transmission,
            surface.contact};
  }
};

PathTracer::PathTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : PixelTracer(scene, settings), settings_(settings), background_(scene), lights_(scene, settings) {
  if (scene.environment) environment_.emplace(*scene.environment);
}

render::PathTrace PathTracer::trace(const render::PixelSample& sample, std::uint32_t replica) const {
  render::PathTrace trace;
  PathNotes notes(trace);
  Counters uncounted;
  SampleNumbers numbers = numbersOf(sample);
  for (std::uint32_t i = 0; i < trace.cameraNumbers.size(); ++i)
    trace.cameraNumbers[i] = numbers.word(kDimensionFilterX + i);
  Rounding rounding = roundingOf(sample, replica);
  notes.finish(tracePath(roundedCameraRay(sample, numbers, rounding), numbers, uncounted, notes, rounding));
  return trace;
}

dvec3 PathTracer::radiance(const Ray& cameraRay, SampleNumbers& numbers, Counters& counters, SampleOutputs outputs,
                           Rounding& rounding) const {
  PathNotes notes(outputs.record, outputs.layers);
  return tracePath(cameraRay, numbers, counters, notes, rounding);
}

dvec3 PathTracer::tracePath(const Ray& cameraRay, SampleNumbers& numbers, Counters& counters, PathNotes& notes,
                            Rounding& rounding) const {
  Ray ray = cameraRay;
  dvec3 radiance(0);
  dvec3 beta(1);
  std::optional<double> pdf;
  Volumes volumes(scene());
  bool isShown = true;  // the layers show the next hit
  double shownDistance = 0;
  for (std::uint32_t depth = 1;; ++depth) {
    notes.startVertex(depth, ray, pdf, beta, radiance, numbers);
    rounding.startVertex(depth, ray);
    ray.opacityKey = opacityKeyOf(numbers, depth, false);
    const Hit hit = tracing().closest(ray, counters, rounding);
    rounding.decide(hit.primitive);
    const VertexNumbers u(numbers, depth);
    if (!hit) counters.volumeFaults += volumes.isInside() ? 1 : 0;
    if (!hit) return radiance + limited(beta * background(ray, pdf, u, rounding), depth - 1);
    beta *= volumes.transmittance(hit.distance);

    ++counters.vertices;
    Surface surface = rounding.surfaceAt(scene(), ray, hit);
    jitterTextures(surface, numbers, depth);
    rounding.decide(surface.fromOutside);
    SurfaceMaterial material = materialAt(surface, rounding);
    dimEmission(surface, ray.direction, material);
    alignAnisotropy(scene(), surface, material, rounding);
    mapLayer(ray.direction, u, surface, material, rounding);
    notes.hit(hit, surface);
    if (isShown) shownDistance += hit.distance;
    const bool isSeenThrough = settings_.image.layersThroughSpecular && isPerfect(scene().materials[surface.material]);
    if (isShown && !isSeenThrough) notes.firstHit(hit, shownDistance, surface, material);
    isShown = isShown && isSeenThrough;
    radiance += limited(beta * emission(material, ray, hit.distance, surface, pdf, notes, rounding), depth - 1);
    notes.scattered(depth - 1, radiance);
    if (depth == settings_.image.maxDepth) return radiance;

    const Vertex vertex(surface, material, ray.direction, channelAt(surface, beta, u, rounding), rounding);
    if (vertex.bsdf.hasSmoothLobe() && lights_.canChoose()) {
      radiance += limited(beta * directLight(vertex, u, volumes, counters, notes, rounding), depth);
    }
    const Scattering next = scatter(vertex, u, rounding);
    rounding.decide(static_cast<std::uint64_t>(next.lobe));
    notes.lobe(next.lobe);
    beta *= rounding.relative(next.weight, kRoundingBounds.throughput);
    if (beta == dvec3(0)) return radiance;
    notes.scattering({next.lobe, next.wi, next.pdf.value_or(0), next.weight});
    if (next.lobe == render::Lobe::refract) counters.volumeFaults += volumes.cross(surface) ? 0 : 1;

    if (depth > settings_.image.rouletteStart && !survivesRoulette(beta, u, notes, rounding)) return radiance;
    ray = vertex.rayTowards(next.wi, next.lobe == render::Lobe::refract ? Side::transmission : Side::reflection);
    pdf = next.pdf;
    ++counters.bounceRays;
  }
}

bool PathTracer::survivesRoulette(dvec3& beta, VertexNumbers u, PathNotes& notes, Rounding& rounding) const {
  const double survival = rounding.relative(std::min(1.0, std::sqrt(largestOf(beta))), kRoundingBounds.survival);
  const bool survives = u.roulette() < survival;
  rounding.decide(survives);
  notes.roulette(survival, survives);
  if (survives) beta /= survival;
  return survives;
}

void PathTracer::mapLayer(const dvec3& rayDirection, VertexNumbers u, Surface& surface, SurfaceMaterial& material,
                          Rounding& rounding) const {
  const scene::Material& source = scene().materials[surface.material];
  if (!hasNormalMap(source) || !hasTangents(scene(), scene().primitives[surface.primitive])) return;
  if (material.surface && material.surface->coatWeight > 0) {
    Surface coat = surface;
    applyNormalMap(scene(), scene::TextureSlot::coatNormal, coat, rounding);
    coat.facetNumber = u.coatFacet();
    const double cosine = ShadingFrame(coat, rayDirection, rounding).wo.z;
    material.isCoatAlone = rounding.absolute(u.layer(), kRoundingBounds.choice) <
                           coatReflectance(material.surface->coatWeight, cosine);
    rounding.decide(material.isCoatAlone);
    if (material.isCoatAlone) {
      surface = coat;
      return;
    }
    material.surface->coatWeight = 0;
  }
  applyNormalMap(scene(), scene::TextureSlot::normal, surface, rounding);
  surface.facetNumber = u.facet();
}

std::optional<ChannelChoice> PathTracer::channelAt(const Surface& surface, const dvec3& throughput, VertexNumbers u,
                                                   Rounding& rounding) const {
  const auto& parameters = scene().materials[surface.material].surface;
  if (!parameters || !parameters->disperses()) return std::nullopt;
  const ChannelChoice choice = chooseChannel(throughput, rounding.absolute(u.channel(), kRoundingBounds.choice));
  rounding.decide(choice.channel);
  return choice;
}

dvec3 PathTracer::background(const Ray& ray, std::optional<double> pdf, VertexNumbers u, Rounding& rounding) const {
  const bool isCameraRay = u.depth == 1;
  if (isCameraRay && settings_.image.backdrop == render::Backdrop::colour) return scene().background;
  if (isCameraRay && settings_.image.backdrop == render::Backdrop::none) return dvec3(0);
  if (!environment_) return background_.radiance(ray.direction);
  const dvec3 direction = rounding.turned(ray.direction, kRoundingBounds.mapDirection);
  const EnvironmentMap::Tap tap = environment_->tap(direction, u.tap());
  rounding.decide(tap.texel);
  const double lightPdf = rounding.relative(lights_.environmentProbability() * tap.pdf, kRoundingBounds.pdf);
  return (pdf ? powerHeuristic(*pdf, lightPdf) : 1) * tap.radiance;
}

dvec3 PathTracer::limited(const dvec3& contribution, std::uint32_t scatterings) const {
  if (!settings_.image.indirectLimit || scatterings < 2) return contribution;
  const double limit = *settings_.image.indirectLimit;
  return contribution * (limit / std::max(largestOf(contribution), limit));
}

std::optional<LightSample> PathTracer::sampleLight(std::uint32_t entry, const Surface& surface, VertexNumbers u) const {
  if (lights_.isEnvironment(entry)) return environment_->sample(u.lightWords(), u.texel());
  return lights_.sample(entry, surface, u.light());
}

dvec3 PathTracer::emission(const SurfaceMaterial& material, const Ray& ray, double distance, const Surface& surface,
                           std::optional<double> pdf, PathNotes& notes, Rounding& rounding) const {
  if (!material.emits) return dvec3(0);
  const bool isTriangle = scene().primitives[surface.primitive].kind == scene::PrimitiveKind::triangle;
  if (settings_.image.oneSided && isTriangle && !surface.fromOutside) return dvec3(0);
  const double lightPdf = pdf ? rounding.relative(lights_.pdf(ray, distance, surface), kRoundingBounds.pdf) : 0;
  const double weight = pdf ? powerHeuristic(*pdf, lightPdf) : 1;
  const dvec3 found = weight * material.emission;
  notes.emission(found, weight);
  return found;
}

dvec3 PathTracer::directLight(const Vertex& vertex, VertexNumbers u, const Volumes& volumes, Counters& counters,
                              PathNotes& notes, Rounding& rounding) const {
  const LightChoice choice = lights_.choose(u.lightChoice());
  notes.lightChoice(choice);
  std::optional<LightSample> light = rounding.lightSample(sampleLight(choice.entry, vertex.surface, u));
  if (!light) return dvec3(0);
  light->radiance *= emissionFactor(scene(), *light, vertex.surface, rounding);
  const dvec3 wi = rounding.turned(vertex.frame.toLocal(light->wi), kRoundingBounds.frame);
  const Side side = vertex.sideOf(wi);
  if (!vertex.bsdf.scattersTo(side) || !vertex.isOn(side, light->wi)) return dvec3(0);
  const BsdfValue bsdf = vertex.valueOf(wi, side, rounding);
  if (bsdf.f * light->radiance == dvec3(0)) return dvec3(0);

  ++counters.shadowRays;
  const double lightPdf = choice.probability * light->pdf.value_or(1);
  Ray shadowRay = vertex.rayTowards(light->wi, side);
  shadowRay.opacityKey = opacityKeyOf(u.numbers, u.depth, true);
  const bool occluded = tracing().isOccluded(shadowRay, light->end(), counters, rounding);
  notes.shadowRay(*light, lightPdf, bsdf.pdf, occluded);
  if (occluded) return dvec3(0);

  const double weight = light->pdf ? powerHeuristic(lightPdf, bsdf.pdf) : 1;
  Volumes beyond = volumes;
  if (side == Side::transmission) beyond.cross(vertex.surface);
  const dvec3 arriving = bsdf.f * light->radiance * weight / lightPdf * beyond.transmittance(light->distance);
  notes.lit(weight, arriving);
  rounding.decideLit(arriving, vertex.facets ? std::abs(dot(light->wi, vertex.surface.facingNormal)) : std::abs(wi.z));
  return arriving;
}

PathTracer::Scattering PathTracer::scatter(const Vertex& vertex, VertexNumbers u, Rounding& rounding) const {
  if (vertex.bsdf.isBlack()) return {};
  if (vertex.bsdf.surface()) return scatterSurface(vertex, u, rounding);
  const bool mirror = vertex.bsdf.isMirror();
  const render::Lobe lobe = mirror ? render::Lobe::mirror
                                   : vertex.bsdf.chooseLobe(rounding.absolute(u.lobe(), kRoundingBounds.choice));
  if (lobe == render::Lobe::diffuse || lobe == render::Lobe::glossy) return scatterSmooth(vertex, lobe, u, rounding);

  const DeltaSample sample = mirror
                                 ? vertex.bsdf.sampleMirror(vertex.wo)
                                 : vertex.bsdf.sampleDielectric(vertex.wo, vertex.surface.fromOutside,
                                                                rounding.absolute(u.bsdf().x, kRoundingBounds.choice));
  const dvec3 wi = rounding.turned(vertex.frame.toWorld(sample.wi), kRoundingBounds.frame);
  const Side side = sample.lobe == render::Lobe::refract ? Side::transmission : Side::reflection;
  return {sample.lobe, wi, vertex.isOn(side, wi) ? sample.weight : dvec3(0), std::nullopt};
}

PathTracer::Scattering PathTracer::scatterSmooth(const Vertex& vertex, render::Lobe lobe, VertexNumbers u,
                                                 Rounding& rounding) const {
  const dvec3 local = rounding.sampledDirection(vertex.bsdf.sampleSmooth(lobe, vertex.wo, u.bsdf()));
  const dvec3 wi = rounding.turned(vertex.frame.toWorld(local), kRoundingBounds.frame);
  const BsdfValue bsdf = vertex.valueOf(local, sideOf(local), rounding);
  if (bsdf.pdf == 0 || !vertex.isOn(sideOf(local), wi)) return {.lobe = lobe, .pdf = 0.0};
  return {lobe, wi, bsdf.f / bsdf.pdf, bsdf.pdf};
}

PathTracer::Scattering PathTracer::scatterSurface(const Vertex& vertex, VertexNumbers u, Rounding& rounding) const {
  const double choice = rounding.absolute(u.lobe(), kRoundingBounds.surfaceChoice);
  SurfaceSample sample = vertex.bsdf.surface()->sample(choice, u.bsdf());
  sample.wi = sample.alpha > 0 ? rounding.microfacetDirection(sample.wi, sample.alpha)
                               : rounding.sampledDirection(sample.wi);
  if (!sample.isOnItsSide()) return {};
  const Side side = sideOf(sample.wi);
  sample.wi = leavingDirection(vertex.facets, sample);
  const dvec3 wi = rounding.turned(vertex.frame.toWorld(sample.wi), kRoundingBounds.frame);
  const BsdfValue bsdf = vertex.valueOf(sample.wi, side, rounding);
  if (bsdf.pdf == 0) return {};
  if (!vertex.isOn(side, wi)) return {.lobe = sample.lobe, .pdf = 0.0};
  return {sample.lobe, wi, bsdf.f / bsdf.pdf, bsdf.pdf};
}

}  // namespace candela::reference
