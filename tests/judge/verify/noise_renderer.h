// A renderer whose images are known: a ramp, plus normal noise that falls with the number of samples.
#pragma once
#include <cmath>
#include <functional>
#include <random>

#include "host/trace/render/renderer.h"
#include "tests/trace/render/one_shot_renderer.h"

namespace candela::verify {

struct NoiseOptions {
  double deviation = 0.5;  ///< of one sample, relative to the pixel's mean
  /// Factor of the pixel x, y.
  std::function<double(std::uint32_t, std::uint32_t)> factor = [](std::uint32_t, std::uint32_t) { return 1.0; };
};

class NoiseRenderer final : public test::OneShotRenderer {
 public:
  explicit NoiseRenderer(NoiseOptions options = {}) : options_(std::move(options)) {}

  render::RenderResult renderOnce(const scene::Scene&, const render::RenderSettings& settings,
                                  const render::RenderControl& control) override {
    render::RenderResult result;
    result.film = image::Film(settings.image.size.width, settings.image.size.height);
    result.statistics.device = name;
    result.statistics.driver = "a driver";
    result.interrupted = control.stop != nullptr && *control.stop;
    std::mt19937 random(settings.image.seed);
    std::normal_distribution<double> noise(0, options_.deviation / std::sqrt(double{1} * settings.image.sampleCount));
    for (std::uint32_t y = 0; y < settings.image.size.height; ++y) {
      for (std::uint32_t x = 0; x < settings.image.size.width; ++x) {
        const double mean = (1 + 0.1 * x) * options_.factor(x, y);
        result.film.addSample(x, y, glm::dvec3(mean * std::max(0.0, 1 + noise(random))), 0);
      }
    }
    samples += settings.image.sampleCount;
    return result;
  }

  std::string name;           ///< of the device in the statistics
  std::uint64_t samples = 0;  ///< per pixel, of all renders so far

 private:
  NoiseOptions options_;
};

}  // namespace candela::verify
