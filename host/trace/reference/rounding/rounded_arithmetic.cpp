// Random signs, and the quantities that they move.
#include "host/trace/reference/rounding/rounded_arithmetic.h"

#include <algorithm>
#include <cmath>

#include "host/base/hash.h"

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

// Returns the bound of the errors of f and pdf.
double bsdfUnits(const Bsdf& bsdf) {
  if (bsdf.interface() != nullptr) return kRoundingBounds.surface;
  const SurfaceBsdf* const surface = bsdf.surface();
  if (surface == nullptr) return kRoundingBounds.bsdf;
  const double sheen = kRoundingBounds.sheen * surface->sheenSteepness();
  return std::hypot(kRoundingBounds.surface, sheen, kRoundingBounds.film * surface->filmThickness());
}

}  // namespace

Hit RecordedArithmetic::closest(const Tracing& tracing, std::uint32_t vertex, Ray& ray, Counters& counters) {
  record(ray);
  const Hit hit = Arithmetic::closest(tracing, vertex, ray, counters);
  decide(hit.primitive);
  return hit;
}

void RecordedArithmetic::decide(std::uint64_t choice) {
  decisions_ = (decisions_ ^ choice) * 0x9fb21c651e98df25u;
  decisions_ ^= decisions_ >> 32;
}

void RecordedArithmetic::decideLit(const dvec3& radiance, double cosine) {
  constexpr double kNegligible = 0x1p-26;
  constexpr double kHorizon = 0x1p-18;  // several times the error of a direction's cosine
  constexpr std::uint64_t kLit = 0x6c69676874u;
  if (maxNorm(radiance) > kNegligible && cosine > kHorizon) decide(kLit);
}

RoundedArithmetic::RoundedArithmetic(const RoundedTracing& tracing, std::uint64_t key)
    : tracing_(tracing), key_(splitMix(key)), counter_(key_) {}

std::uint64_t RoundedArithmetic::nextWord() { return splitMix(counter_ += kSplitMixStep); }

double RoundedArithmetic::sign() {
  if (bitCount_ == 0) {
    bits_ = nextWord();
    bitCount_ = 64;
  }
  --bitCount_;
  const bool up = bits_ & 1;
  bits_ >>= 1;
  return up ? 1 : -1;
}

void RoundedArithmetic::startVertex(std::uint32_t vertex) {
  counter_ = splitMix(key_ ^ splitMix(vertex * kSplitMixStep));
  bitCount_ = 0;
}

dvec3 RoundedArithmetic::relative(const dvec3& value, double units) {
  return {relative(value.x, units), relative(value.y, units), relative(value.z, units)};
}

RayErrors RoundedArithmetic::rayErrors() {
  const dvec3 errors = signs();
  return {errors, nextWord()};
}

Ray RoundedArithmetic::cameraRay(const Ray& ray, bool originVaries) {
  startVertex(0);
  Ray rounded = ray;
  if (originVaries) rounded.origin = moved(ray.origin, kRoundingBounds.lensPoint, maxNorm(ray.origin));
  rounded.direction = turned(ray.direction, kRoundingBounds.cameraDirection);
  return rounded;
}

Hit RoundedArithmetic::closest(const Tracing&, std::uint32_t vertex, Ray& ray, Counters& counters) {
  startVertex(vertex);
  record(ray);
  const Hit hit = tracing_.closest(ray, counters, rayErrors());
  decide(hit.primitive);
  return hit;
}

bool RoundedArithmetic::isOccluded(const Tracing&, const Ray& ray, const RayEnd& end, Counters& counters) {
  return tracing_.isOccluded(ray, end, counters, rayErrors());
}

Surface RoundedArithmetic::surfaceAt(const scene::Scene& scene, const Ray& ray, const Hit& hit) {
  const double scale = std::max({maxNorm(ray.origin), maxNorm(ray.at(hit.distance)), hit.distance});
  if (isLostIn(scene, hit.primitive, kRoundingBounds.position * kRoundoff * scale)) decide(key_);
  Ray rounded = ray;
  rounded.origin = moved(ray.origin, kRoundingBounds.position, scale);
  Surface surface = reference::surfaceAt(scene, rounded, hit);
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

dvec2 RoundedArithmetic::texCoords(const std::optional<scene::TextureReference>& texture,
                                   const MeshAttributes& attributes) {
  const dvec2 errorSigns{sign(), sign()};
  return roundedTexCoords(texture, attributes, errorSigns);
}

LightSample RoundedArithmetic::lightSample(const LightSample& light) {
  LightSample rounded = light;
  rounded.wi = turned(light.wi, kRoundingBounds.lightDirection);
  rounded.distance = relative(light.distance, kRoundingBounds.lightDistance);
  rounded.radiance = relative(light.radiance, kRoundingBounds.pdf);
  if (light.pdf) rounded.pdf = relative(*light.pdf, kRoundingBounds.pdf);
  return rounded;
}

BsdfValue RoundedArithmetic::bsdfValue(const BsdfValue& value, const Bsdf& bsdf) {
  const double units = bsdfUnits(bsdf);
  return {relative(value.f, units), relative(value.pdf, units)};
}

}  // namespace candela::reference
