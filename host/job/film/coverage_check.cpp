// Counts the samples of a row by the left and right edges of its boxes.
#include "host/job/film/coverage_check.h"

#include <fmt/format.h>

#include <limits>

#include "host/base/errors.h"

namespace candela::film {
namespace {

std::uint32_t bottomOf(const SampleBox& box) { return box.window.y + box.window.height; }

}  // namespace

ColumnCounts::ColumnCounts(std::span<const SampleBox> boxes, const render::Window& window,
                           std::uint32_t samplesPerPixel)
    : boxes_(boxes), window_(window), samplesPerPixel_(samplesPerPixel), counts_(window.width + 1) {}

// The counts begin as differences between a column and the one before it.
std::span<const ColumnCounts::Count> ColumnCounts::at(std::uint32_t y) {
  if (y < end_) return counts_;
  counts_.assign(counts_.size(), {});
  while (!boxes_.empty() && bottomOf(boxes_.front()) <= y) boxes_ = boxes_.subspan(1);
  end_ = boxes_.empty() ? std::numeric_limits<std::uint32_t>::max() : boxes_.front().window.y;
  if (end_ > y) return counts_;
  end_ = bottomOf(boxes_.front());
  for (; !boxes_.empty() && boxes_.front().window.y <= y; boxes_ = boxes_.subspan(1)) {
    const auto& [window, samples] = boxes_.front();
    Count& left = counts_[window.x - window_.x];
    Count& right = counts_[window.x - window_.x + window.width];
    const std::uint32_t last = samples.end == samplesPerPixel_ ? 1 : 0;
    left.samples += samples.end - samples.first;
    right.samples -= samples.end - samples.first;
    left.last += last;
    right.last -= last;
  }
  for (std::size_t x = 1; x < counts_.size(); ++x) {
    counts_[x].samples += counts_[x - 1].samples;
    counts_[x].last += counts_[x - 1].last;
  }
  return counts_;
}

CoverageCheck::CoverageCheck(const FilmHeader& header)
    : header_(header),
      covered_(header.covered, header.window, header.samplesPerPixel),
      begun_(header.begun, header.window, header.samplesPerPixel) {
  if (const std::optional<double> threshold = header.noiseThreshold()) pilot_ = render::pilotSamples(*threshold);
}

void CoverageCheck::checkRow(std::uint32_t y, std::span<const image::FilmPixel> row) {
  const std::span<const ColumnCounts::Count> covered = covered_.at(y);
  const std::span<const ColumnCounts::Count> begun = begun_.at(y);
  for (std::size_t x = 0; x < row.size(); ++x) {
    const std::uint32_t samples = row[x].sampleCount;
    if (row[x].hitCount > samples) {
      throw FileError(fmt::format("pixel ({}, {}) holds more hits than samples", header_.window.x + x, y));
    }
    const std::uint32_t min = pilot_ && covered[x].last > 0 ? *pilot_ : covered[x].samples;
    const std::uint32_t max = covered[x].samples + begun[x].samples;
    if (samples >= min && samples <= max) continue;
    throw FileError(fmt::format("pixel ({}, {}) holds {} samples, and the file says {} to {}", header_.window.x + x, y,
                                samples, min, max));
  }
}

}  // namespace candela::film
