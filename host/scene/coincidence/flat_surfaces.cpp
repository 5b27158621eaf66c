// Collects flat surfaces on several threads.
#include "host/scene/coincidence/flat_surfaces.h"

#include "host/base/run_on_threads.h"

namespace candela::scene {
namespace {

constexpr std::uint32_t kNone = ~0u;

}  // namespace

FlatSurfaces::FlatSurfaces(const Scene& scene, const StoredPrimitives& stored, std::span<const std::uint32_t> firstCopy,
                           std::uint32_t threadCount) {
  std::vector<std::size_t> first(firstCopy.size() + 1);  // index of the first part of each primitive
  std::size_t count = 0;
  const std::span<const PrimitiveRun> runs = scene.primitives.runs();
  for (std::size_t run = 0; run < runs.size(); ++run) {
    if (!stored.isFirst(run)) continue;
    const PrimitiveKind kind = runs[run].start.kind;
    const bool isFinite = !runs[run].start.isPlaced() && kind != PrimitiveKind::plane;
    for (std::uint32_t i = 0; i < scene.primitives.countOf(runs[run]); ++i) {
      const std::uint32_t number = stored.firstOf(run) + i;
      first[number] = count;
      if (firstCopy[number] != number || runs[run].start.isPlaced()) continue;
      if (isFinite) {
        count += flatPartCount(kind);
      } else {
        infinite_.emplace_back();
        storeFlatParts(shapeOf(scene, runs[run].at(runs[run].first + i)), runs[run].first + i,
                       std::span(infinite_).last(1));
      }
    }
  }
  first.back() = count;
  surfaces_ = std::make_unique_for_overwrite<FlatSurface[]>(count);
  boxes_.resize(count, {{}, {}, kNone});
  forEachBlock(threadCount, firstCopy.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      if (first[i] == first[i + 1]) continue;
      const std::uint32_t primitive = stored.primitiveOf(static_cast<std::uint32_t>(i));
      store(shapeOf(scene, scene.primitives[primitive]), primitive,
            std::span(&surfaces_[first[i]], first[i + 1] - first[i]), first[i]);
    }
  });
  std::erase_if(boxes_, [](const ItemBox& box) { return box.item == kNone; });
}

void FlatSurfaces::store(const Shape& shape, std::uint32_t primitive, std::span<FlatSurface> parts, std::size_t first) {
  const std::size_t count = storeFlatParts(shape, primitive, parts);
  for (std::size_t i = 0; i < count; ++i) {
    boxes_[first + i] = boxOf(parts[i], static_cast<std::uint32_t>(first + i));
  }
}

}  // namespace candela::scene
