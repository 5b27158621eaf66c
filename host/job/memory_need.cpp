// Predicts memory by counts of primitives and pixels.
#include "host/job/memory_need.h"

#include <fmt/format.h>

#include "host/base/memory_budget.h"
#include "host/base/setting_words.h"
#include "host/image/film.h"
#include "host/scene/memory.h"
#include "host/scene/stored_primitives.h"

namespace candela::job {
namespace {

// Peak memory for each primitive besides the scene: building the acceleration structure, and the device's records.
// A BVH of 7.66 million triangles takes 230 bytes each on the reference and 292 on lavapipe (docs/gltf.md).
constexpr std::uint64_t kBuildBytesPerPrimitive = 300;
// Colour, variance and two counts, and an EXR file with all of them, before compression.
constexpr std::uint64_t kPictureBytesPerPixel = 2 * (sizeof(glm::vec3) + 3 * sizeof(float));

// Returns the number of primitives that a structure stores: those of instances once, if it has two levels.
std::uint64_t structureSize(const scene::Scene& scene, const render::StructureSettings& structure) {
  const bool hasLevels = structure.accel == render::AccelKind::bvh && structure.bvhLayout != render::BvhLayout::bvh2 &&
                         !structure.copiesInstances;
  if (!hasLevels) return scene.primitives.size();
  const scene::StoredPrimitives stored(scene.primitives);
  const std::span<const scene::PrimitiveRun> runs = scene.primitives.runs();
  std::uint64_t size = 0;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (stored.isFirst(run) || !isInstance(scene, runs[run])) size += scene.primitives.countOf(runs[run]);
  }
  return size;
}

bool isMostlyPixels(const MemoryNeed& need) { return need.pixels() > need.scene + need.structure; }

std::string remedyFor(const MemoryNeed& need) {
  if (!isMostlyPixels(need)) return "render fewer primitives";
  return fmt::format("render a smaller image ({}), or windows of it ({}), whose films `candela merge` adds",
                     settingWords("size"), settingWords("crop"));
}

}  // namespace

MemoryNeed memoryNeedOf(const scene::Scene& scene, const render::ImageSettings& image,
                        const render::StructureSettings& structure, bool makesPictures) {
  const render::Window window = image.window();
  const std::uint64_t pixels = std::uint64_t{window.width} * window.height;
  MemoryNeed need;
  need.scene = scene::memoryOf(scene).total;
  need.structure = structureSize(scene, structure) * kBuildBytesPerPrimitive;
  const std::uint64_t layerRows = image::layerRowCount(image::layerSumsOf(image.layers));
  need.film = pixels * (sizeof(image::FilmPixel) + layerRows * sizeof(image::LayerRow));
  const std::uint64_t layerBytes = 2 * layerRows * sizeof(float);
  if (makesPictures) need.pictures = pixels * (kPictureBytesPerPixel + layerBytes);
  return need;
}

void requireMemoryForRender(const scene::Scene& scene, const render::ImageSettings& image,
                            const render::StructureSettings& structure, bool makesPictures) {
  const MemoryNeed need = memoryNeedOf(scene, image, structure, makesPictures);
  const render::Extent size = image.window().extent();
  requireMemory(fmt::format("{}: rendering {} primitives to {}x{} pixels", scene.name, scene.primitives.size(),
                            size.width, size.height),
                need.total(), remedyFor(need));
}

}  // namespace candela::job
