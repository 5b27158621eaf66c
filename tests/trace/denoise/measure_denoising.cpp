// Prints, as JSON, the errors of a film's image before and after denoising and after a plain joint bilateral filter,
// compared with the image of a film of many samples:
//   measure_denoising FILM REFERENCE_FILM
#include <algorithm>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "host/image/flip.h"
#include "host/image/metrics.h"
#include "host/job/film/film_file.h"
#include "host/trace/denoise/denoise.h"
#include "host/trace/denoise/reference_filter.h"

namespace candela::denoise {
namespace {

// A Gaussian of distance, of the difference of the colours' square roots, of normals and of reflectances, with
// one fixed width each: the usual joint bilateral filter, on light divided by the reflectance.
double bilateralWeight(const gpu::DenoisePixel& a, const gpu::DenoisePixel& b, int x, int y) {
  const auto squared = [](const glm::dvec3& v) { return dot(v, v); };
  const double colour = squared(sqrt(glm::dvec3(a.light)) - sqrt(glm::dvec3(b.light))) / (0.3 * 0.3);
  const double normal = squared(glm::dvec3(a.normal) - glm::dvec3(b.normal)) / (0.2 * 0.2);
  const double reflectance = squared(glm::dvec3(a.reflectance) - glm::dvec3(b.reflectance)) / (0.2 * 0.2);
  return std::exp(-0.5 * (colour + normal + reflectance + (x * x + y * y) / 9.0));
}

glm::vec3 bilateralAt(const PixelStatistics& statistics, int x, int y) {
  const int width = static_cast<int>(statistics.width), height = static_cast<int>(statistics.height);
  const auto at = [&](int u, int v) -> const gpu::DenoisePixel& {
    return statistics.pixels[static_cast<std::size_t>(v) * statistics.width + static_cast<std::size_t>(u)];
  };
  glm::dvec3 sum(0);
  double weights = 0;
  for (int v = std::max(0, y - gpu::kDenoiseRadius); v <= std::min(height - 1, y + gpu::kDenoiseRadius); ++v) {
    for (int u = std::max(0, x - gpu::kDenoiseRadius); u <= std::min(width - 1, x + gpu::kDenoiseRadius); ++u) {
      const double weight = bilateralWeight(at(x, y), at(u, v), u - x, v - y);
      sum += weight * glm::dvec3(at(u, v).light);
      weights += weight;
    }
  }
  return glm::vec3(sum / weights);
}

std::vector<glm::vec3> filterBilaterally(const PixelStatistics& statistics) {
  std::vector<glm::vec3> light;
  for (int y = 0; y < static_cast<int>(statistics.height); ++y) {
    for (int x = 0; x < static_cast<int>(statistics.width); ++x) light.push_back(bilateralAt(statistics, x, y));
  }
  return light;
}

image::Film filmOf(const char* file) {
  film::FilmReader reader(file);
  return film::readFilm(reader);
}

nlohmann::ordered_json errorsOf(const image::Image& image, const image::Image& reference) {
  const image::ImageComparison comparison = image::compareImages(image, reference);
  const image::DisplayTransform display;
  const image::FlipResult flip = image::computeFlip(image::displayed(image, display),
                                                    image::displayed(reference, display));
  return {{"relMSE", comparison.relativeMeanSquaredError},
          {"FLIP", flip.mean},
          {"brightness", comparison.relativeMeanDifference}};
}

void measure(const char* filmFile, const char* referenceFile) {
  const image::Film film = filmOf(filmFile);
  const image::Image reference = image::toImage(filmOf(referenceFile));
  image::Image denoised = image::toImage(film), bilateral = denoised;
  denoise(denoised, film, filterByReference);
  denoise(bilateral, film, filterBilaterally);
  const nlohmann::ordered_json json{{"input", errorsOf(image::toImage(film), reference)},
                                    {"bilateral", errorsOf(bilateral, reference)},
                                    {"denoised", errorsOf(denoised, reference)}};
  std::cout << json.dump() << '\n';
}

}  // namespace
}  // namespace candela::denoise

int main(int argc, char** argv) try {
  if (argc != 3) throw std::runtime_error("usage: measure_denoising FILM REFERENCE_FILM");
  candela::denoise::measure(argv[1], argv[2]);
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
