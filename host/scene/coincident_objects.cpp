// Counts coincident primitives for each pair of objects.
#include "host/scene/coincident_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "host/scene/coincidence.h"
#include "host/scene/object_names.h"

namespace candela::scene {
namespace {

std::string counted(std::uint64_t count) { return fmt::format("{} primitive{}", count, count == 1 ? "" : "s"); }

}  // namespace

std::vector<CoincidentObjects> coincidentObjects(const Scene& scene) {
  const Coincidences coincidences = findCoincidences(scene);
  std::map<std::pair<std::size_t, std::size_t>, CoincidentObjects> pairs;
  const auto pairOf = [&](std::uint32_t a, std::uint32_t b) -> CoincidentObjects& {
    return pairs[{objectOf(scene, a), objectOf(scene, b)}];
  };
  for (std::uint32_t i = 0; i < coincidences.firstCopy.size(); ++i) {
    if (coincidences.firstCopy[i] != i) ++pairOf(coincidences.firstCopy[i], i).copies;
  }
  std::map<std::pair<std::size_t, std::size_t>, std::set<std::uint32_t>> overlapping;
  for (const auto& [a, b] : coincidences.overlaps) overlapping[{objectOf(scene, a), objectOf(scene, b)}].insert(b);
  for (const auto& [pair, primitives] : overlapping) pairs[pair].overlaps = primitives.size();

  std::vector<CoincidentObjects> result;
  for (auto& [pair, objects] : pairs) {
    objects.first = objectName(scene, pair.first);
    objects.second = objectName(scene, pair.second);
    result.push_back(std::move(objects));
  }
  std::ranges::stable_sort(result, std::greater(), [](const CoincidentObjects& o) { return o.copies + o.overlaps; });
  return result;
}

std::string toText(const CoincidentObjects& objects) {
  const std::string other = objects.first == objects.second ? "others of the same object" : objects.first;
  std::string text;
  if (objects.copies > 0)
    text = fmt::format("{} of {} coincide with {}", counted(objects.copies), objects.second, other);
  if (objects.overlaps == 0) return text;
  if (objects.copies > 0) return text + fmt::format("; {} overlap it in one plane", objects.overlaps);
  return fmt::format("{} of {} overlap {} in one plane", counted(objects.overlaps), objects.second, other);
}

}  // namespace candela::scene
