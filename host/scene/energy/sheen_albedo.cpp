// Quadrature over the hemisphere.
#include "host/scene/energy/sheen_albedo.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace candela::energy {
namespace {

// The fit of Conty Estevez and Kulla for the fibres' masking.
class FibreMasking {
 public:
  explicit FibreMasking(double alpha) : weight_((1 - alpha) * (1 - alpha)), middle_(exponent(0.5)) {}

  double lambda(double cosine) const {
    return std::exp(cosine < 0.5 ? exponent(cosine) : 2 * middle_ - exponent(1 - cosine));
  }

 private:
  double exponent(double x) const {
    const double a = std::lerp(21.5473, 25.3245, weight_), b = std::lerp(3.82987, 3.32435, weight_);
    const double power = std::lerp(0.19823, 0.16801, weight_);
    const double slope = std::lerp(-1.97760, -1.27393, weight_), offset = std::lerp(-4.32054, -4.85967, weight_);
    return a / (1 + b * std::pow(x, power)) + slope * x + offset;
  }

  double weight_;
  double middle_;
};

constexpr double kLowestCosine = 0.001;  // of docs/light-transport.md

std::vector<double> azimuthCosines(int spokes) {
  std::vector<double> cosines;
  for (int spoke = 0; spoke < spokes; ++spoke) cosines.push_back(std::cos(std::numbers::pi * (spoke + 0.5) / spokes));
  return cosines;
}

}  // namespace

double integrateSheen(double cosine, double alpha, int rings, int spokes) {
  const FibreMasking masking(alpha);
  const double cosO = std::max(cosine, kLowestCosine), sinO = std::sqrt(1 - cosine * cosine);
  const double lambdaO = masking.lambda(cosO);
  const std::vector<double> azimuths = azimuthCosines(spokes);
  double sum = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const double t = (ring + 0.5) / rings, z = t * t;  // the step of z is 2 t / rings
    const double cosI = std::max(z, kLowestCosine), sinI = std::sqrt(1 - z * z);
    double distribution = 0;
    for (const double azimuth : azimuths) {
      const double across = 2 * (1 + cosine * z + sinO * sinI * azimuth);
      const double cosHSquared = across > 0 ? std::min(1.0, std::pow(cosine + z, 2) / across) : 1;
      distribution += std::pow(1 - cosHSquared, 0.5 / alpha);
    }
    sum += distribution * z * 2 * t / (cosO * cosI * (1 + lambdaO + masking.lambda(cosI)));
  }
  return (2 + 1 / alpha) / 4 * sum / (double{1} * rings * spokes);  // 2 pi over spokes, and 1 / (2 pi) of the density
}

}  // namespace candela::energy
