// Counts hits pixel by pixel.
#include "host/trace/device/hit_lists.h"

#include "shaders/shared/render_data.h"

namespace candela::device {
namespace {

void addHits(std::span<const std::uint32_t> list, image::MatteKind kind, std::uint32_t first, std::uint32_t sampleEnd,
             const scene::MatteIds& ids, image::IdCounts& counts) {
  for (std::uint32_t i = first; i < sampleEnd; ++i) {
    const std::uint32_t primitive = list[i % gpu::kListedHits];
    const std::uint32_t id = primitive >= gpu::kSeenThrough ? image::kNoId : ids.of(kind, primitive);
    addIds(counts, {id, 1});
  }
}

}  // namespace

void addListedHits(std::span<const std::uint32_t> lists, std::uint32_t firstRow, std::uint32_t firstSample,
                   const scene::MatteIds& ids, image::Film& film) {
  const std::size_t firstPixel = std::size_t{firstRow} * film.width();
  for (const image::MatteKind kind : image::kMatteKinds) {
    for (std::size_t i = 0; !film.ids(kind).empty() && i < lists.size() / gpu::kListedHits; ++i) {
      image::IdCounts& counts = film.ids(kind)[firstPixel + i];
      const std::uint32_t end = firstSample + film.pixels()[firstPixel + i].sampleCount;
      addHits(lists.subspan(i * gpu::kListedHits, gpu::kListedHits), kind, firstSample + sampleCountOf(counts), end,
              ids, counts);
    }
  }
}

}  // namespace candela::device
