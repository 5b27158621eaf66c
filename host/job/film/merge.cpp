// Reads all headers, checks that the films fit together, and then adds one film after the other.
#include "host/job/film/merge.h"

#include <algorithm>
#include <new>
#include <span>

#include "host/base/errors.h"
#include "host/job/film/film_memory.h"
#include "host/job/film/merge_checks.h"

namespace candela::film {
namespace {

std::vector<MergePart> readHeaders(std::span<const std::filesystem::path> files) {
  std::vector<MergePart> parts;
  for (const std::filesystem::path& file : files) {
    const FilmReader reader(file);
    parts.push_back({file, reader.header(), reader.check()});
  }
  return parts;
}

render::Window unionOf(const render::Window& a, const render::Window& b) {
  const std::uint32_t x = std::min(a.x, b.x);
  const std::uint32_t y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x, std::max(a.y + a.height, b.y + b.height) - y};
}

template <class T>
void sortIntoSet(std::vector<T>& items) {
  std::ranges::sort(items);
  items.erase(std::unique(items.begin(), items.end()), items.end());
}

FilmHeader mergedHeader(const std::vector<MergePart>& parts) {
  FilmHeader merged = parts.front().header;
  for (const MergePart& part : std::span(parts).subspan(1)) {
    const FilmHeader& header = part.header;
    merged.window = unionOf(merged.window, header.window);
    merged.covered.insert(merged.covered.end(), header.covered.begin(), header.covered.end());
    merged.begun.insert(merged.begun.end(), header.begun.begin(), header.begun.end());
    merged.tracers.insert(merged.tracers.end(), header.tracers.begin(), header.tracers.end());
    merged.mixed.insert(merged.mixed.end(), header.mixed.begin(), header.mixed.end());
    for (std::size_t i = 0; i < merged.matteNames.size(); ++i) {
      merged.matteNames[i].insert(merged.matteNames[i].end(), header.matteNames[i].begin(), header.matteNames[i].end());
    }
  }
  for (std::vector<std::string>& names : merged.matteNames) sortIntoSet(names);
  merged.covered = canonicalBoxes(merged.covered);
  merged.begun = canonicalBoxes(merged.begun);
  sortIntoSet(merged.tracers);
  sortIntoSet(merged.mixed);
  return merged;
}

void addMattes(const FilmRows& rows, std::size_t pixel, image::Film& film, std::uint32_t x, std::uint32_t y) {
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto& ids = rows.ids[static_cast<std::size_t>(kind)];
    if (!ids.empty()) image::addIds(film.idsAt(kind, x, y), ids[pixel]);
  }
}

void add(const MergePart& part, MergedFilm& merged) {
  FilmReader reader(part.file);
  if (reader.check() != part.check) throw FileError(part.file.string() + ": the file has changed in the meantime");
  const render::Window& from = part.header.window;
  const std::uint32_t left = from.x - merged.header.window.x;
  const std::uint32_t top = from.y - merged.header.window.y;
  const std::size_t step = image::layerRowCount(image::layerSumsOf(part.header.layers));
  reader.forEachBlock([&](const FilmRows& rows) {
    for (std::size_t i = 0; i < rows.pixels.size(); ++i) {
      const auto x = left + static_cast<std::uint32_t>(i % from.width);
      const auto y = top + rows.first + static_cast<std::uint32_t>(i / from.width);
      image::addSums(merged.film.at(x, y), rows.pixels[i]);
      image::addLayerRows(merged.film.layerRowsAt(x, y), rows.layerRows.subspan(i * step, step));
      addMattes(rows, i, merged.film, x, y);
    }
  });
  merged.work.add(readWork(part.file, part.check));
}

}  // namespace

MergedFilm mergeFilms(std::span<const std::filesystem::path> files, const MergeOptions& options) try {
  const std::vector<MergePart> parts = readHeaders(files);
  requireFitting(parts, options);
  MergedFilm merged;
  merged.header = mergedHeader(parts);
  requireReadable(merged.header);
  merged.missing = missingBoxes(allBoxes(merged.header),
                                {render::windowOf(merged.header.size), {0, merged.header.samplesPerPixel}});
  if (!options.partial) requireWhole(parts, merged.missing);
  requireMemoryForFilm(merged.header.window.extent(), merged.header.layers);
  merged.film = image::Film(merged.header.window.width, merged.header.window.height, merged.header.layers,
                            merged.header.filmScale());
  for (const MergePart& part : parts) add(part, merged);
  return merged;
} catch (const std::bad_alloc&) {
  throw OutOfMemoryError("the merged film does not fit into memory");
}

}  // namespace candela::film
