// Counts coincident primitives for each pair of objects.
#include "host/scene/coincidence/coincident_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <compare>
#include <map>
#include <utility>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/object_names.h"

namespace candela::scene {
namespace {

using Pair = Coincidences::Pair;

// Consecutive primitives from `first`, which count for a pair of objects.
struct Entry {
  std::size_t firstObject, secondObject;
  std::uint32_t first;
  std::uint32_t count = 1;

  auto operator<=>(const Entry&) const = default;
};

std::string plural(const std::string& noun) { return noun + (noun.ends_with('x') ? "es" : "s"); }

std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}", count, count == 1 ? noun : plural(noun));
}

std::string counted(std::uint64_t count, const char* word, const std::string& noun) {
  return fmt::format("{} {} {}", count, word, count == 1 ? noun : plural(noun));
}

class Counting {
 public:
  explicit Counting(const Scene& scene) : scene_(scene) {}

  // Counts primitives a and b, a < b, for their objects in one of the two counts.
  void count(const std::vector<Pair>& primitives, CoincidentObjects::Count CoincidentObjects::*counts) {
    countEntries(primitives, counts, [](std::uint32_t primitive) { return std::pair(primitive, 1u); });
  }

  // Counts the primitives of runs that are copies.
  void countRuns(const std::vector<Pair>& runs) {
    countEntries(runs, &CoincidentObjects::copies, [&](std::uint32_t index) {
      const PrimitiveRun& run = scene_.primitives.runs()[index];
      return std::pair(run.first, scene_.primitives.countOf(run));
    });
  }

  std::vector<CoincidentObjects> take() {
    std::vector<CoincidentObjects> result;
    for (auto& [pair, objects] : pairs_) {
      objects.first = objectName(scene_, pair.first);
      objects.second = objectName(scene_, pair.second);
      objects.isOne = pair.first == pair.second;
      result.push_back(std::move(objects));
    }
    std::ranges::stable_sort(result, std::greater(),
                             [](const CoincidentObjects& o) { return o.copies.second + o.overlaps.second; });
    return result;
  }

 private:
  // `rangeOf` returns the first primitive of an element of a pair, and their number.
  template <class RangeOf>
  void countEntries(const std::vector<Pair>& pairs, CoincidentObjects::Count CoincidentObjects::*counts,
                    const RangeOf& rangeOf) {
    std::vector<Entry> firsts, seconds;
    for (const auto& [a, b] : pairs) {
      const auto [first, firstCount] = rangeOf(a);
      const auto [second, secondCount] = rangeOf(b);
      const std::size_t firstObject = objectOf(scene_, first), secondObject = objectOf(scene_, second);
      firsts.push_back({firstObject, secondObject, first, firstCount});
      seconds.push_back({firstObject, secondObject, second, secondCount});
    }
    countEach(firsts, counts, &CoincidentObjects::Count::first, &CoincidentObjects::firstNoun);
    countEach(seconds, counts, &CoincidentObjects::Count::second, &CoincidentObjects::secondNoun);
  }

  void countEach(std::vector<Entry>& entries, CoincidentObjects::Count CoincidentObjects::*counts,
                 std::uint64_t CoincidentObjects::Count::*side, std::string CoincidentObjects::*noun) {
    std::ranges::sort(entries);
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    for (const Entry& entry : entries) {
      CoincidentObjects& objects = pairs_[{entry.firstObject, entry.secondObject}];
      objects.*counts.*side += entry.count;
      const std::string kind = kindName(scene_.primitives[entry.first].kind);
      objects.*noun = (objects.*noun).empty() || objects.*noun == kind ? kind : "primitive";
    }
  }

  const Scene& scene_;
  std::map<std::pair<std::size_t, std::size_t>, CoincidentObjects> pairs_;
};

// Returns the number of different primitives in all pairs.
std::uint64_t primitiveCountOf(const Scene& scene, const Coincidences& coincidences) {
  std::vector<Pair> ranges;  // from an index to another one, exclusive
  for (const auto* const pairs : {&coincidences.copies, &coincidences.overlaps}) {
    for (const auto& [a, b] : *pairs) ranges.insert(ranges.end(), {{a, a + 1}, {b, b + 1}});
  }
  for (const auto& [a, b] : coincidences.copiedRuns) {
    for (const std::uint32_t index : {a, b}) {
      const PrimitiveRun& run = scene.primitives.runs()[index];
      ranges.emplace_back(run.first, run.first + scene.primitives.countOf(run));
    }
  }
  std::ranges::sort(ranges);
  std::uint64_t count = 0;
  std::uint32_t counted = 0;
  for (const auto& [begin, end] : ranges) {
    if (end <= counted) continue;
    count += end - std::max(begin, counted);
    counted = end;
  }
  return count;
}

}  // namespace

CoincidenceReport coincidentObjects(const Scene& scene) {
  const Coincidences coincidences = findCoincidences(scene);
  Counting counting(scene);
  counting.count(coincidences.copies, &CoincidentObjects::copies);
  counting.countRuns(coincidences.copiedRuns);
  counting.count(coincidences.overlaps, &CoincidentObjects::overlaps);
  CoincidenceReport report{counting.take(), std::nullopt};
  if (!coincidences.truncated) report.primitiveCount = primitiveCountOf(scene, coincidences);
  return report;
}

std::string toText(const CoincidentObjects& o) {
  const auto [copies, overlaps] = std::pair(o.copies.second, o.overlaps.second);
  const auto others = [&](std::uint64_t count) {
    if (o.isOne) return fmt::format("{} of the same object", counted(count, "other", o.firstNoun));
    const char* const another = o.first == o.second ? "another " : "";
    return fmt::format("{} of {}object {}", counted(count, o.firstNoun), another, o.first);
  };
  std::string text = fmt::format("{} of object {} ", counted(copies > 0 ? copies : overlaps, o.secondNoun), o.second);
  if (copies > 0) text += fmt::format("{} with {}", copies == 1 ? "coincides" : "coincide", others(o.copies.first));
  if (overlaps == 0) return text;
  const char* const verb = overlaps == 1 ? "overlaps" : "overlap";
  if (copies == 0) return text + fmt::format("{} {} in one plane", verb, others(o.overlaps.first));
  return text + fmt::format(", and {} {} {} in one plane", counted(overlaps, o.secondNoun), verb,
                            counted(o.overlaps.first, o.firstNoun));
}

std::vector<std::string> linesOf(const CoincidenceReport& report) {
  constexpr std::size_t kListedPairs = 8;
  std::vector<std::string> lines;
  const std::size_t count = report.pairs.size();
  if (!report.primitiveCount) {
    lines.emplace_back(
        "the search for surfaces that overlap in one plane ended after too many comparisons; only equal surfaces are "
        "listed");
  } else if (count > 1) {
    lines.push_back(fmt::format("{} in {} pairs of objects", counted(*report.primitiveCount, "primitive"), count));
  }
  for (std::size_t i = 0; i < std::min(count, kListedPairs); ++i) lines.push_back(toText(report.pairs[i]));
  if (count > kListedPairs)
    lines.push_back(fmt::format("and {} more pairs, which the report in JSON lists", count - kListedPairs));
  return lines;
}

}  // namespace candela::scene
