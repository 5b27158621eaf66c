// Sweeps over the edges of boxes: from the top band by band, in each from the left run by run.
#include "host/job/film/sample_boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "host/base/errors.h"

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

std::vector<std::uint32_t> sortedSet(std::vector<std::uint32_t> edges) {
  std::ranges::sort(edges);
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<std::uint32_t> columnEdges(std::span<const SampleBox> boxes) {
  std::vector<std::uint32_t> edges;
  for (const auto& [window, samples] : boxes) edges.insert(edges.end(), {window.x, window.x + window.width});
  return sortedSet(std::move(edges));
}

std::vector<std::uint32_t> rowEdges(std::span<const SampleBox> boxes) {
  std::vector<std::uint32_t> edges;
  for (const auto& [window, samples] : boxes) edges.insert(edges.end(), {window.y, window.y + window.height});
  return sortedSet(std::move(edges));
}

// The work that is left. A set can be so divided that its list takes more time and memory than any file warrants.
class Budget {
 public:
  explicit Budget(std::uint64_t steps) : steps_(steps) {}

  void take(std::uint64_t steps) {
    if (steps > steps_) throw FileError("the samples are divided into boxes of too many different edges");
    steps_ -= steps;
  }

 private:
  std::uint64_t steps_;
};

void requireFewer(std::size_t boxes) {
  if (boxes > kMaxResultBoxes) {
    throw FileError(fmt::format("the samples are divided into more than {} boxes", kMaxResultBoxes));
  }
}

std::uint32_t firstOf(const SampleBox& box) { return box.samples.first; }

// Joins ranges that touch each other. The boxes are in ascending order of their ranges.
Ranges joined(std::span<const SampleBox> boxes) {
  Ranges result;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const SampleRange& range = boxes[i].samples;
    if (i > 0 && range.first < boxes[i - 1].samples.end) throw OverlapError(boxes[i - 1], boxes[i]);
    if (i > 0 && range.first == result.back().end) {
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

// Appends the boxes of the previous band to the result, unless the next band continues it.
void append(std::vector<SampleBox>& result, Band& previous, Band next) {
  if (previous.end == next.y && previous.runs == next.runs) {
    previous.end = next.end;
    return;
  }
  for (const Run& run : previous.runs) {
    const Window window{run.x, previous.y, run.end - run.x, previous.end - previous.y};
    for (const SampleRange& range : run.ranges) result.push_back({window, range});
  }
  requireFewer(result.size());
  previous = std::move(next);
}

// Maps the joined ranges of an interval of columns to those that count.
using Select = std::function<Ranges(Ranges)>;

// Returns the runs of boxes that share their rows.
std::vector<Run> runsOf(std::vector<SampleBox> boxes, const Select& select, Budget& budget) {
  std::ranges::sort(boxes, {}, [](const SampleBox& box) { return std::pair(box.window.x, box.samples.first); });
  const std::vector<std::uint32_t> edges = columnEdges(boxes);
  std::vector<Run> runs;
  std::vector<SampleBox> open;
  std::size_t rangeCount = 0;
  auto next = boxes.begin();
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    std::erase_if(open, [&](const SampleBox& box) { return box.window.x + box.window.width <= edges[i]; });
    const auto middle = static_cast<std::ptrdiff_t>(open.size());
    for (; next != boxes.end() && next->window.x == edges[i]; ++next) open.push_back(*next);
    std::ranges::inplace_merge(open, open.begin() + middle, {}, firstOf);
    budget.take(1 + open.size());
    const std::size_t runCount = runs.size();
    append(runs, {edges[i], edges[i + 1], select(joined(open))});
    if (runs.size() > runCount) requireFewer(rangeCount += runs.back().ranges.size());
  }
  return runs;
}

std::vector<SampleBox> sweep(std::vector<SampleBox> boxes, const Select& select, Budget budget) {
  std::ranges::sort(boxes, {}, [](const SampleBox& box) { return box.window.y; });
  const std::vector<std::uint32_t> edges = rowEdges(boxes);
  std::vector<SampleBox> result;
  Band previous;
  std::vector<SampleBox> active;
  auto next = boxes.begin();
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    std::erase_if(active, [&](const SampleBox& box) { return box.window.y + box.window.height <= edges[i]; });
    for (; next != boxes.end() && next->window.y == edges[i]; ++next) active.push_back(*next);
    budget.take(1 + active.size());
    append(result, previous, {edges[i], edges[i + 1], runsOf(active, select, budget)});
  }
  append(result, previous, {});
  return result;
}

}  // namespace

std::vector<SampleBox> canonicalBoxes(std::span<const SampleBox> boxes) {
  return sweep({boxes.begin(), boxes.end()}, std::identity{}, Budget(kMaxBoxSteps));
}

// A canonical list of n boxes in b bands and r runs takes at most b + 2r + 2n steps, with the gaps between them.
bool isCanonical(std::span<const SampleBox> boxes) try {
  constexpr std::uint64_t kStepsPerBox = 5;
  return std::ranges::equal(sweep({boxes.begin(), boxes.end()}, std::identity{}, Budget(kStepsPerBox * boxes.size())),
                            boxes);
} catch (const Error&) {
  return false;
}

void requireDisjoint(std::span<const SampleBox> boxes) {
  const auto nothing = [](const Ranges&) { return Ranges{}; };
  sweep({boxes.begin(), boxes.end()}, nothing, Budget(kMaxBoxSteps));
}

std::vector<SampleBox> missingBoxes(std::span<const SampleBox> boxes, const SampleBox& whole) {
  // The whole is part of the sweep because of its edges; its range, which no box has, is then removed again.
  constexpr SampleRange kMark{0xffffffffu, 0xffffffffu};
  std::vector<SampleBox> all(boxes.begin(), boxes.end());
  all.push_back({whole.window, kMark});
  const auto select = [&](Ranges ranges) {
    std::erase(ranges, kMark);
    return complement(ranges, whole.samples);
  };
  return sweep(std::move(all), select, Budget(kMaxBoxSteps));
}

std::string boxText(const SampleBox& box) {
  return fmt::format("samples {}:{} of crop {}", box.samples.first, box.samples.end, render::windowText(box.window));
}

}  // namespace candela::film
