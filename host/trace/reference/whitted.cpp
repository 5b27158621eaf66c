// Recurses over the tree of rays: each call returns the radiance of its ray.
#include "host/trace/reference/whitted.h"

#include <cmath>

#include "host/trace/reference/fresnel.h"
#include "shaders/shared/dimensions.h"

namespace candela::reference {
namespace {

dvec3 localColour(const scene::WhittedMaterial& material, const dvec3& normal, const dvec3& wo, const dvec3& wi) {
  const double cosH = dot(normal, normalize(wi + wo));
  return double{material.kd} * dot(normal, wi) * dvec3(material.diffuse) +
         material.ks * std::pow(cosH, double{material.shine}) * dvec3(material.specular);
}

void keep(const render::VertexRecord& vertex, render::PathRecord* record) {
  if (record && record->vertexCount < render::PathRecord::kRecordedVertices)
    record->vertices[record->vertexCount++] = vertex;
}

}  // namespace

struct WhittedTracer::Node {
  Ray ray;
  std::uint32_t number = 1;
  std::uint32_t depth = 1;

  Node reflected(const Ray& next) const { return {next, 2 * number, depth + 1}; }
  Node refracted(const Ray& next) const { return {next, 2 * number + 1, depth + 1}; }
};

WhittedTracer::WhittedTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : PixelTracer(scene, settings),
      maxDepth_(settings.image.maxDepth),
      lightSize_(settings.image.lightSize),
      background_(scene) {
  placeLights(*scene.camera);
}

void WhittedTracer::setCamera(const scene::Camera& camera) {
  PixelTracer::setCamera(camera);
  placeLights(camera);
}

void WhittedTracer::placeLights(const scene::Camera& camera) {
  lights_.clear();
  for (const scene::PointLight& light : scene().pointLights) {
    const dvec3 position(light.position);
    const dvec3 towards = dvec3(camera.at) - position;
    lights_.push_back(
        {position, dvec3(light.colour), Frame(towards == dvec3(0) ? dvec3(0, 0, 1) : normalize(towards))});
  }
}

dvec3 WhittedTracer::radiance(const Ray& ray, SampleState& state) const { return radianceAt({ray}, state); }

dvec3 WhittedTracer::radianceAt(const Node& node, SampleState& state) const {
  Arithmetic& arithmetic = state.arithmetic;
  Ray ray = node.ray;
  const Hit hit = arithmetic.closest(tracing(), node.number, ray, state.counters);
  render::VertexRecord record{.primitive = hit.primitive};
  if (!hit) {
    keep(record, state.outputs.record);
    return background_.radiance(ray.direction);
  }
  ++state.counters.vertices;
  if (node.depth == 1) ++state.counters.cameraHits;
  const Surface surface = arithmetic.surfaceAt(scene(), ray, hit);
  arithmetic.decide(surface.fromOutside);
  const SurfaceMaterial material = materialAt(surface, arithmetic);
  const scene::WhittedMaterial& whitted = material.whitted.value();
  dvec3 sum = material.emission + double{whitted.ka} * dvec3(whitted.diffuse);
  sum += direct(node, surface, state, record);
  const Branches branches = node.depth < maxDepth_ ? branchesAt(surface, -ray.direction, arithmetic) : Branches{};
  arithmetic.decide(static_cast<std::uint64_t>(branches.lobe));
  record.lobe = branches.lobe;
  keep(record, state.outputs.record);

  const auto rayTowards = [&](const dvec3& direction, bool crosses) {
    return Ray{surface.position, direction, surface.primitive, surface.outwardNormal, 0, crosses, surface.contact};
  };
  if (branches.reflected.factor > 0) {
    ++state.counters.bounceRays;
    ++state.counters.reflectedRays;
    sum += branches.reflected.factor *
           radianceAt(node.reflected(rayTowards(branches.reflected.direction, false)), state);
  }
  if (branches.refracted.factor > 0) {
    ++state.counters.bounceRays;
    ++state.counters.refractedRays;
    sum += branches.refracted.factor *
           radianceAt(node.refracted(rayTowards(branches.refracted.direction, true)), state);
  }
  return arithmetic.radiance(sum);
}

dvec3 WhittedTracer::direct(const Node& node, const Surface& surface, SampleState& state,
                            render::VertexRecord& record) const {
  const scene::WhittedMaterial material = materialAt(surface, state.arithmetic).whitted.value();
  if (material.kd == 0 && material.ks == 0) return dvec3(0);
  Arithmetic& arithmetic = state.arithmetic;
  dvec3 sum(0);
  for (std::uint32_t i = 0; i < lights_.size(); ++i) {
    const dvec3 point = lightPoint(i, node.number, state.numbers);
    const dvec3 towards = point - surface.position;
    const double distance = arithmetic.lightDistance(length(towards));
    if (distance == 0) continue;
    const dvec3 wi = arithmetic.lightDirection(towards / distance);
    if (dot(surface.shadingNormal, wi) <= 0 || dot(surface.facingNormal, wi) <= 0) continue;

    ++state.counters.shadowRays;
    const Ray ray{surface.position, wi, surface.primitive, surface.outwardNormal, 0, false, surface.contact};
    const bool occluded = arithmetic.isOccluded(tracing(), ray, {.distance = distance, .point = point}, state.counters);
    if (occluded) {
      record.shadow = render::ShadowOutcome::occluded;
      continue;
    }
    if (record.shadow == render::ShadowOutcome::notTraced) record.shadow = render::ShadowOutcome::visible;
    const unsigned seen = record.visibleLights ^ 1u << (i % render::VertexRecord::kRecordedLights);
    record.visibleLights = static_cast<std::uint16_t>(seen);
    const dvec3 colour = localColour(material, surface.shadingNormal, -node.ray.direction, wi);
    const dvec3 arriving = lights_[i].colour * arithmetic.reflectance(colour);
    arithmetic.decideLit(arriving, dot(surface.shadingNormal, wi));
    sum += arriving;
  }
  return sum;
}

dvec3 WhittedTracer::lightPoint(std::uint32_t light, std::uint32_t node, SampleNumbers& numbers) const {
  const auto& [position, colour, frame] = lights_[light];
  if (lightSize_ == 0) return position;
  const std::uint32_t block = kCameraDimensionCount + (node - 1) * kVertexDimensionCount;
  const auto offset = [&](std::uint32_t dimension) {
    return lightSize_ * (toUnit(numbers.word(block + dimension) + light * 0x9e3779b9u) - 0.5);
  };
  return position + frame.toWorld({offset(kDimensionLightU), offset(kDimensionLightV), 0});
}

WhittedTracer::Branches WhittedTracer::branchesAt(const Surface& surface, const dvec3& wo,
                                                  Arithmetic& arithmetic) const {
  const scene::WhittedMaterial material = materialAt(surface, arithmetic).whitted.value();
  if (material.kind == scene::WhittedKind::opaque) return {};
  const dvec3& normal = surface.shadingNormal;
  const double cosine = dot(normal, wo);
  Branches branches;
  branches.reflected = {arithmetic.direction(2 * cosine * normal - wo), material.ks};
  branches.lobe = render::Lobe::mirror;
  if (material.kind == scene::WhittedKind::glass) {
    const double ior = material.ior;
    const double eta = surface.fromOutside ? 1 / ior : ior;
    const Boundary boundary = fresnel(cosine, eta);
    branches.reflected.factor = arithmetic.reflectance(boundary.reflectance);
    const dvec3 refracted = -eta * wo + (eta * cosine - boundary.cosTransmitted) * normal;
    branches.refracted = {arithmetic.direction(refracted), 1 - boundary.reflectance};
    branches.lobe = render::Lobe::reflect;
  }
  if (dot(branches.reflected.direction, surface.facingNormal) <= 0) branches.reflected.factor = 0;
  if (dot(branches.refracted.direction, surface.facingNormal) >= 0) branches.refracted.factor = 0;
  if (branches.refracted.factor > 0) {
    branches.lobe = render::Lobe::refract;
  } else if (branches.reflected.factor == 0) {
    branches.lobe = render::Lobe::none;
  }
  return branches;
}

}  // namespace candela::reference
