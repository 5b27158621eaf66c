// Random signs, and the quantities that they move.
#include "host/reference/rounding.h"

#include <algorithm>
#include <cmath>

#include "host/core/hash.h"

namespace candela::reference {

namespace {

// Returns whether an error of a hit's position is so large in comparison with a triangle that it makes the barycentric
// coordinates, and with them the vertex normals and textures, meaningless. What replicas show is then not what a device
// shows, so that it must count as undecidable.
bool isLostIn(const scene::Scene& scene, std::uint32_t index, double error) {
  constexpr double kLost = 0.25;  // of the smallest height of the triangle
  const scene::Primitive& primitive = scene.primitives[index];
  if (primitive.kind != scene::PrimitiveKind::triangle) return false;
  const TriangleShape triangle(triangleOf(scene, primitive));
  const double longest = std::max(
      {length(triangle.edge1), length(triangle.edge2), length(triangle.edge2 - triangle.edge1)});
  return error * longest > kLost * length(triangle.areaNormal());
}

}  // namespace

Rounding::Rounding(std::uint64_t key, std::uint32_t replica)
    : records_(true), perturbs_(replica > 0), key_(splitMix(key + replica * kSplitMixStep)), counter_(key_) {}

std::uint64_t Rounding::nextWord() { return splitMix(counter_ += kSplitMixStep); }

double Rounding::signOf(std::uint64_t word, std::uint32_t primitive) {
  return (splitMix(word + primitive * kSplitMixStep) & 1) != 0 ? 1 : -1;
}

double Rounding::sign() {
  if (bitCount_ == 0) {
    bits_ = nextWord();
    bitCount_ = 64;
  }
  --bitCount_;
  const bool up = bits_ & 1;
  bits_ >>= 1;
  return up ? 1 : -1;
}

void Rounding::startVertex(std::uint32_t vertex) {
  counter_ = splitMix(key_ ^ splitMix(vertex * kSplitMixStep));
  bitCount_ = 0;
}

void Rounding::startVertex(std::uint32_t vertex, const Ray& ray) {
  if (!records_) return;
  startVertex(vertex);
  trail_.push_back({ray.origin, ray.direction, decisions_});
}

dvec3 Rounding::relative(const dvec3& value, double units) {
  if (!perturbs_) return value;
  return {relative(value.x, units), relative(value.y, units), relative(value.z, units)};
}

dvec3 Rounding::moved(const dvec3& value, double units, double scale) {
  return perturbs_ ? value + units * kRoundoff * scale * signs() : value;
}

dvec3 Rounding::turned(const dvec3& direction, double units) {
  return perturbs_ ? normalize(direction + units * kRoundoff * signs()) : direction;
}

Ray Rounding::cameraRay(Ray ray, bool originVaries) {
  if (!records_) return ray;
  startVertex(0);
  if (originVaries) ray.origin = moved(ray.origin, kRoundingBounds.lensPoint, maxNorm(ray.origin));
  ray.direction = turned(ray.direction, kRoundingBounds.cameraDirection);
  return ray;
}

Surface Rounding::surfaceAt(const scene::Scene& scene, Ray ray, const Hit& hit) {
  if (!perturbs_) return reference::surfaceAt(scene, ray, hit);
  const double scale = std::max({maxNorm(ray.origin), maxNorm(ray.at(hit.distance)), hit.distance});
  if (isLostIn(scene, hit.primitive, kRoundingBounds.position * kRoundoff * scale)) decide(key_);
  ray.origin = moved(ray.origin, kRoundingBounds.position, scale);
  Surface surface = reference::surfaceAt(scene, ray, hit);
  const dvec3 error = kRoundingBounds.normal * kRoundoff * signs();
  const bool fromOutside = dot(ray.direction, surface.outwardNormal + error) < 0;
  const bool turns = fromOutside != surface.fromOutside;
  surface.fromOutside = fromOutside;
  surface.outwardNormal = normalize(surface.outwardNormal + error);
  surface.smoothNormal = normalize(surface.smoothNormal + error);
  const bool isSmooth = surface.shadingNormal != surface.facingNormal;
  surface.facingNormal = fromOutside ? surface.outwardNormal : -surface.outwardNormal;
  surface.shadingNormal = isSmooth ? normalize((turns ? -1.0 : 1.0) * surface.shadingNormal + error)
                                   : surface.facingNormal;
  return surface;
}

std::optional<LightSample> Rounding::lightSample(std::optional<LightSample> light) {
  if (!perturbs_ || !light) return light;
  light->wi = turned(light->wi, kRoundingBounds.lightDirection);
  light->distance = relative(light->distance, kRoundingBounds.lightDistance);
  light->radiance = relative(light->radiance, kRoundingBounds.pdf);
  if (light->pdf) light->pdf = relative(*light->pdf, kRoundingBounds.pdf);
  return light;
}

BsdfValue Rounding::bsdfValue(BsdfValue value, double units) {
  if (!perturbs_) return value;
  return {relative(value.f, units), relative(value.pdf, units)};
}

}  // namespace candela::reference
