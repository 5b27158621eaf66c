// Puts counts of ids into slots, and checks them when they are read.
#include "host/job/film/film_mattes.h"

#include <algorithm>
#include <functional>
#include <set>

#include "host/base/errors.h"

namespace candela::film {
namespace {

[[noreturn]] void refuse() { throw FileError("the mattes of a pixel do not match its samples"); }

// The ids that pixels may have.
std::set<std::uint32_t> knownIds(const std::vector<std::string>& names) {
  std::set<std::uint32_t> ids{image::kNoId};
  for (const std::string& name : names) ids.insert(image::matteId(name));
  return ids;
}

image::IdCounts countsIn(std::span<const std::uint32_t> slots) {
  image::IdCounts counts;
  for (std::size_t i = 0; i < slots.size(); i += 2) {
    if (slots[i + 1] > 0) counts.push_back({slots[i], slots[i + 1]});
  }
  return counts;
}

// Requires counts by rising ids in the first slots, zeros in the others, and as many samples as the pixel has.
void check(std::span<const std::uint32_t> slots, const image::IdCounts& counts, std::uint32_t sampleCount,
           const std::set<std::uint32_t>& known) {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < slots.size() / 2; ++i) {
    const bool isUsed = i < counts.size();
    if (slots[2 * i] != (isUsed ? counts[i].id : 0) || (slots[2 * i + 1] > 0) != isUsed) refuse();
    sum += slots[2 * i + 1];
  }
  const auto isKnown = [&](const image::IdCount& entry) { return known.contains(entry.id); };
  const bool rises = std::ranges::adjacent_find(counts, std::greater_equal{}, &image::IdCount::id) == counts.end();
  if (sum != sampleCount || !rises || !std::ranges::all_of(counts, isKnown)) refuse();
}

}  // namespace

std::vector<std::uint32_t> matteWords(const image::Film& film, std::size_t firstPixel, std::size_t pixels,
                                      const ChannelChoice& choice) {
  std::vector<std::uint32_t> words(2 * choice.slotCount() * pixels);
  std::size_t before = 0;
  for (const image::MatteKind kind : image::kMatteKinds) {
    for (std::size_t i = 0; !film.ids(kind).empty() && i < pixels; ++i) {
      auto word = words.begin() + static_cast<std::ptrdiff_t>(2 * (i * choice.slotCount() + before));
      for (const image::IdCount& entry : film.ids(kind)[firstPixel + i]) {
        *word++ = entry.id;
        *word++ = entry.count;
      }
    }
    before += choice.matteSlots[static_cast<std::size_t>(kind)];
  }
  return words;
}

MatteRows mattesOf(std::span<const std::uint32_t> words, std::span<const image::FilmPixel> pixels,
                   const FilmHeader& header) {
  MatteRows rows;
  const std::size_t step = 2 * channelsOf(header).slotCount();
  std::size_t before = 0;
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto index = static_cast<std::size_t>(kind);
    if (!hasMatte(header.layers, kind)) continue;
    const std::set<std::uint32_t> known = knownIds(header.matteNames[index]);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const auto slots = words.subspan(i * step + before, 2 * header.matteSlots[index]);
      rows[index].push_back(countsIn(slots));
      check(slots, rows[index].back(), pixels[i].sampleCount, known);
    }
    before += 2 * header.matteSlots[index];
  }
  return rows;
}

std::array<std::uint32_t, image::kMatteKinds.size()> slotsOf(const image::Film& film) {
  std::array<std::uint32_t, image::kMatteKinds.size()> slots{};
  for (const image::MatteKind kind : image::kMatteKinds) {
    auto& max = slots[static_cast<std::size_t>(kind)];
    for (const image::IdCounts& counts : film.ids(kind)) max = std::max(max, static_cast<std::uint32_t>(counts.size()));
  }
  return slots;
}

}  // namespace candela::film
