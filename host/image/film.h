// The film: exact integer sums of samples per pixel, so that the result is the same bytes for any order and division of
// the work.
#pragma once
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "host/image/fixed_sum.h"
#include "host/image/layers.h"

namespace candela::image {

/// The sums of one pixel, 64 bytes, of samples after multiplication by the film's unit. The device writes the same
/// layout. The sum of a channel, which is not negative, cannot overflow: samples are at most 2^20, so that 2^36 of them
/// fit, more than sampleCount can count. The second moment holds 2^56 / Y^2 samples of luminance Y: 2^36 samples at Y =
/// 1024, and 65,535 samples of the maximum luminance.
struct FilmPixel {
  FixedSum red{};
  std::uint32_t sampleCount = 0;
  FixedSum green{};
  /// Number of samples with a channel that is not finite or negative (it adds 0), or above kFilmMaximum (it is
  /// clamped).
  std::uint32_t badCount = 0;
  FixedSum blue{};
  std::uint32_t firstBadSample = 0;  ///< 1 + index of the lowest bad sample; 0: none
  FixedSum luminanceSquared{};       ///< second moment of the luminance of the samples, after clamping
  /// Number of samples whose camera ray hit something: alpha is its ratio to sampleCount. 0 in films without alpha.
  std::uint32_t hitCount = 0;
};
static_assert(sizeof(FilmPixel) == 64);

/// Adds the sums, the counts and the first bad sample of other samples of the same pixel.
void addSums(FilmPixel& sums, const FilmPixel& terms);

/// Numbers of samples, over all pixels of a film.
struct FilmCounts {
  std::uint64_t samples = 0;
  std::uint64_t badSamples = 0;  ///< see FilmPixel::badCount
};

class Film {
 public:
  Film() = default;
  /// `layers` are those that the film has beside its samples. `scale` is the exponent k of docs/light-transport.md
  /// section 8, at most kMaxFilmScale: sums have samples times 2^-k, and means and variances are those of the samples.
  Film(std::uint32_t width, std::uint32_t height, LayerSet layers = {}, std::uint32_t scale = 0);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  FilmPixel& at(std::uint32_t x, std::uint32_t y) { return pixels_[std::size_t{y} * width_ + x]; }
  const FilmPixel& at(std::uint32_t x, std::uint32_t y) const { return pixels_[std::size_t{y} * width_ + x]; }
  std::vector<FilmPixel>& pixels() { return pixels_; }
  const std::vector<FilmPixel>& pixels() const { return pixels_; }

  LayerSet layers() const { return layers_; }
  std::uint32_t scale() const { return scale_; }
  /// Returns 2^k, the radiance that is 1 in the sums.
  double radianceOfOne() const;
  /// The records of all pixels, as many for each as layerRowCount() says.
  std::vector<LayerRow>& layerRows() { return layerRows_; }
  const std::vector<LayerRow>& layerRows() const { return layerRows_; }
  /// The records of one pixel; none if the film has no sums of layers.
  std::span<LayerRow> layerRowsAt(std::uint32_t x, std::uint32_t y);
  std::span<const LayerRow> layerRowsAt(std::uint32_t x, std::uint32_t y) const;
  /// The counts of ids of all pixels; none if the film lacks mattes of this kind.
  std::vector<IdCounts>& ids(MatteKind kind) { return ids_[static_cast<std::size_t>(kind)]; }
  const std::vector<IdCounts>& ids(MatteKind kind) const { return ids_[static_cast<std::size_t>(kind)]; }
  /// The counts of one pixel. The film must have mattes of this kind.
  IdCounts& idsAt(MatteKind kind, std::uint32_t x, std::uint32_t y) { return ids(kind)[std::size_t{y} * width_ + x]; }
  const IdCounts& idsAt(MatteKind kind, std::uint32_t x, std::uint32_t y) const {
    return ids(kind)[std::size_t{y} * width_ + x];
  }
  /// Returns the numbers of samples of all pixels.
  FilmCounts counts() const;
  /// Removes all samples.
  void clear();

  /// Adds one sample of linear RGB radiance. After scaling, each channel is truncated to a multiple of 2^-40 by the
  /// range rule of FilmPixel::badCount. Negative values are bad and add 0.
  void addSample(std::uint32_t x, std::uint32_t y, const glm::dvec3& radiance, std::uint32_t sampleIndex);

  /// Adds the layers of a sample with this radiance. The film must have sums of layers.
  void addLayers(std::uint32_t x, std::uint32_t y, const LayerSample& sample, const glm::dvec3& radiance);

  /// Counts a sample whose camera ray hit something.
  void addHit(std::uint32_t x, std::uint32_t y) { ++at(x, y).hitCount; }

  /// Returns the mean of the samples of a pixel, linear RGB; 0 without samples.
  glm::dvec3 mean(std::uint32_t x, std::uint32_t y) const;
  /// Returns the fraction of the samples whose camera rays hit something; 0 without samples.
  double alpha(std::uint32_t x, std::uint32_t y) const;
  /// Returns the unbiased variance of the luminance of one sample (not of the mean); 0 for fewer than two samples.
  /// Squares below 2^-40 are truncated, so that it is 0 if every luminance is below 2^-20, both after scaling.
  double luminanceVariance(std::uint32_t x, std::uint32_t y) const;
  /// Adds the sums of a film of the same size, layers and scale. Throws UsageError and leaves the film unchanged if
  /// these differ or if a sampleCount would exceed 2^32 - 1.
  void merge(const Film& other);
  /// Returns the FNV-1a hash (64 bits) of the size and the sums. Equal films have equal hashes. The scale is part of it
  /// unless it is 0, and hit counts unless all are 0. Layers are not part of it.
  std::uint64_t hash() const;

 private:
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::vector<FilmPixel> pixels_;
  LayerSet layers_;
  std::uint32_t scale_ = 0;
  std::vector<LayerRow> layerRows_;
  std::array<std::vector<IdCounts>, kMatteKinds.size()> ids_;
};

/// Returns the number of samples with a value of a layer that is not finite or above kFilmMaximum in magnitude.
std::uint64_t badLayerCount(const Film& film);

/// Returns the Rec. 709 luminance.
inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

}  // namespace candela::image
