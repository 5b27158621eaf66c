// Reads all headers, checks that the films fit together, and then adds one film after the other.
#include "host/film/merge.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <span>

#include "host/core/errors.h"
#include "host/film/film_memory.h"

namespace candela::film {
namespace {

/// A film that is not open.
struct Part {
  std::filesystem::path file;
  FilmHeader header;
  std::string check;
};

std::vector<Part> readHeaders(std::span<const std::filesystem::path> files) {
  std::vector<Part> parts;
  for (const std::filesystem::path& file : files) {
    const FilmReader reader(file);
    parts.push_back({file, reader.header(), reader.check()});
  }
  return parts;
}

bool isReference(const Tracer& tracer) { return tracer.kernels == "reference"; }

// Devices may differ where mixedDevices is set, but never kernels and programs.
bool canMix(const Tracer& a, const Tracer& b) {
  return a.program == b.program && (a.kernels == b.kernels || isReference(a) || isReference(b));
}

void requireSameTracers(const Part& a, const Part& b, const MergeOptions& options) {
  for (const Tracer& x : a.header.tracers) {
    for (const Tracer& y : b.header.tracers) {
      if (x == y || (options.mixedDevices && canMix(x, y))) continue;
      const std::string remedy = canMix(x, y) ? "; --mixed-devices merges them nevertheless" : "";
      throw FileError(
          fmt::format("cannot merge: {}{}", tracerDifferences(x, y, a.file.string(), b.file.string()).front(), remedy));
    }
  }
}

void requireSameEstimate(const Part& a, const Part& b) {
  const std::vector<std::string> differences = estimateDifferences(a.header, b.header, a.file.string(),
                                                                   b.file.string());
  if (!differences.empty()) throw FileError("cannot merge: " + differences.front());
}

std::vector<SampleBox> allBoxes(const FilmHeader& header) {
  std::vector<SampleBox> boxes = header.covered;
  boxes.insert(boxes.end(), header.begun.begin(), header.begun.end());
  return boxes;
}

void requireMergeable(const Part& part) {
  if (!part.header.hasFirstStoppingRule()) return;
  throw FileError(fmt::format("cannot merge: {} was sampled with --noise-threshold by an earlier rule; render it again",
                              part.file.string()));
}

[[noreturn]] void failWithOverlap(const std::vector<Part>& parts, const OverlapError& overlap) {
  std::vector<std::string> clauses;
  for (const Part& part : parts) {
    for (const SampleBox& box : allBoxes(part.header)) {
      if (std::ranges::count(overlap.boxes, box) == 0) continue;
      clauses.push_back(fmt::format("{} has {}", part.file.string(), boxText(box)));
    }
  }
  throw FileError(fmt::format("cannot merge: {}, and {}, which overlap", clauses[0], clauses[1]));
}

void requireDisjoint(const std::vector<Part>& parts) {
  std::vector<SampleBox> all;
  for (const Part& part : parts) {
    const std::vector<SampleBox> boxes = allBoxes(part.header);
    all.insert(all.end(), boxes.begin(), boxes.end());
  }
  try {
    film::requireDisjoint(all);
  } catch (const OverlapError& overlap) {
    failWithOverlap(parts, overlap);
  }
}

void requireFitting(const std::vector<Part>& parts, const MergeOptions& options) {
  for (const Part& part : parts) requireMergeable(part);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    requireSameEstimate(parts[0], parts[i]);
    // Whether two films may be mixed says nothing about a third one, since those of the reference fit to all kernels.
    for (std::size_t j = 0; j < i; ++j) requireSameTracers(parts[j], parts[i], options);
  }
  requireDisjoint(parts);
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

FilmHeader mergedHeader(const std::vector<Part>& parts) {
  FilmHeader merged = parts.front().header;
  for (const Part& part : std::span(parts).subspan(1)) {
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

// A reader would refuse the film.
void requireReadable(const FilmHeader& merged) {
  const std::size_t count = merged.covered.size() + merged.begun.size();
  if (count <= kMaxBoxes) return;
  throw FileError(
      fmt::format("cannot merge: the samples of the film would be {} boxes of pixels and samples, and a film file has "
                  "at most {}; merge films that adjoin first",
                  count, kMaxBoxes));
}

std::string listOf(const std::vector<SampleBox>& boxes) {
  constexpr std::size_t kMaxShown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(boxes.size(), kMaxShown); ++i) {
    text += (i > 0 ? ", " : "") + boxText(boxes[i]);
  }
  return boxes.size() > kMaxShown ? fmt::format("{} and {} more", text, boxes.size() - kMaxShown) : text;
}

void requireWhole(const std::vector<Part>& parts, const std::vector<SampleBox>& missing) {
  for (const Part& part : parts) {
    if (part.header.begun.empty()) continue;
    throw FileError(
        fmt::format("{}: the render was interrupted within {}; continue it with --resume first, or merge what there is "
                    "with --partial",
                    part.file.string(), listOf(part.header.begun)));
  }
  if (missing.empty()) return;
  throw FileError(fmt::format("{} are missing; --partial merges what there is", listOf(missing)));
}

void addMattes(const FilmRows& rows, std::size_t pixel, image::Film& film, std::uint32_t x, std::uint32_t y) {
  for (const image::MatteKind kind : image::kMatteKinds) {
    const auto& ids = rows.ids[static_cast<std::size_t>(kind)];
    if (!ids.empty()) image::addIds(film.idsAt(kind, x, y), ids[pixel]);
  }
}

void add(const Part& part, MergedFilm& merged) {
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
  const std::vector<Part> parts = readHeaders(files);
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
  for (const Part& part : parts) add(part, merged);
  return merged;
} catch (const std::bad_alloc&) {
  throw OutOfMemoryError("the merged film does not fit into memory");
}

}  // namespace candela::film
