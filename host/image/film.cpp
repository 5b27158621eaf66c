// The arithmetic of the film: 96-bit sums, and the means and variances computed from them.
#include "host/image/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/base/errors.h"
#include "host/base/hash.h"

namespace candela::image {
namespace {

/// Returns the value that is added for a channel. Sets `bad` if it differs from the given value.
double inRange(double value, bool& bad) {
  if (!std::isfinite(value) || value < 0) {
    bad = true;
    return 0;
  }
  if (value > kFilmMaximum) {
    bad = true;
    return kFilmMaximum;
  }
  return value;
}

/// Returns the lower of two values of FilmPixel::firstBadSample, in which 0 means none.
std::uint32_t earlier(std::uint32_t a, std::uint32_t b) { return std::min(a - 1, b - 1) + 1; }

/// Computes FNV-1a over the little-endian bytes of 32-bit words.
class Fnv1a {
 public:
  void add(std::uint32_t word) { hash_ = fnv1aOfWord(word, hash_); }
  void add(const FixedSum& sum) {
    for (const std::uint32_t word : sum) add(word);
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = fnv1a({});
};

}  // namespace

void addSums(FilmPixel& sums, const FilmPixel& terms) {
  addFixed(sums.red, terms.red);
  addFixed(sums.green, terms.green);
  addFixed(sums.blue, terms.blue);
  addFixed(sums.luminanceSquared, terms.luminanceSquared);
  sums.sampleCount += terms.sampleCount;
  sums.badCount += terms.badCount;
  sums.hitCount += terms.hitCount;
  sums.firstBadSample = earlier(sums.firstBadSample, terms.firstBadSample);
}

Film::Film(std::uint32_t width, std::uint32_t height, LayerSet layers, std::uint32_t scale)
    : width_(width),
      height_(height),
      pixels_(std::size_t{width} * height),
      layers_(layers),
      scale_(scale),
      layerRows_(pixels_.size() * layerRowCount(layerSumsOf(layers))) {
  for (const MatteKind kind : kMatteKinds) {
    if (hasMatte(layers, kind)) ids(kind).resize(pixels_.size());
  }
}

double Film::radianceOfOne() const { return std::ldexp(1.0, static_cast<int>(scale_)); }

FilmCounts Film::counts() const {
  FilmCounts counts;
  for (const FilmPixel& pixel : pixels_) {
    counts.samples += pixel.sampleCount;
    counts.badSamples += pixel.badCount;
  }
  return counts;
}

void Film::clear() { *this = Film(width_, height_, layers_, scale_); }

std::span<LayerRow> Film::layerRowsAt(std::uint32_t x, std::uint32_t y) {
  const std::size_t count = layerRowCount(layerSumsOf(layers_));
  return std::span(layerRows_).subspan((std::size_t{y} * width_ + x) * count, count);
}

std::span<const LayerRow> Film::layerRowsAt(std::uint32_t x, std::uint32_t y) const {
  const std::size_t count = layerRowCount(layerSumsOf(layers_));
  return std::span(layerRows_).subspan((std::size_t{y} * width_ + x) * count, count);
}

void Film::addLayers(std::uint32_t x, std::uint32_t y, const LayerSample& sample, const glm::dvec3& radiance) {
  const double unit = 1 / radianceOfOne();
  LayerSample scaled = sample;
  if (scaled.unscattered) *scaled.unscattered *= unit;
  if (scaled.scatteredOnce) *scaled.scatteredOnce *= unit;
  addLayerSample(layerRowsAt(x, y), layerSumsOf(layers_), scaled, radiance * unit);
}

void Film::addSample(std::uint32_t x, std::uint32_t y, const glm::dvec3& radiance, std::uint32_t sampleIndex) {
  bool bad = false;
  const glm::dvec3 scaled = radiance / radianceOfOne();
  const glm::dvec3 kept(inRange(scaled.x, bad), inRange(scaled.y, bad), inRange(scaled.z, bad));
  const double keptLuminance = luminance(kept);

  FilmPixel sample;
  sample.red = toFixed(kept.x);
  sample.green = toFixed(kept.y);
  sample.blue = toFixed(kept.z);
  sample.luminanceSquared = toFixed(keptLuminance * keptLuminance);
  sample.sampleCount = 1;
  sample.badCount = bad ? 1 : 0;
  sample.firstBadSample = bad ? sampleIndex + 1 : 0;
  addSums(at(x, y), sample);
}

glm::dvec3 Film::mean(std::uint32_t x, std::uint32_t y) const {
  const FilmPixel& pixel = at(x, y);
  if (pixel.sampleCount == 0) return glm::dvec3(0);
  return glm::dvec3(toDouble(pixel.red), toDouble(pixel.green), toDouble(pixel.blue)) /
         static_cast<double>(pixel.sampleCount) * radianceOfOne();
}

double Film::alpha(std::uint32_t x, std::uint32_t y) const {
  const FilmPixel& pixel = at(x, y);
  return pixel.sampleCount == 0 ? 0 : static_cast<double>(pixel.hitCount) / pixel.sampleCount;
}

double Film::luminanceVariance(std::uint32_t x, std::uint32_t y) const {
  const FilmPixel& pixel = at(x, y);
  if (pixel.sampleCount < 2) return 0;
  const double count = pixel.sampleCount;
  const double meanLuminance = luminance(mean(x, y));
  const double meanOfSquares = toDouble(pixel.luminanceSquared) / count * radianceOfOne() * radianceOfOne();
  // Truncation makes the second moment slightly too small, so that equal samples may give a negative difference.
  return std::max(0.0, meanOfSquares - meanLuminance * meanLuminance) * (count / (count - 1));
}

void Film::merge(const Film& other) {
  if (width_ != other.width_ || height_ != other.height_) {
    throw UsageError(fmt::format("cannot merge a film of {} x {} pixels into one of {} x {}", other.width_,
                                 other.height_, width_, height_));
  }
  if (layers_ != other.layers_) throw UsageError("cannot merge films with different layers");
  if (scale_ != other.scale_) throw UsageError("cannot merge films with different scales");
  constexpr std::uint32_t kMaxCount = std::numeric_limits<std::uint32_t>::max();
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    if (other.pixels_[i].sampleCount > kMaxCount - pixels_[i].sampleCount) {
      throw UsageError(fmt::format("cannot merge films: a pixel would hold more than {} samples", kMaxCount));
    }
  }
  for (std::size_t i = 0; i < pixels_.size(); ++i) addSums(pixels_[i], other.pixels_[i]);
  const std::size_t step = layerRowCount(layerSumsOf(layers_));
  for (std::size_t i = 0; i < layerRows_.size(); i += step) {
    addLayerRows(std::span(layerRows_).subspan(i, step), std::span(other.layerRows_).subspan(i, step));
  }
  for (const MatteKind kind : kMatteKinds) {
    for (std::size_t i = 0; i < ids(kind).size(); ++i) addIds(ids(kind)[i], other.ids(kind)[i]);
  }
}

std::uint64_t Film::hash() const {
  Fnv1a hash;
  hash.add(width_);
  hash.add(height_);
  for (const FilmPixel& pixel : pixels_) {
    hash.add(pixel.red);
    hash.add(pixel.green);
    hash.add(pixel.blue);
    hash.add(pixel.luminanceSquared);
    hash.add(pixel.sampleCount);
    hash.add(pixel.badCount);
    hash.add(pixel.firstBadSample);
  }
  const bool hasHits = std::ranges::any_of(pixels_, [](const FilmPixel& pixel) { return pixel.hitCount > 0; });
  for (std::size_t i = 0; hasHits && i < pixels_.size(); ++i) hash.add(pixels_[i].hitCount);
  if (scale_ > 0) hash.add(scale_);
  return hash.value();
}

std::uint64_t badLayerCount(const Film& film) {
  const std::size_t step = layerRowCount(layerSumsOf(film.layers()));
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < film.layerRows().size(); i += step) count += film.layerRows()[i].words[1];
  return count;
}

}  // namespace candela::image
