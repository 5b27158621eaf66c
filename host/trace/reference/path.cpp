// Path tracing with next-event estimation and multiple importance sampling.
#include "host/trace/reference/path.h"

#include <algorithm>
#include <cmath>

#include "host/trace/reference/anisotropy.h"
#include "host/trace/reference/material_choice.h"
#include "host/trace/reference/path_notes.h"
#include "host/trace/reference/reflectance.h"
#include "host/trace/reference/shading.h"
#include "host/trace/reference/vertex_numbers.h"
#include "host/trace/reference/volumes.h"
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
  if (material.surface) return material.surface->isPerfect();
  return material.mirror || (material.dielectric && !material.diffuse && !material.glossy);
}

}  // namespace

// A path up to its current ray.
struct PathTracer::Path {
  SampleNumbers& numbers;
  Counters& counters;
  Arithmetic& arithmetic;
  PathNotes& notes;
  Ray ray;
  Volumes volumes;
  std::optional<double> pdf{};  // of the ray's direction; none: delta
  LightReceiver receiver{};     // at which the ray starts; undefined for camera rays
  dvec3 beta{1};                // the throughput
  dvec3 radiance{0};
  std::uint32_t depth = 1;  // of the ray
  bool isShown = true;      // the layers show the next hit
  double shownDistance = 0;

  VertexNumbers u() const { return VertexNumbers(numbers, depth); }
};

// The surface at which a ray arrives, and its material there.
struct PathTracer::Vertex {
  double distance;
  Surface surface;
  SurfaceMaterial material;

  Vertex(const PathTracer& tracer, const Path& path, const Hit& hit)
      : distance(hit.distance),
        surface(tracer.surfaceAt(path, hit)),
        material(tracer.materialAt(surface, path.arithmetic)) {
    dimEmission(surface, path.ray.direction, material);
    alignAnisotropy({tracer.scene(), path.arithmetic}, surface, material);
    mapLayer({tracer.scene(), path.arithmetic}, path.ray.direction, path.u(), surface, material);
  }
};

PathTracer::PathTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : PixelTracer(scene, settings), settings_(settings), background_(scene), lights_(scene, settings) {
  if (scene.environment) environment_.emplace(*scene.environment);
}

render::PathTrace PathTracer::trace(const render::PixelSample& sample, Arithmetic& arithmetic) const {
  render::PathTrace trace;
  PathNotes notes(trace);
  Counters uncounted;
  SampleNumbers numbers = numbersOf(sample);
  for (std::uint32_t i = 0; i < trace.cameraNumbers.size(); ++i)
    trace.cameraNumbers[i] = numbers.word(kDimensionFilterX + i);
  Path path{numbers, uncounted, arithmetic, notes, cameraRay(sample, numbers, arithmetic), Volumes(scene())};
  notes.finish(tracePath(path));
  return trace;
}

dvec3 PathTracer::radiance(const Ray& cameraRay, SampleState& state) const {
  PathNotes notes(state.outputs.record, state.outputs.layers);
  Path path{state.numbers, state.counters, state.arithmetic, notes, cameraRay, Volumes(scene())};
  return tracePath(path);
}

dvec3 PathTracer::tracePath(Path& path) const {
  for (;; ++path.depth) {
    const Hit hit = arrive(path);
    if (!hit) break;
    Vertex vertex(*this, path, hit);
    noteHit(path, vertex);
    emit(path, vertex);
    if (path.depth == settings_.image.maxDepth) break;
    const Shading shading(vertex.surface, vertex.material, path.ray.direction, channelAt(path, vertex.surface),
                          path.arithmetic);
    path.receiver = shading.receiver();
    light(path, shading);
    if (!scatter(path, shading) || !roulette(path)) break;
  }
  return path.radiance;
}

Hit PathTracer::arrive(Path& path) const {
  path.notes.startVertex(path.depth, path.ray, path.pdf, path.beta, path.radiance, path.numbers);
  path.counters.bounceRays += path.depth > 1 ? 1 : 0;
  path.ray.opacityKey = opacityKeyOf(path.numbers, path.depth, false);
  const Hit hit = path.arithmetic.closest(tracing(), path.depth, path.ray, path.counters);
  if (hit) {
    ++path.counters.vertices;
    path.beta *= path.volumes.transmittance(hit.distance);
  } else {
    path.counters.volumeFaults += path.volumes.isInside() ? 1 : 0;
    path.radiance += limited(path.beta * background(path), path.depth - 1);
  }
  return hit;
}

void PathTracer::emit(Path& path, const Vertex& vertex) const {
  path.radiance += limited(path.beta * emission(path, vertex), path.depth - 1);
  path.notes.scattered(path.depth - 1, path.radiance);
}

void PathTracer::light(Path& path, const Shading& shading) const {
  if (!shading.bsdf().hasSmoothLobe() || !lights_.canChoose()) return;
  path.radiance += limited(path.beta * directLight(path, shading), path.depth);
}

bool PathTracer::scatter(Path& path, const Shading& shading) {
  const Scattering next = shading.sample(path.u());
  path.arithmetic.decide(static_cast<std::uint64_t>(next.lobe));
  path.notes.lobe(next.lobe);
  path.beta *= path.arithmetic.throughput(next.weight);
  if (path.beta == dvec3(0)) return false;
  path.notes.scattering({next.lobe, next.wi, next.pdf.value_or(0), next.weight});
  const bool isRefracted = next.side() == Side::transmission;
  if (isRefracted) path.counters.volumeFaults += path.volumes.cross(shading.surface()) ? 0 : 1;
  path.ray = shading.rayTowards(next.wi, next.side());
  path.pdf = next.pdf;
  return true;
}

bool PathTracer::roulette(Path& path) const {
  if (path.depth <= settings_.image.rouletteStart) return true;
  const double survival = path.arithmetic.survival(std::min(1.0, std::sqrt(largestOf(path.beta))));
  const bool survives = path.u().roulette() < survival;
  path.arithmetic.decide(survives);
  path.notes.roulette(survival, survives);
  if (survives) path.beta /= survival;
  return survives;
}

dvec3 PathTracer::background(const Path& path) const {
  const bool isCameraRay = path.depth == 1;
  if (isCameraRay && settings_.image.backdrop == render::Backdrop::colour) return scene().background;
  if (isCameraRay && settings_.image.backdrop == render::Backdrop::none) return dvec3(0);
  if (!environment_) return background_.radiance(path.ray.direction);
  const dvec3 direction = path.arithmetic.mapDirection(path.ray.direction);
  const EnvironmentMap::Tap tap = environment_->tap(direction, path.u().tap());
  path.arithmetic.decide(tap.texel);
  const double lightPdf = path.arithmetic.pdf(lights_.environmentProbability() * tap.pdf);
  return (path.pdf ? powerHeuristic(*path.pdf, lightPdf) : 1) * tap.radiance;
}

dvec3 PathTracer::limited(const dvec3& contribution, std::uint32_t scatterings) const {
  if (!settings_.image.indirectLimit || scatterings < 2) return contribution;
  const double limit = *settings_.image.indirectLimit;
  return contribution * (limit / std::max(largestOf(contribution), limit));
}

Surface PathTracer::surfaceAt(const Path& path, const Hit& hit) const {
  Surface surface = path.arithmetic.surfaceAt(scene(), path.ray, hit);
  jitterTextures(surface, path.numbers, path.depth);
  path.arithmetic.decide(surface.fromOutside);
  chooseMaterial({scene(), path.arithmetic}, path.u(), surface);
  return surface;
}

void PathTracer::noteHit(Path& path, const Vertex& vertex) const {
  const auto& [distance, surface, material] = vertex;
  path.notes.hit(distance, surface);
  if (!path.isShown) return;
  path.shownDistance += distance;
  path.isShown = settings_.image.layersThroughSpecular && isPerfect(scene().materials[surface.material]);
  if (!path.isShown) path.notes.firstHit(path.shownDistance, surface, material);
}

dvec3 PathTracer::emission(const Path& path, const Vertex& vertex) const {
  const auto& [distance, surface, material] = vertex;
  if (!material.emits) return dvec3(0);
  const bool isTriangle = scene().primitives[surface.primitive].kind == scene::PrimitiveKind::triangle;
  if (settings_.image.oneSided && isTriangle && !surface.fromOutside) return dvec3(0);
  const double lightPdf = path.pdf ? path.arithmetic.pdf(pdfByLights(path, vertex)) : 0;
  const double weight = path.pdf ? powerHeuristic(*path.pdf, lightPdf) : 1;
  const dvec3 found = weight * material.emission;
  path.notes.emission(found, weight);
  return found;
}

double PathTracer::pdfByLights(const Path& path, const Vertex& vertex) const {
  return lights_.pdf(path.ray, vertex.distance, vertex.surface, path.receiver, path.arithmetic);
}

std::optional<ChannelChoice> PathTracer::channelAt(const Path& path, const Surface& surface) const {
  const auto& parameters = scene().materials[surface.material].surface;
  if (!parameters || !parameters->disperses()) return std::nullopt;
  const ChannelChoice choice = chooseChannel(path.beta, path.arithmetic.choice(path.u().channel()));
  path.arithmetic.decide(choice.channel);
  return choice;
}

std::optional<LightSample> PathTracer::sampleLight(const Path& path, const LightChoice& choice,
                                                   const Surface& surface) const {
  const VertexNumbers u = path.u();
  std::optional<LightSample> light = lights_.isEnvironment(choice.entry)
                                         ? environment_->sample(u.lightWords(), u.texel())
                                         : lights_.sample(choice, surface, u.light());
  if (light) light = path.arithmetic.lightSample(*light);
  return light;
}

dvec3 PathTracer::directLight(const Path& path, const Shading& shading) const {
  const LightChoice choice = lights_.choose(path.receiver, path.u(), path.arithmetic);
  path.notes.lightChoice(choice);
  std::optional<LightSample> light = sampleLight(path, choice, shading.surface());
  if (!light) return dvec3(0);
  light->radiance *= emissionFactor({scene(), path.arithmetic}, *light, shading.surface());
  const dvec3 wi = shading.toLocal(light->wi);
  const Side side = shading.sideOf(wi);
  if (!shading.bsdf().scattersTo(side) || !shading.isOn(side, light->wi)) return dvec3(0);
  const BsdfValue bsdf = shading.valueOf(wi, side);
  if (bsdf.f * light->radiance == dvec3(0)) return dvec3(0);

  ++path.counters.shadowRays;
  const double lightPdf = choice.probability * light->pdf.value_or(1);
  Ray shadowRay = shading.rayTowards(light->wi, side);
  shadowRay.opacityKey = opacityKeyOf(path.numbers, path.depth, true);
  const bool occluded = path.arithmetic.isOccluded(tracing(), shadowRay, light->end(), path.counters);
  path.notes.shadowRay(*light, lightPdf, bsdf.pdf, occluded);
  if (occluded) return dvec3(0);

  const double weight = light->pdf ? powerHeuristic(lightPdf, bsdf.pdf) : 1;
  Volumes beyond = path.volumes;
  if (side == Side::transmission) beyond.cross(shading.surface());
  const dvec3 arriving = bsdf.f * light->radiance * weight / lightPdf * beyond.transmittance(light->distance);
  path.notes.lit(weight, arriving);
  path.arithmetic.decideLit(arriving,
                            shading.facets ? std::abs(dot(light->wi, shading.surface().facingNormal)) : std::abs(wi.z));
  return arriving;
}

}  // namespace candela::reference
