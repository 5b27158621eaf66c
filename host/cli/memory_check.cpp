// Predicts memory by counts of primitives and pixels.
#include "host/cli/memory_check.h"

#include <fmt/format.h>

#include "host/core/memory_budget.h"
#include "host/scene/memory.h"

namespace candela::cli {
namespace {

// Peak memory for each primitive besides the scene: building the acceleration structure, and the device's records.
// A BVH of 7.66 million triangles takes 230 bytes each on the reference and 292 on lavapipe (docs/gltf.md).
constexpr std::uint64_t kBuildBytesPerPrimitive = 300;
// Colour, variance and two counts, and an EXR file with all of them, before compression.
constexpr std::uint64_t kPictureBytesPerPixel = 2 * (sizeof(glm::vec3) + 3 * sizeof(float));

bool isMostlyPixels(const MemoryNeed& need) { return need.pixels() > need.scene + need.structure; }

}  // namespace

MemoryNeed memoryNeedOf(const scene::Scene& scene, const Arguments& arguments) {
  const render::Window window = arguments.request.image.window();
  const std::uint64_t pixels = std::uint64_t{window.width} * window.height;
  MemoryNeed need;
  need.scene = scene::memoryOf(scene).total;
  need.structure = scene.primitives.size() * kBuildBytesPerPrimitive;
  const std::uint64_t layerRows = image::layerRowCount(image::layerSumsOf(arguments.request.image.layers));
  need.film = pixels * (sizeof(image::FilmPixel) + layerRows * sizeof(image::LayerRow));
  const std::uint64_t layerBytes = 2 * layerRows * sizeof(float);
  if (!arguments.outputs.empty()) need.pictures = pixels * (kPictureBytesPerPixel + layerBytes);
  return need;
}

void requireMemoryForRender(const scene::Scene& scene, const Arguments& arguments) {
  const MemoryNeed need = memoryNeedOf(scene, arguments);
  const render::Extent size = arguments.request.image.window().extent();
  requireMemory(fmt::format("{}: rendering {} primitives to {}x{} pixels", scene.name, scene.primitives.size(),
                            size.width, size.height),
                need.total(),
                isMostlyPixels(need) ? "render a smaller --size, or windows with --crop, which `candela merge` adds"
                                     : "render fewer primitives");
}

}  // namespace candela::cli
