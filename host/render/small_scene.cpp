#include "host/render/small_scene.h"

#include "shaders/shared/render_data.h"

namespace candela {
namespace {

// What a test costs in a row, in units of about 9 ns for eight rays on lavapipe; a cone's takes 8, but trees spare so
// many of such tests that it counts twice.
std::uint32_t rowCost(PrimitiveKind kind) {
  switch (kind) {
    case PrimitiveKind::plane:
      return 1;
    case PrimitiveKind::sphere:
    case PrimitiveKind::box:
      return 2;
    case PrimitiveKind::triangle:
      return 3;
    case PrimitiveKind::cone:
      return 16;
  }
  return 0;
}

}  // namespace

SmallSceneRule smallSceneRule(const DeviceInfo& info) {
  if (info.driver.starts_with("llvmpipe")) return {.mostCost = 128, .rowsAhead = true};
  return {};
}

bool isSmall(const Scene& scene, const SmallSceneRule& rule) {
  if (scene.primitives.size() > gpu::kMaxUniformSlots) return false;
  std::uint32_t cost = 0;
  for (const Primitive& primitive : scene.primitives) cost += rowCost(primitive.kind);
  return cost <= rule.mostCost;
}

}  // namespace candela
