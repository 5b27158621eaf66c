// The film: per pixel, exact integer sums of samples, so that any order and any split of the work gives the same bytes.
#pragma once
#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace candela::image {

/// A 96-bit unsigned integer, least significant word first, in units of 2^-40. Sums wrap. A channel's cannot: samples
/// are at most 2^20, so 2^36 fit, more than sampleCount counts. The second moment holds 2^56 / Y^2 samples of luminance
/// Y: 2^36 at Y = 1024, and 65,535 if every single one has the largest value there is.
using FixedSum = std::array<std::uint32_t, 3>;

/// One pixel's sums. 64 bytes; the device writes this very layout.
struct FilmPixel {
  FixedSum red{};
  std::uint32_t sampleCount = 0;
  FixedSum green{};
  /// Samples with a channel that is not finite or negative (it adds 0) or beyond kFilmMaximum (it is clamped).
  std::uint32_t badCount = 0;
  FixedSum blue{};
  std::uint32_t firstBadSample = 0;  ///< 1 + index of the lowest bad sample; 0: none
  FixedSum luminanceSquared{};       ///< second moment of the luminance of the samples as added
  std::uint32_t spare = 0;
};
static_assert(sizeof(FilmPixel) == 64);

inline constexpr double kFilmScale = 1099511627776.0;  ///< 2^40
inline constexpr double kFilmMaximum = 1048576.0;      ///< 2^20, the largest channel value of one sample

class Film {
 public:
  Film() = default;
  Film(std::uint32_t width, std::uint32_t height);

  std::uint32_t width() const { return width_; }
  std::uint32_t height() const { return height_; }
  FilmPixel& at(std::uint32_t x, std::uint32_t y) { return pixels_[std::size_t{y} * width_ + x]; }
  const FilmPixel& at(std::uint32_t x, std::uint32_t y) const { return pixels_[std::size_t{y} * width_ + x]; }
  std::vector<FilmPixel>& pixels() { return pixels_; }
  const std::vector<FilmPixel>& pixels() const { return pixels_; }

  /// Adds one sample of linear RGB radiance. Each channel is truncated to a multiple of 2^-40 after the range rule of
  /// FilmPixel::badCount; negative values count as bad and add 0.
  void addSample(std::uint32_t x, std::uint32_t y, const glm::dvec3& radiance, std::uint32_t sampleIndex);

  /// Mean of the pixel's samples, linear RGB; 0 where there are none.
  glm::dvec3 mean(std::uint32_t x, std::uint32_t y) const;
  /// Unbiased variance of the luminance of one sample (not of the mean); 0 below two samples. Squares below 2^-40 are
  /// truncated away, so it is 0 where every luminance is below 2^-20.
  double luminanceVariance(std::uint32_t x, std::uint32_t y) const;
  /// Adds the sums of a film of equal size. Throws UsageError, and leaves the film as it was, if the sizes differ or a
  /// pixel's sampleCount would pass 2^32 - 1.
  void merge(const Film& other);
  /// FNV-1a (64 bits) over size and sums: equal films, equal hashes.
  std::uint64_t hash() const;

 private:
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::vector<FilmPixel> pixels_;
};

/// Rec. 709 luminance.
inline double luminance(const glm::dvec3& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

}  // namespace candela::image
