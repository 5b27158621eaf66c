// Decides whether a scene is small enough for a linear list.
#include "host/trace/flatten/small_scene.h"

#include <algorithm>

#include "host/scene/shape.h"
#include "host/scene/stored_primitives.h"
#include "shaders/shared/render_data.h"

namespace candela::flatten {
namespace {

// Cost of one test in a linear list, in units of about 9 ns for eight rays on lavapipe. A cone's test takes 8, but BVHs
// save so many of these tests that it counts twice.
struct TestCost {
  std::uint32_t operator()(const scene::Plane&) const { return 1; }
  std::uint32_t operator()(const scene::Sphere&) const { return 2; }
  std::uint32_t operator()(const scene::Box&) const { return 2; }
  std::uint32_t operator()(const scene::Triangle&) const { return 3; }
  std::uint32_t operator()(const scene::Cone&) const { return 16; }
};

}  // namespace

bool isSmall(const scene::Scene& scene, const std::vector<bool>& coincident, const SmallSceneRule& rule) {
  if (scene.primitives.size() > gpu::kMaxUniformSlots) return false;
  // Tests of transparent triangles look up textures, which is too much code to be unrolled.
  if (std::ranges::any_of(scene.materials, [](const auto& material) { return material.opacity.has_value(); })) {
    return false;
  }
  // So is the test of a surface that coincides with others: with 16 of them, kernels compile in 1.3 s instead of 0.4 s,
  // and a BVH is faster. lavapipe would compile the rules for emitters again at every dispatch.
  constexpr std::ptrdiff_t kMaxCoincident = 4;
  std::ptrdiff_t coincidentCount = 0;
  const scene::StoredPrimitives stored(scene.primitives);
  for (std::uint32_t i = 0; !coincident.empty() && i < scene.primitives.size(); ++i) {
    if (!coincident[stored.indexOf(i)]) continue;
    if (++coincidentCount > kMaxCoincident || isEmissive(scene.materials[scene.primitives[i].material])) return false;
  }
  std::uint32_t cost = 0;
  for (const scene::Primitive& primitive : scene.primitives) {
    cost += std::visit(TestCost(), shapeOf(scene, primitive));
  }
  return cost <= rule.maxCost;
}

}  // namespace candela::flatten
