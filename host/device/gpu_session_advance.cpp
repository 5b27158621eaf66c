// Traces the samples of a session, band by band.
#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "host/core/errors.h"
#include "host/core/setting_words.h"
#include "host/core/stopwatch.h"
#include "host/device/gpu_session.h"

namespace candela::device {
// Returns null if device memory has no room for a band of this height and a smaller one is possible.
std::unique_ptr<Band> GpuSession::tryBand() {
  try {
    return std::make_unique<Band>(context_->device, kernel_, pipelinesOf(kernel_), *deviceScene_, settings_,
                                  bandHeight_);
  } catch (const OutOfMemoryError& error) {
    if (bandHeight_ == 1) throw;
    statistics_.warnings.push_back(
        fmt::format("trying again with bands of {} rows: {}", (bandHeight_ + 1) / 2, error.what()));
    return nullptr;
  }
}

// Not called during preparation, because a session that only replays samples needs no band.
void GpuSession::makeBand() {
  const vulkan::MemoryUse before = context_->device.memoryUse();
  while ((band_ = tryBand()) == nullptr) bandHeight_ = (bandHeight_ + 1) / 2;
  const vulkan::MemoryUse now = context_->device.memoryUse();
  prepared_.deviceBytes += now.currentBytes - before.currentBytes;
  statistics_.deviceBytes = prepared_.deviceBytes;
  if (now.systemBytes == before.systemBytes) return;
  statistics_.warnings.push_back(fmt::format(
      "the memory of {} is full, so that {} MiB are in system memory, which is slower: close other programs "
      "that use the device, or render a smaller image or a part of it ({} or {})",
      context_->device.info().name, (now.systemBytes - before.systemBytes) >> 20, settingWords("size"),
      settingWords("crop")));
}

// Takes the results of the resident band from the device.
void GpuSession::retire() {
  if (!resident_) return;
  updateFilm();
  counted_.reset();
  band_->addCounts(statistics_);
  if (settings_.execution.recordPaths) band_->readRecords(paths_);
  resident_.reset();
}

void GpuSession::restrictTo(const render::PixelMask& mask) {
  retire();
  mask_ = mask;
  coverage_.samples = render::FilmCoverage::kUneven;
}

void GpuSession::makeResident(std::uint32_t index) {
  if (resident_ == index) return;
  retire();
  const BandRows rows = bandAt(index);
  band_->load(rows, coverage_.isEmpty() ? std::span<const image::FilmPixel>{} : filmOf(rows), layersOf(rows),
              coverage_.first, mask_);
  resident_ = index;
}

// Counts the selected pixels that lack samples before `sampleEnd`, one by one.
std::uint64_t GpuSession::countLackingIn(BandRows rows, std::uint32_t sampleEnd) {
  const std::span<const image::FilmPixel> film = filmOf(rows);
  const std::size_t firstPixel = std::size_t{film_.width()} * rows.first;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < film.size(); ++i) {
    const bool lacks = coverage_.first + film[i].sampleCount < sampleEnd && render::isSelected(mask_, firstPixel + i);
    count += lacks ? 1 : 0;
  }
  return count;
}

std::uint64_t GpuSession::pixelsLacking(BandRows rows, std::uint32_t sampleEnd) {
  if (coverage_.samples != render::FilmCoverage::kUneven) {
    return coverage_.first + coverage_.samples < sampleEnd ? filmOf(rows).size() : 0;
  }
  return countLackingIn(rows, sampleEnd);
}

// A pixel's list of hits has room for kListedHits samples. The host counts them before more are traced, so that film_
// has all samples of earlier steps.
bool GpuSession::finishBySteps(BandRows rows, std::uint32_t sampleEnd, const render::RenderControl& control,
                               const std::function<void(std::uint64_t)>& samplesFinished) {
  std::uint32_t end = coverage_.first + render::minSampleCount(filmOf(rows));
  bool finished = true;
  while (finished && end < sampleEnd) {
    end = std::min(end + gpu::kListedHits, sampleEnd);
    finished = band_->finish(end, countLackingIn(rows, end), budget_, control, statistics_, samplesFinished);
    fetchFilm();
  }
  return finished;
}

bool GpuSession::advanceBand(std::uint32_t index, std::uint32_t sampleEnd, const render::RenderControl& control,
                             const std::function<void(std::uint64_t)>& samplesFinished) {
  Stopwatch watch;
  counted_.reset();
  if (!band_) makeBand();  // first, since it decides the height of all bands
  const std::uint64_t lacking = pixelsLacking(bandAt(index), sampleEnd);
  if (lacking == 0) return true;
  makeResident(index);
  isFetched_ = false;
  if (!warm_) {
    band_->warmUp(sampleEnd, budget_);
    warm_ = true;
    prepared_.seconds["pipeline"] += watch.lap();
    statistics_.seconds["pipeline"] = prepared_.seconds["pipeline"];
  }
  const bool finished = matteIds_ ? finishBySteps(bandAt(index), sampleEnd, control, samplesFinished)
                                  : band_->finish(sampleEnd, lacking, budget_, control, statistics_, samplesFinished);
  statistics_.seconds["trace"] += watch.lap();
  return finished;
}

bool GpuSession::advance(render::SampleRange range, const render::RenderControl& control) {
  const bool uneven = coverage_.samples == render::FilmCoverage::kUneven;
  if (uneven) updateFilm();
  const std::uint32_t covered = uneven ? render::minSampleCount(film_.pixels()) : coverage_.samples;
  render::requireContiguous(range, coverage_, covered, settings_.image.sampleCount);
  if (coverage_.isEmpty()) {
    if (range.first != coverage_.first) resident_.reset();
    coverage_.first = range.first;
  }
  if (range.end <= coverage_.first + covered) return true;

  const double total = static_cast<double>(film_.pixels().size()) * (range.end - coverage_.first - covered);
  std::uint64_t done = 0;
  const auto count = [&](std::uint64_t fresh) {
    done += fresh;
    if (control.progress) control.progress(std::min(1.0, static_cast<double>(done) / total), done);
  };
  bool finished = true;
  for (std::uint32_t i = 0; i < bandCount() && finished; ++i) {
    finished = advanceBand(i, range.end, control, count);
  }
  const bool isEven = finished && mask_.empty();
  coverage_.samples = isEven ? range.end - coverage_.first : render::FilmCoverage::kUneven;
  return finished;
}

}  // namespace candela::device
