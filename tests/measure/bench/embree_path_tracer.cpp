// Traces paths with next-event estimation, multiple importance sampling and Russian roulette.
#include "tests/measure/bench/embree_path_tracer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <thread>

#include "host/base/errors.h"
#include "host/trace/reference/sampling.h"
#include "shaders/shared/dimensions.h"

namespace candela::bench {
namespace {

using glm::dvec3;
using reference::SampleNumbers;

constexpr float kFar = 3.402823e38f;

bool isDiffuse(const scene::Material& material) {
  return material.diffuse && material.diffuse->weight == 1 && !material.surface && !material.glossy &&
         !material.dielectric && !material.mirror && !material.opacity && !isTextured(material);
}

gpu::CastRay castRay(const dvec3& origin, const dvec3& direction, float limit) {
  return {glm::vec4(origin, limit), glm::vec4(direction, 0)};
}

double square(double x) { return x * x; }

double powerHeuristic(double p, double q) { return square(p) / (square(p) + square(q)); }

}  // namespace

EmbreePathTracer::EmbreePathTracer(const scene::Scene& scene, const render::RenderSettings& settings)
    : scene_(scene),
      image_(settings.image),
      embree_(scene),
      lights_(flatten::buildLightTable(scene, true).entries),
      sampler_(image_.sampler, image_.seed, image_.sampleCount),
      camera_(*scene.camera, image_) {
  camera_.setJitter(image_.jittersPixels());
  if (scene.sky || scene.environment) throw FileError(scene.name + ": has a background that is no colour");
  double extent = 0;
  for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
    const scene::Primitive primitive = scene.primitives[i];
    const scene::Material& material = scene.materials[primitive.material];
    if (primitive.kind != scene::PrimitiveKind::triangle || !isDiffuse(material) || isSmooth(scene, primitive)) {
      throw FileError(scene.name + ": has other surfaces than flat diffuse triangles");
    }
    const scene::Triangle corners = triangleOf(scene, primitive);
    const dvec3 edge1 = dvec3(corners.p[1]) - dvec3(corners.p[0]), edge2 = dvec3(corners.p[2]) - dvec3(corners.p[0]);
    const dvec3 normal = cross(edge1, edge2);
    triangles_.push_back({dvec3(corners.p[0]), edge1, edge2, normalize(normal), length(normal) / 2,
                          dvec3(material.diffuse->colour), dvec3(material.emission)});
    extent = std::max({extent, length(edge1), length(edge2)});
  }
  for (const flatten::LightEntry& light : lights_) {
    if (!light.isEmitter()) throw FileError(scene.name + ": has other lights than triangles");
    triangles_[light.index].lightProbability = light.probability;
  }
  offset_ = 1e-6 * extent;
}

EmbreePathTracer::Vertex EmbreePathTracer::trace(const dvec3& origin, const dvec3& direction) const {
  const gpu::CastHit hit = embree_.closest(castRay(origin, direction, kFar));
  Vertex vertex{hit.found.y};
  if (vertex.primitive == gpu::kNoPrimitive) return vertex;
  vertex.distance = std::bit_cast<float>(hit.found.x);
  vertex.position = origin + vertex.distance * direction;
  vertex.normal = triangles_[vertex.primitive].normal;
  if (dot(vertex.normal, direction) > 0) vertex.normal = -vertex.normal;
  return vertex;
}

double EmbreePathTracer::lightPdf(const Triangle& triangle, double distance, double cosine) {
  return triangle.lightProbability * square(distance) / (triangle.area * std::abs(cosine));
}

// Samples a light from a vertex. Returns the light that the surface reflects, for a throughput of 1.
dvec3 EmbreePathTracer::lightAt(const Vertex& vertex, std::uint32_t firstDimension, SampleNumbers& numbers) const {
  const std::uint32_t choice = numbers.word(firstDimension + kDimensionLightChoice) >> 8;
  const auto light = std::ranges::find_if(lights_, [&](const auto& entry) { return choice < entry.threshold; });
  if (light == lights_.end() || light->index == vertex.primitive) return dvec3(0);
  const Triangle& emitter = triangles_[light->index];
  const double u = numbers.unit(firstDimension + kDimensionLightU);
  const glm::dvec2 b = reference::sampleTriangle({u, numbers.unit(firstDimension + kDimensionLightV)});
  const dvec3 start = vertex.position + offset_ * vertex.normal;
  const dvec3 toLight = emitter.corner + b.x * emitter.edge1 + b.y * emitter.edge2 - start;
  const double distance = length(toLight);
  const dvec3 direction = toLight / distance;
  const double cosine = dot(direction, vertex.normal), cosineOfLight = dot(direction, emitter.normal);
  if (cosine <= 0 || cosineOfLight == 0) return dvec3(0);
  const gpu::CastHit shadow = embree_.any(castRay(start, direction, static_cast<float>(distance * (1 - 1e-5))));
  if (shadow.found.y != 0) return dvec3(0);
  const double pdf = lightPdf(emitter, distance, cosineOfLight);
  const double pdfOfLobe = cosine / reference::kPi;
  return triangles_[vertex.primitive].albedo * pdfOfLobe * emitter.emission * powerHeuristic(pdf, pdfOfLobe) / pdf;
}

dvec3 EmbreePathTracer::radiance(std::uint32_t x, std::uint32_t y, std::uint32_t sample) const {
  SampleNumbers numbers(sampler_, x, y, sample);
  const reference::Ray first = camera_.generate(x, y, numbers);
  dvec3 origin = first.origin, direction = first.direction;
  dvec3 radiance(0), throughput(1);
  double pdf = 0;  // of the direction; unused at the camera
  for (std::uint32_t depth = 1;; ++depth) {
    const Vertex vertex = trace(origin, direction);
    if (vertex.primitive == gpu::kNoPrimitive) return radiance + throughput * dvec3(scene_.background);
    const Triangle& triangle = triangles_[vertex.primitive];
    if (triangle.emission != dvec3(0)) {
      const double other = lightPdf(triangle, vertex.distance, dot(direction, triangle.normal));
      radiance += throughput * triangle.emission * (depth == 1 ? 1 : powerHeuristic(pdf, other));
    }
    if (depth == image_.maxDepth) return radiance;
    const std::uint32_t block = kCameraDimensionCount + (depth - 1) * kVertexDimensionCount;
    if (!lights_.empty()) radiance += throughput * lightAt(vertex, block, numbers);
    const double u = numbers.unit(block + kDimensionBsdfU);
    const dvec3 local = reference::sampleCosineHemisphere({u, numbers.unit(block + kDimensionBsdfV)});
    if (local.z <= 0) return radiance;
    throughput *= triangle.albedo;
    if (throughput == dvec3(0)) return radiance;
    if (depth > image_.rouletteStart) {
      const double survival = std::min(1.0, std::sqrt(std::max({throughput.x, throughput.y, throughput.z})));
      if (numbers.unit(block + kDimensionRoulette) >= survival) return radiance;
      throughput /= survival;
    }
    origin = vertex.position + offset_ * vertex.normal;
    direction = reference::Frame(vertex.normal).toWorld(local);
    pdf = local.z / reference::kPi;
  }
}

image::Image EmbreePathTracer::render() const {
  image::Image picture;
  picture.width = image_.size.width;
  picture.height = image_.size.height;
  picture.rgb.resize(std::size_t{picture.width} * picture.height);
  std::atomic<std::uint32_t> next = 0;
  const auto work = [&] {
    for (std::uint32_t y; (y = next.fetch_add(1)) < picture.height;) {
      for (std::uint32_t x = 0; x < picture.width; ++x) {
        dvec3 sum(0);
        for (std::uint32_t sample = 0; sample < image_.sampleCount; ++sample) sum += radiance(x, y, sample);
        picture.at(x, y) = glm::vec3(sum / static_cast<double>(image_.sampleCount));
      }
    }
  };
  std::vector<std::jthread> threads;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) threads.emplace_back(work);
  work();
  threads.clear();
  return picture;
}

}  // namespace candela::bench
