// Counts coincident primitives for each pair of objects.
#include "host/scene/coincidence/coincident_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "host/scene/coincidence/coincidence.h"
#include "host/scene/object_names.h"

namespace candela::scene {
namespace {

// A primitive, and the pair of objects for which it counts.
using Entry = std::array<std::uint32_t, 3>;
using Pair = std::pair<std::uint32_t, std::uint32_t>;

std::vector<std::uint32_t> objectsOf(const Scene& scene) {
  std::vector<std::uint32_t> objects(scene.primitives.size(), 0);
  std::uint32_t object = 0;
  for (std::uint32_t i = 0; i < objects.size(); ++i) {
    while (object + 1 < scene.objectStarts.size() && scene.objectStarts[object + 1] <= i) ++object;
    objects[i] = object;
  }
  return objects;
}

std::string plural(const std::string& noun) { return noun + (noun.ends_with('x') ? "es" : "s"); }

std::string counted(std::uint64_t count, const std::string& noun) {
  return fmt::format("{} {}", count, count == 1 ? noun : plural(noun));
}

std::string counted(std::uint64_t count, const char* word, const std::string& noun) {
  return fmt::format("{} {} {}", count, word, count == 1 ? noun : plural(noun));
}

// Returns "node Floor", but "node.3" for a node without a name.
std::string named(const std::string& kind, const std::string& name) {
  return name.starts_with(kind + '.') ? name : fmt::format("{} {}", kind, name);
}

class Counting {
 public:
  explicit Counting(const Scene& scene) : scene_(scene), objects_(objectsOf(scene)) {}

  // Counts primitives a and b, a < b, for their objects in one of the two counts.
  void count(const std::vector<Pair>& primitives, CoincidentObjects::Count CoincidentObjects::*counts) {
    std::vector<Entry> entries;
    entries.reserve(primitives.size());
    for (const auto& [a, b] : primitives) entries.push_back({objects_[a], objects_[b], a});
    countEntries(entries, counts, &CoincidentObjects::Count::first, &CoincidentObjects::firstNoun);
    entries.clear();
    for (const auto& [a, b] : primitives) entries.push_back({objects_[a], objects_[b], b});
    countEntries(entries, counts, &CoincidentObjects::Count::second, &CoincidentObjects::secondNoun);
  }

  std::vector<CoincidentObjects> take() {
    std::vector<CoincidentObjects> result;
    for (auto& [pair, objects] : pairs_) {
      objects.first = objectName(scene_, pair.first);
      objects.second = objectName(scene_, pair.second);
      objects.isOne = pair.first == pair.second;
      objects.areNodes = !scene_.objectNames.empty();
      result.push_back(std::move(objects));
    }
    std::ranges::stable_sort(result, std::greater(),
                             [](const CoincidentObjects& o) { return o.copies.second + o.overlaps.second; });
    return result;
  }

 private:
  void countEntries(std::vector<Entry>& entries, CoincidentObjects::Count CoincidentObjects::*counts,
                    std::uint64_t CoincidentObjects::Count::*side, std::string CoincidentObjects::*noun) {
    std::ranges::sort(entries);
    entries.erase(std::unique(entries.begin(), entries.end()), entries.end());
    for (const auto& [first, second, primitive] : entries) {
      CoincidentObjects& objects = pairs_[{first, second}];
      ++(objects.*counts.*side);
      const std::string kind = kindName(scene_.primitives[primitive].kind);
      objects.*noun = (objects.*noun).empty() || objects.*noun == kind ? kind : "primitive";
    }
  }

  const Scene& scene_;
  std::vector<std::uint32_t> objects_;
  std::map<Pair, CoincidentObjects> pairs_;
};

std::vector<Pair> copiesIn(const Coincidences& coincidences) {
  std::vector<Pair> copies;
  for (std::uint32_t i = 0; i < coincidences.firstCopy.size(); ++i) {
    if (coincidences.firstCopy[i] != i) copies.emplace_back(coincidences.firstCopy[i], i);
  }
  return copies;
}

}  // namespace

CoincidenceReport coincidentObjects(const Scene& scene) {
  const Coincidences coincidences = findCoincidences(scene);
  Counting counting(scene);
  counting.count(copiesIn(coincidences), &CoincidentObjects::copies);
  counting.count(coincidences.overlaps, &CoincidentObjects::overlaps);
  CoincidenceReport report{counting.take(), std::nullopt};
  if (!coincidences.truncated) {
    report.primitiveCount = static_cast<std::uint64_t>(std::ranges::count(coincidences.coincident, true));
  }
  return report;
}

std::string toText(const CoincidentObjects& o) {
  const std::string kind = o.areNodes ? "node" : "object";
  const auto [copies, overlaps] = std::pair(o.copies.second, o.overlaps.second);
  const auto others = [&](std::uint64_t count) {
    if (o.isOne) return fmt::format("{} of the same {}", counted(count, "other", o.firstNoun), kind);
    const char* const another = o.first == o.second ? "another " : "";
    return fmt::format("{} of {}{}", counted(count, o.firstNoun), another, named(kind, o.first));
  };
  std::string text = fmt::format("{} of {} ", counted(copies > 0 ? copies : overlaps, o.secondNoun),
                                 named(kind, o.second));
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
