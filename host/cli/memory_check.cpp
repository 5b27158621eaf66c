// Estimates the memory of a render.
#include "host/cli/memory_check.h"

#include <fmt/format.h>

#include "host/core/errors.h"
#include "host/scene/memory.h"

namespace candela::cli {
namespace {

// Peak memory for each primitive besides the scene: building the acceleration structure, and the device's records.
// A BVH of 7.66 million triangles takes 230 bytes each on the reference and 292 on lavapipe (docs/gltf.md).
constexpr std::uint64_t kBuildBytesPerPrimitive = 300;

double gibibytes(std::uint64_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024 * 1024); }

}  // namespace

void requireMemoryForScene(const scene::Scene& scene, std::uint64_t present) {
  const std::uint64_t count = scene.primitives.size();
  const std::uint64_t needed = scene::memoryOf(scene).total + count * kBuildBytesPerPrimitive;
  if (needed <= present) return;
  throw OutOfMemoryError(fmt::format("{}: rendering {} primitives needs about {:.1f} GiB; this machine has {:.1f} GiB",
                                     scene.name, count, gibibytes(needed), gibibytes(present)));
}

}  // namespace candela::cli
