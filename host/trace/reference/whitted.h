// The Whitted ray tracer: docs/light-transport.md section 9.
#pragma once
#include <vector>

#include "host/scene/scene.h"
#include "host/trace/reference/background.h"
#include "host/trace/reference/pixel_tracer.h"
#include "host/trace/reference/sampling.h"
#include "host/trace/reference/surface.h"
#include "host/trace/render/settings.h"

namespace candela::reference {

class WhittedTracer final : public PixelTracer {
 public:
  /// The scene, which has a camera, must outlive the object. `settings.image.maxDepth` is at most kMaxTreeDepth.
  WhittedTracer(const scene::Scene& scene, const render::RenderSettings& settings);

  void setCamera(const scene::Camera& camera) override;

 private:
  /// A ray and its position in the tree.
  struct Node;
  /// A spawned ray. If the factor is 0, there is none.
  struct Branch {
    dvec3 direction{0};
    double factor = 0;
  };
  struct Branches {
    Branch reflected;
    Branch refracted;
    render::Lobe lobe = render::Lobe::none;
  };
  /// A point light, and the frame of the square that it fills.
  struct Light {
    dvec3 position;
    dvec3 colour;
    Frame frame;
  };

  dvec3 radiance(const Ray& ray, SampleState& state) const override;
  /// The squares of point lights face the camera's target.
  void placeLights(const scene::Camera& camera);
  dvec3 radianceAt(const Node& node, SampleState& state) const;
  dvec3 direct(const Node& node, const Surface& surface, SampleState& state, render::VertexRecord& record) const;
  dvec3 lightPoint(std::uint32_t light, std::uint32_t node, SampleNumbers& numbers) const;
  Branches branchesAt(const Surface& surface, const dvec3& wo, Arithmetic& arithmetic) const;

  std::uint32_t maxDepth_;
  double lightSize_;
  Background background_;
  std::vector<Light> lights_;
};

}  // namespace candela::reference
