// Computes means and variances of pixels from exact sums.
#include "host/trace/denoise/pixel_statistics.h"

#include <algorithm>
#include <cmath>

#include "host/base/errors.h"
#include "host/base/setting_words.h"

namespace candela::denoise {
namespace {

using glm::dvec3;
using image::LayerSum;

constexpr float kMinReflectance = 0.01f;

/// The sums of one pixel as real numbers.
class PixelSums {
 public:
  PixelSums(const image::Film& film, std::uint32_t x, std::uint32_t y)
      : pixel_(film.at(x, y)),
        rows_(film.layerRowsAt(x, y)),
        sums_(image::layerSumsOf(film.layers())),
        one_(film.radianceOfOne()) {}

  double count() const { return pixel_.sampleCount; }
  double hits() const { return rows_[0].words[0]; }
  dvec3 radiance() const {
    return dvec3(image::toDouble(pixel_.red), image::toDouble(pixel_.green), image::toDouble(pixel_.blue)) * one_;
  }
  double channel(LayerSum sum, std::uint32_t index) const {
    return image::toSignedDouble(rows_[image::firstLayerRow(sums_, sum) + index].words);
  }
  dvec3 rootRadiance() const { return vector(LayerSum::rootRadiance) * std::sqrt(one_); }
  dvec3 vector(LayerSum sum) const { return {channel(sum, 0), channel(sum, 1), channel(sum, 2)}; }

 private:
  const image::FilmPixel& pixel_;
  std::span<const image::LayerRow> rows_;
  std::uint32_t sums_;
  double one_;
};

// The variance of a mean, all channels together, from the sum of the squared norms and the sum of the vectors.
double varianceOfMean(double squares, const dvec3& sum, double count) {
  return std::max(0.0, squares - dot(sum, sum) / count) / (count * (count - 1));
}

gpu::DenoisePixel statisticsOfPixel(const PixelSums& sums) {
  const double count = sums.count();
  if (count < 2) return {};
  const dvec3 albedo = sums.vector(LayerSum::albedo), normal = sums.vector(LayerSum::normal);
  const dvec3 reflectance = max(albedo + (count - sums.hits()), dvec3(0)) / count;
  const dvec3 divisor(divisorOf(glm::vec4(reflectance, 0)));
  const dvec3 mean = sums.radiance() / count / divisor;
  const dvec3 root = sums.rootRadiance() / count / sqrt(divisor);
  const dvec3 variance = max(dvec3(0), mean - root * root) / (count - 1);
  const double misses = count - sums.hits();
  const double reflectanceSquares = sums.channel(LayerSum::albedoSquared, 0) + 3 * misses;
  const double reflectanceVariance = varianceOfMean(reflectanceSquares, albedo + misses, count);
  const double normalVariance = varianceOfMean(sums.hits(), normal, count);
  return {{mean, count},
          {root, variance.x + variance.y + variance.z},
          {normal / count, normalVariance},
          {reflectance, reflectanceVariance}};
}

}  // namespace

glm::vec3 divisorOf(const glm::vec4& reflectance) { return max(glm::vec3(reflectance), glm::vec3(kMinReflectance)); }

void requireStatistics(const image::Film& film) {
  image::LayerSet moments;
  moments.add(image::Layer::moments);
  const std::uint32_t needed = image::layerSumsOf(moments);
  if ((image::layerSumsOf(film.layers()) & needed) != needed) {
    throw UsageError(fmt::format("the film lacks the sums that denoising needs; render it again with {} or {}",
                                 settingWords("aov", "moments"), settingWords("denoise")));
  }
  const auto hasTwo = [](const image::FilmPixel& pixel) { return pixel.sampleCount >= 2; };
  if (std::ranges::none_of(film.pixels(), hasTwo)) {
    throw UsageError(fmt::format("denoising needs at least two samples per pixel; add samples with {} or more",
                                 settingWords("spp", "2")));
  }
}

PixelStatistics statisticsOf(const image::Film& film) {
  PixelStatistics statistics{film.width(), film.height(), {}};
  statistics.pixels.reserve(film.pixels().size());
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      statistics.pixels.push_back(statisticsOfPixel(PixelSums(film, x, y)));
    }
  }
  return statistics;
}

}  // namespace candela::denoise
