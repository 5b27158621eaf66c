// Interference by its Fourier transform (Belcour and Barla 2017), with the simplifications of
// KHR_materials_iridescence.
#include "host/trace/reference/thin_film.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "host/trace/reference/sampling.h"

namespace candela::reference {
namespace {

// One of the Gaussians of which the colour matching functions consist, in the frequency domain.
struct Gaussian {
  int channel;  ///< of XYZ
  double value;
  double position;
  double variance;
};
constexpr std::array<Gaussian, 4> kMatching{{{0, 5.4856e-13, 1.6810e+06, 4.3278e+09},
                                             {1, 4.4201e-13, 1.7953e+06, 9.3046e+09},
                                             {2, 5.2481e-13, 2.2084e+06, 6.6121e+09},
                                             {0, 9.7470e-14, 2.2399e+06, 4.5282e+09}}};
constexpr double kUnit = 1.0685e-7;

dvec3 rgbOfXyz(const dvec3& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}

// Returns the response of each channel to interference with a path difference in metres. `shift` is pi or 0.
dvec3 sensitivity(double difference, const dvec3& shift) {
  const double phase = 2 * kPi * difference;
  dvec3 xyz(0);
  for (const auto& [channel, value, position, variance] : kMatching) {
    xyz[channel] += value * std::sqrt(2 * kPi * variance) * std::cos(position * phase + shift[channel]) *
                    std::exp(-phase * phase * variance);
  }
  return rgbOfXyz(xyz / kUnit);
}

double square(double x) { return x * x; }

double schlick(double normal, double cosine) { return normal + (1 - normal) * std::pow(1 - cosine, 5); }

}  // namespace

dvec3 ThinFilm::reflectance(double cosine, const dvec3& base) const {
  const double blend = std::clamp(thickness / 0.03, 0.0, 1.0);  // the thinnest films are air
  const double index = std::lerp(1, ior, blend * blend * (3 - 2 * blend));
  const double refracted = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / square(index)));
  const double r12 = schlick(square((index - 1) / (index + 1)), cosine), t121 = 1 - r12;
  dvec3 r23(0), shift(0);
  for (int c = 0; c < 3; ++c) {
    const double root = std::sqrt(std::min(base[c] + 0.0001, 0.9999));
    const double behind = (1 + root) / (1 - root);
    r23[c] = schlick(square((behind - index) / (behind + index)), refracted);
    shift[c] = kPi + (behind < index ? kPi : 0);
  }
  const dvec3 r123 = glm::clamp(r12 * r23, 1e-5, 0.9999);
  const dvec3 sum = square(t121) * r23 / (1.0 - r123);
  dvec3 result = r12 + sum, amplitude = sum - t121;
  for (int order = 1; order <= 2; ++order) {
    amplitude *= glm::sqrt(r123);
    result += amplitude * 2.0 * sensitivity(order * 2e-9 * index * thickness * refracted, double(order) * shift);
  }
  return glm::clamp(result, 0.0, 1.0);
}

}  // namespace candela::reference
