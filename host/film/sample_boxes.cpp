// Sweeps over the edges of boxes: from the top band by band, in each from the left run by run.
#include "host/film/sample_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "host/core/errors.h"

namespace candela::film {
namespace {

using render::SampleRange;
using render::Window;
using Ranges = std::vector<SampleRange>;

/// Columns x .. end - 1 that have the same samples.
struct Run {
  std::uint32_t x, end;
  Ranges ranges;

  bool operator==(const Run&) const = default;
};

/// Rows y .. end - 1 that have the same runs.
struct Band {
  std::uint32_t y, end;
  std::vector<Run> runs;
};

std::vector<std::uint32_t> sortedEdges(std::vector<std::uint32_t> edges) {
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::uint32_t> columnEdges(std::span<const SampleBox> boxes) {
  std::vector<std::uint32_t> edges;
  for (const auto& [window, samples] : boxes) edges.insert(edges.end(), {window.x, window.x + window.width});
  return sortedEdges(std::move(edges));
}

std::vector<std::uint32_t> rowEdges(std::span<const SampleBox> boxes) {
  std::vector<std::uint32_t> edges;
  for (const auto& [window, samples] : boxes) edges.insert(edges.end(), {window.y, window.y + window.height});
  return sortedEdges(std::move(edges));
}

// In rising order, with ranges that touch each other joined.
Ranges joined(Ranges ranges) {
  std::ranges::sort(ranges, {}, &SampleRange::first);
  Ranges result;
  for (const SampleRange& range : ranges) {
    if (!result.empty() && range.first < result.back().end) throw UsageError("two boxes of samples overlap");
    if (!result.empty() && range.first == result.back().end) {
      result.back().end = range.end;
    } else {
      result.push_back(range);
    }
  }
  return result;
}

// Returns the parts of `whole` that `ranges`, which are in ascending order, do not cover.
Ranges complement(const Ranges& ranges, const SampleRange& whole) {
  Ranges result;
  std::uint32_t next = whole.first;
  for (const SampleRange& range : ranges) {
    if (range.first > next) result.push_back({next, range.first});
    next = range.end;
  }
  if (next < whole.end) result.push_back({next, whole.end});
  return result;
}

void append(std::vector<Run>& runs, Run run) {
  if (run.ranges.empty()) return;
  if (!runs.empty() && runs.back().end == run.x && runs.back().ranges == run.ranges) {
    runs.back().end = run.end;
  } else {
    runs.push_back(std::move(run));
  }
}

void append(std::vector<Band>& bands, Band band) {
  if (band.runs.empty()) return;
  if (!bands.empty() && bands.back().end == band.y && bands.back().runs == band.runs) {
    bands.back().end = band.end;
  } else {
    bands.push_back(std::move(band));
  }
}

bool covers(std::uint32_t first, std::uint32_t size, std::uint32_t at) { return at >= first && at - first < size; }

// The runs of boxes that share their rows; `select` maps the ranges of a run to those that count.
std::vector<Run> runsOf(std::span<const SampleBox> boxes, const std::function<Ranges(Ranges)>& select) {
  std::vector<Run> runs;
  const std::vector<std::uint32_t> edges = columnEdges(boxes);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    Ranges ranges;
    for (const auto& [window, samples] : boxes) {
      if (covers(window.x, window.width, edges[i])) ranges.push_back(samples);
    }
    append(runs, {edges[i], edges[i + 1], select(std::move(ranges))});
  }
  return runs;
}

std::vector<SampleBox> sweep(std::span<const SampleBox> boxes, const std::function<Ranges(Ranges)>& select) {
  std::vector<Band> bands;
  const std::vector<std::uint32_t> edges = rowEdges(boxes);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    std::vector<SampleBox> active;
    for (const SampleBox& box : boxes) {
      if (covers(box.window.y, box.window.height, edges[i])) active.push_back(box);
    }
    append(bands, {edges[i], edges[i + 1], runsOf(active, select)});
  }
  std::vector<SampleBox> result;
  for (const Band& band : bands) {
    for (const Run& run : band.runs) {
      const Window window{run.x, band.y, run.end - run.x, band.end - band.y};
      for (const SampleRange& range : run.ranges) result.push_back({window, range});
    }
  }
  return result;
}

bool overlap(std::uint32_t a, std::uint32_t aEnd, std::uint32_t b, std::uint32_t bEnd) { return a < bEnd && b < aEnd; }

}  // namespace

bool overlap(const SampleBox& a, const SampleBox& b) {
  const Window& v = a.window;
  const Window& w = b.window;
  return overlap(v.x, v.x + v.width, w.x, w.x + w.width) && overlap(v.y, v.y + v.height, w.y, w.y + w.height) &&
         overlap(a.samples.first, a.samples.end, b.samples.first, b.samples.end);
}

std::vector<SampleBox> canonicalBoxes(std::span<const SampleBox> boxes) { return sweep(boxes, joined); }

std::vector<SampleBox> missingBoxes(std::span<const SampleBox> boxes, const SampleBox& whole) {
  // The whole is part of the sweep because of its edges; its range, which no box has, is then removed again.
  constexpr SampleRange kMark{0xffffffffu, 0xffffffffu};
  std::vector<SampleBox> all(boxes.begin(), boxes.end());
  all.push_back({whole.window, kMark});
  return sweep(all, [&](Ranges ranges) {
    std::erase(ranges, kMark);
    return complement(joined(std::move(ranges)), whole.samples);
  });
}

std::string boxText(const SampleBox& box) {
  return fmt::format("samples {}:{} of crop {}", box.samples.first, box.samples.end, render::windowText(box.window));
}

}  // namespace candela::film
