// The mean of an image with its standard error.
#pragma once
#include <cmath>

#include "host/image/film.h"

namespace candela::test {

struct Estimate {
  double mean;
  double error;  ///< one standard deviation of the mean
};

/// Luminance of all pixels, with the error that the film's own variance gives: for independent samples.
inline Estimate estimateOf(const image::Film& film) {
  double sum = 0, variance = 0;
  const double pixels = double{1} * film.width() * film.height();
  for (std::uint32_t y = 0; y < film.height(); ++y) {
    for (std::uint32_t x = 0; x < film.width(); ++x) {
      sum += image::luminance(film.mean(x, y));
      variance += film.luminanceVariance(x, y) / film.at(x, y).sampleCount;
    }
  }
  return {sum / pixels, std::sqrt(variance) / pixels};
}

}  // namespace candela::test
