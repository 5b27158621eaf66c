// Fills the cells: primitives are distributed to slabs of cells, then each slab is sorted by counting. All passes run
// in parallel and preserve the order of the primitives for any number of threads.
#include "host/trace/accel/grid.h"

#include <fmt/format.h>

#include <numeric>

#include "host/base/divide_up.h"
#include "host/base/errors.h"
#include "host/base/run_on_threads.h"
#include "host/trace/accel/task_pool.h"

namespace candela::accel {
namespace {

constexpr std::size_t kMaxGridPrimitives = std::size_t{1} << 27;
constexpr std::size_t kChunk = std::size_t{1} << 15;  // primitives per task
constexpr std::uint32_t kMaxSlabs = 256;              // number of write streams for which caches are sufficient
constexpr double kCoarser = 0.8;                      // factor by which the density is lowered if the grid is too fine

// A primitive on its way into cells. The indices of the block fit into 16 bits, see kMaxCellsPerAxis.
struct Entry {
  std::uint32_t primitive;
  std::array<std::uint16_t, 3> low;
  std::array<std::uint16_t, 3> high;
};
static_assert(sizeof(Entry) == 16);

Entry makeEntry(std::uint32_t primitive, const CellBlock& block) {
  Entry entry{primitive, {}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    entry.low[axis] = static_cast<std::uint16_t>(block.low[axis]);
    entry.high[axis] = static_cast<std::uint16_t>(block.high[axis]);
  }
  return entry;
}

struct Tally {
  std::uint64_t entries = 0;
  std::uint64_t references = 0;
};

class GridBuilder {
 public:
  GridBuilder(std::span<const Aabb> bounds, const GridOptions& options)
      : bounds_(bounds), options_(options), pool_(threadCount(options, bounds.size())) {}

  Grid build() {
    chooseShape(uniteBounds());
    deal();
    grid_.starts.resize(grid_.shape.cellCount() + 1);
    grid_.starts.back() = static_cast<std::uint32_t>(slabs_.back().references);
    grid_.items.resize(slabs_.back().references);
    for (std::uint32_t slab = 0; slab < slabCount_; ++slab) pool_.submit([this, slab] { sortSlab(slab); });
    pool_.wait();
    return std::move(grid_);
  }

 private:
  static std::uint32_t threadCount(const GridOptions& options, std::size_t primitiveCount) {
    if (primitiveCount <= kChunk) return 1;
    return threadCountFor(options.threads);
  }

  std::size_t chunkCount() const { return divideUp(bounds_.size(), kChunk); }

  // Calls body(chunk, first primitive, end) for every chunk.
  template <class Body>
  void forEachChunk(const Body& body) {
    for (std::size_t chunk = 0; chunk < chunkCount(); ++chunk) {
      const std::size_t first = chunk * kChunk, end = std::min(first + kChunk, bounds_.size());
      pool_.submit([&body, chunk, first, end] { body(chunk, first, end); });
    }
    pool_.wait();
  }

  Aabb uniteBounds() {
    std::vector<Aabb> united(chunkCount());
    forEachChunk([&](std::size_t chunk, std::size_t first, std::size_t end) {
      for (std::size_t i = first; i < end; ++i) {
        requireProper(bounds_[i], i, "grid");
        united[chunk].extend(bounds_[i]);
      }
    });
    return std::accumulate(united.begin(), united.end(), Aabb{},
                           [](Aabb all, const Aabb& box) { return all.extend(box), all; });
  }

  // Returns the finest grid, from the requested density downwards, that is within all limits. One cell always is.
  void chooseShape(const Aabb& box) {
    for (grid_.density = options_.density;; grid_.density *= kCoarser) {
      grid_.shape = gridShape(box, bounds_.size(), grid_.density);
      if (grid_.shape.cellCount() > maxGridCells(bounds_.size())) continue;
      if (grid_.shape.sides[grid_.shape.outermostAxis()] > options_.maxSide) continue;
      cutSlabs();
      if (census() <= maxGridReferences(bounds_.size())) return;
    }
  }

  // Slabs are layers of cells perpendicular to the outermost axis, which have consecutive indices.
  void cutSlabs() {
    outermost_ = grid_.shape.outermostAxis();
    const std::uint32_t layers = grid_.shape.sides[outermost_];
    slabLayers_ = divideUp(layers, kMaxSlabs);
    slabCount_ = divideUp(layers, slabLayers_);
  }

  std::uint32_t slabOf(std::uint32_t layer) const { return layer / slabLayers_; }

  // Counts the references of each chunk to each slab. Returns the number of all references.
  std::uint64_t census() {
    tallies_.assign(chunkCount() * slabCount_, {});
    forEachChunk([this](std::size_t chunk, std::size_t first, std::size_t end) {
      Tally* tallies = &tallies_[chunk * slabCount_];
      for (std::size_t i = first; i < end; ++i) countBlock(grid_.shape.cellsOf(bounds_[i]), tallies);
    });
    std::uint64_t references = 0;
    for (const Tally& tally : tallies_) references += tally.references;
    return references;
  }

  void countBlock(const CellBlock& block, Tally* tallies) const {
    const std::uint32_t low = block.low[static_cast<std::size_t>(outermost_)];
    const std::uint32_t high = block.high[static_cast<std::size_t>(outermost_)];
    const std::uint64_t perLayer = block.cellCount() / (high - low + 1);
    for (std::uint32_t layer = low; layer <= high;) {
      const std::uint32_t slab = slabOf(layer), next = std::min(high + 1, (slab + 1) * slabLayers_);
      ++tallies[slab].entries;
      tallies[slab].references += perLayer * (next - layer);
      layer = next;
    }
  }

  // Sorts entries by slab, and by primitive within a slab.
  void deal() {
    placeSlabs();
    entries_.resize(slabs_.back().entries);
    forEachChunk([this](std::size_t chunk, std::size_t first, std::size_t end) {
      Tally* places = &tallies_[chunk * slabCount_];
      for (std::size_t i = first; i < end; ++i) {
        const Entry entry = makeEntry(static_cast<std::uint32_t>(i), grid_.shape.cellsOf(bounds_[i]));
        const auto axis = static_cast<std::size_t>(outermost_);
        const std::uint32_t low = slabOf(entry.low[axis]), high = slabOf(entry.high[axis]);
        for (std::uint32_t slab = low; slab <= high; ++slab) entries_[places[slab].entries++] = entry;
      }
    });
  }

  // Turns counts into positions: the start of each slab (and the end of the last), and of each chunk within it.
  void placeSlabs() {
    slabs_.assign(1, {});
    Tally sum;
    for (std::uint32_t slab = 0; slab < slabCount_; ++slab) {
      for (std::size_t chunk = 0; chunk < chunkCount(); ++chunk) {
        Tally& tally = tallies_[chunk * slabCount_ + slab];
        const Tally counted = tally;
        tally.entries = sum.entries;
        sum.entries += counted.entries;
        sum.references += counted.references;
      }
      slabs_.push_back(sum);
    }
  }

  void sortSlab(std::uint32_t slab) {
    const std::span<const Entry> entries = std::span(entries_).subspan(slabs_[slab].entries,
                                                                       slabs_[slab + 1].entries - slabs_[slab].entries);
    const std::uint32_t firstLayer = slab * slabLayers_;
    const std::uint32_t endLayer = std::min(firstLayer + slabLayers_, grid_.shape.sides[outermost_]);
    const std::uint32_t stride = grid_.shape.strides[outermost_];
    const auto forEachCell = [&](const Entry& entry, auto&& visit) {
      CellBlock block{{entry.low[0], entry.low[1], entry.low[2]}, {entry.high[0], entry.high[1], entry.high[2]}};
      const auto axis = static_cast<std::size_t>(outermost_);
      block.low[axis] = std::max(block.low[axis], firstLayer);
      block.high[axis] = std::min(block.high[axis], endLayer - 1);
      forEachCellOf(block, visit);
    };
    for (const Entry& entry : entries) forEachCell(entry, [&](std::uint32_t cell) { ++grid_.starts[cell]; });
    auto end = static_cast<std::uint32_t>(slabs_[slab].references);
    for (std::uint32_t cell = firstLayer * stride; cell < endLayer * stride; ++cell) {
      end += grid_.starts[cell];
      grid_.starts[cell] = end;
    }
    // Runs backwards: the end of each cell moves down to its start, and its items become ascending.
    for (std::size_t i = entries.size(); i-- > 0;) {
      const Entry& entry = entries[i];
      forEachCell(entry, [&](std::uint32_t cell) { grid_.items[--grid_.starts[cell]] = entry.primitive; });
    }
  }

  template <class Visit>
  void forEachCellOf(const CellBlock& block, Visit&& visit) const {
    const glm::uvec3& strides = grid_.shape.strides;
    for (std::uint32_t z = block.low[2]; z <= block.high[2]; ++z) {
      for (std::uint32_t y = block.low[1]; y <= block.high[1]; ++y) {
        const std::uint32_t row = z * strides.z + y * strides.y;
        for (std::uint32_t x = block.low[0]; x <= block.high[0]; ++x) visit(row + x * strides.x);
      }
    }
  }

  std::span<const Aabb> bounds_;
  const GridOptions& options_;
  Grid grid_;
  int outermost_ = 2;
  std::uint32_t slabLayers_ = 1;
  std::uint32_t slabCount_ = 1;
  std::vector<Tally> tallies_;  ///< [chunk][slab]: counts, then the position of the next entry
  std::vector<Tally>
      slabs_;  ///< start of the entries and of the references of each slab, with one entry more than slabs
  std::vector<Entry> entries_;
  TaskPool pool_;  ///< last member: its threads end before the data on which they work
};

}  // namespace

std::uint64_t maxGridCells(std::size_t primitiveCount) {
  constexpr std::uint64_t kPerPrimitive = 128, kMin = 1024;
  return std::min(kPerPrimitive * primitiveCount + kMin, std::uint64_t{1} << 30);
}

std::uint64_t maxGridReferences(std::size_t primitiveCount) {
  constexpr std::uint64_t kPerPrimitive = 64, kMin = 4096;
  return std::min(kPerPrimitive * primitiveCount + kMin, std::uint64_t{1} << 31);
}

Grid buildGrid(std::span<const Aabb> bounds, const GridOptions& options) {
  if (!(options.density > 0) || options.maxSide < 1) {
    throw InternalError(
        fmt::format("a grid of density {} and at most {} cells along an axis", options.density, options.maxSide));
  }
  if (bounds.size() > kMaxGridPrimitives) {
    throw InternalError(fmt::format("a grid over {} primitives; the maximum is {}", bounds.size(), kMaxGridPrimitives));
  }
  if (bounds.empty()) return {};
  return GridBuilder(bounds, options).build();
}

}  // namespace candela::accel
