// A path tracer on Embree 3 for scenes of diffuse triangles.
#pragma once
#include <atomic>
#include <vector>

#include "host/image/image.h"
#include "host/trace/flatten/light_table.h"
#include "host/trace/reference/camera.h"
#include "host/trace/reference/sampler.h"
#include "tests/measure/bench/embree_tracer.h"

namespace candela::bench {

/// Renders with the estimator and the random numbers of docs/light-transport.md, so that a picture differs from
/// Candela's by rounding alone, and with it the error of a sample does not. Scalar code, one ray at a time, on all
/// cores.
class EmbreePathTracer {
 public:
  /// Throws FileError if the scene has anything but triangles of one diffuse lobe, which may emit, in front of a
  /// colour.
  EmbreePathTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  image::Image render() const;

 private:
  struct Triangle {
    glm::dvec3 corner, edge1, edge2;
    glm::dvec3 normal;  ///< unit vector
    double area = 0;
    glm::dvec3 albedo, emission;
    double lightProbability = 0;  ///< 0: not in the table
  };
  /// The end of a ray.
  struct Vertex {
    std::uint32_t primitive = gpu::kNoPrimitive;
    double distance = 0;
    glm::dvec3 position{0};
    glm::dvec3 normal{0};  ///< on the side of the ray
  };

  glm::dvec3 radiance(std::uint32_t x, std::uint32_t y, std::uint32_t sample) const;
  glm::dvec3 lightAt(const Vertex& vertex, std::uint32_t firstDimension, reference::SampleNumbers& numbers) const;
  Vertex trace(const glm::dvec3& origin, const glm::dvec3& direction) const;
  /// Density with which light sampling chooses a point of the triangle, per solid angle.
  static double lightPdf(const Triangle& triangle, double distance, double cosine);

  const scene::Scene& scene_;
  render::ImageSettings image_;
  EmbreeTracer embree_;
  std::vector<Triangle> triangles_;
  std::vector<flatten::LightEntry> lights_;
  reference::Sampler sampler_;
  reference::CameraRays camera_;
  double offset_ = 0;  ///< distance of rays' origins from the surface
};

}  // namespace candela::bench
