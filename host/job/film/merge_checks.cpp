// Compares films before they are merged.
#include "host/job/film/merge_checks.h"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/errors.h"
#include "host/base/setting_words.h"

namespace candela::film {
namespace {

bool isReference(const Tracer& tracer) { return tracer.kernels == "reference"; }

// Devices may differ where mixedDevices is set, but never kernels and programs.
bool canMix(const Tracer& a, const Tracer& b) {
  return a.program == b.program && (a.kernels == b.kernels || isReference(a) || isReference(b));
}

void requireSameTracers(const MergePart& a, const MergePart& b, const MergeOptions& options) {
  for (const Tracer& x : a.header.tracers) {
    for (const Tracer& y : b.header.tracers) {
      if (x == y || (options.mixedDevices && canMix(x, y))) continue;
      const std::string remedy = canMix(x, y)
                                     ? fmt::format("; {} merges them nevertheless", settingWords("mixed-devices"))
                                     : "";
      throw FileError(
          fmt::format("cannot merge: {}{}", tracerDifferences(x, y, a.file.string(), b.file.string()).front(), remedy));
    }
  }
}

void requireSameEstimate(const MergePart& a, const MergePart& b) {
  const std::vector<std::string> differences = estimateDifferences(a.header, b.header, a.file.string(),
                                                                   b.file.string());
  if (!differences.empty()) throw FileError("cannot merge: " + differences.front());
}

void requireMergeable(const MergePart& part) {
  if (!part.header.hasFirstStoppingRule()) return;
  throw FileError(fmt::format("cannot merge: {} was sampled with a noise threshold by an earlier rule; render it again",
                              part.file.string()));
}

[[noreturn]] void failWithOverlap(const std::vector<MergePart>& parts, const OverlapError& overlap) {
  std::vector<std::string> clauses;
  for (const MergePart& part : parts) {
    for (const SampleBox& box : allBoxes(part.header)) {
      if (std::ranges::count(overlap.boxes, box) == 0) continue;
      clauses.push_back(fmt::format("{} has {}", part.file.string(), boxText(box)));
    }
  }
  throw FileError(fmt::format("cannot merge: {}, and {}, which overlap", clauses.at(0), clauses.at(1)));
}

void requireDisjoint(const std::vector<MergePart>& parts) {
  std::vector<SampleBox> all;
  for (const MergePart& part : parts) {
    const std::vector<SampleBox> boxes = allBoxes(part.header);
    all.insert(all.end(), boxes.begin(), boxes.end());
  }
  try {
    film::requireDisjoint(all);
  } catch (const OverlapError& overlap) {
    failWithOverlap(parts, overlap);
  }
}

std::string listOf(const std::vector<SampleBox>& boxes) {
  constexpr std::size_t kMaxShown = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(boxes.size(), kMaxShown); ++i) {
    text += (i > 0 ? ", " : "") + boxText(boxes[i]);
  }
  return boxes.size() > kMaxShown ? fmt::format("{} and {} more", text, boxes.size() - kMaxShown) : text;
}

}  // namespace

std::vector<SampleBox> allBoxes(const FilmHeader& header) {
  std::vector<SampleBox> boxes = header.covered;
  boxes.insert(boxes.end(), header.begun.begin(), header.begun.end());
  return boxes;
}

void requireFitting(const std::vector<MergePart>& parts, const MergeOptions& options) {
  for (const MergePart& part : parts) requireMergeable(part);
  for (std::size_t i = 1; i < parts.size(); ++i) {
    requireSameEstimate(parts[0], parts[i]);
    // Whether two films may be mixed says nothing about a third one, since those of the reference fit to all kernels.
    for (std::size_t j = 0; j < i; ++j) requireSameTracers(parts[j], parts[i], options);
  }
  requireDisjoint(parts);
}

void requireReadable(const FilmHeader& merged) {
  const std::size_t count = merged.covered.size() + merged.begun.size();
  if (count <= kMaxBoxes) return;
  throw FileError(
      fmt::format("cannot merge: the samples of the film would be {} boxes of pixels and samples, and a film file has "
                  "at most {}; merge films that adjoin first",
                  count, kMaxBoxes));
}

void requireWhole(const std::vector<MergePart>& parts, const std::vector<SampleBox>& missing) {
  for (const MergePart& part : parts) {
    if (part.header.begun.empty()) continue;
    throw FileError(fmt::format(
        "{}: the render was interrupted within {}; continue it with {} first, or merge what there is with {}",
        part.file.string(), listOf(part.header.begun), settingWords("resume"), settingWords("partial")));
  }
  if (missing.empty()) return;
  throw FileError(fmt::format("{} are missing; {} merges what there is", listOf(missing), settingWords("partial")));
}

}  // namespace candela::film
