// Copies the film of a session to a device and back, band by band.
#include "host/trace/device/device_film.h"

#include <algorithm>

#include "host/base/divide_up.h"
#include "host/base/stopwatch.h"
#include "host/trace/device/hit_lists.h"

namespace candela::device {

DeviceFilm::DeviceFilm(const scene::Scene& scene, const image::LayerSet& layers) {
  if (hasMattes(layers)) matteIds_.emplace(scene);
}

void DeviceFilm::resize(const render::ImageSettings& image) {
  film_ = render::emptyFilm(image, image.window().extent());
  startAgain();
}

std::uint32_t DeviceFilm::bandCount() const { return divideUp(film_.height(), bandHeight_); }

BandRows DeviceFilm::rowsOf(std::uint32_t band) const {
  const std::uint32_t first = band * bandHeight_;
  return {first, std::min(bandHeight_, film_.height() - first)};
}

std::span<image::FilmPixel> DeviceFilm::pixelsOf(BandRows rows) {
  const std::uint64_t width = film_.width();
  return std::span(film_.pixels()).subspan(width * rows.first, width * rows.height);
}

std::span<const image::FilmPixel> DeviceFilm::pixelsOf(BandRows rows) const {
  const std::uint64_t width = film_.width();
  return std::span(film_.pixels()).subspan(width * rows.first, width * rows.height);
}

std::span<image::LayerRow> DeviceFilm::layersOf(BandRows rows) {
  const std::uint64_t width = film_.layerRows().size() / film_.height();
  return std::span(film_.layerRows()).subspan(width * rows.first, width * rows.height);
}

// The next band that becomes resident starts from film_.
void DeviceFilm::startAgain() {
  coverage_ = {};
  mask_.clear();
  loaded_ = {};
  release();
}

void DeviceFilm::clear() {
  film_.clear();
  startAgain();
}

void DeviceFilm::load(const image::Film& film, const render::FilmCoverage& coverage) {
  startAgain();
  film_ = film;
  coverage_ = coverage;
  loaded_ = film_.counts();
}

void DeviceFilm::restrictTo(const render::PixelMask& mask) {
  mask_ = mask;
  noteUneven();
}

void DeviceFilm::startAt(std::uint32_t sample) {
  if (sample != coverage_.first) release();
  coverage_.first = sample;
}

void DeviceFilm::noteFinished(std::uint32_t sampleEnd) {
  if (mask_.empty()) {
    coverage_.samples = sampleEnd - coverage_.first;
  } else {
    noteUneven();
  }
}

std::uint32_t DeviceFilm::minSamples(BandRows rows) const { return render::minSampleCount(pixelsOf(rows)); }

std::uint32_t DeviceFilm::minSamples() const {
  return coverage_.isUneven() ? render::minSampleCount(film_.pixels()) : coverage_.samples;
}

std::uint64_t DeviceFilm::pixelsLacking(BandRows rows, std::uint32_t sampleEnd) const {
  const std::span<const image::FilmPixel> pixels = pixelsOf(rows);
  if (!coverage_.isUneven()) return coverage_.first + coverage_.samples < sampleEnd ? pixels.size() : 0;
  const std::size_t firstPixel = std::size_t{film_.width()} * rows.first;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const bool lacks = coverage_.first + pixels[i].sampleCount < sampleEnd && render::isSelected(mask_, firstPixel + i);
    count += lacks ? 1 : 0;
  }
  return count;
}

void DeviceFilm::makeResident(std::uint32_t index, Band& band) {
  isFetched_ = false;
  if (resident_ == index) return;
  const BandRows rows = rowsOf(index);
  band.load(rows, coverage_.isEmpty() ? std::span<const image::FilmPixel>{} : pixelsOf(rows), layersOf(rows),
            coverage_.first, mask_);
  resident_ = index;
  band_ = &band;
}

void DeviceFilm::fetch(render::RenderStatistics& statistics) {
  if (!resident_) return;
  Stopwatch watch;
  const BandRows rows = rowsOf(*resident_);
  band_->readFilm(pixelsOf(rows), layersOf(rows));
  if (matteIds_) addListedHits(band_->readHitLists(), rows.first, coverage_.first, *matteIds_, film_);
  statistics.seconds["readBack"] += watch.lap();
  isFetched_ = true;
}

void DeviceFilm::update(render::RenderStatistics& statistics) {
  if (!isFetched_) fetch(statistics);
}

const vulkan::Buffer* DeviceFilm::buffer() const { return resident_ && bandCount() == 1 ? &band_->film() : nullptr; }

image::FilmCounts DeviceFilm::added() const {
  const image::FilmCounts counts = film_.counts();
  return {counts.samples - loaded_.samples, counts.badSamples - loaded_.badSamples};
}

}  // namespace candela::device
