// Integrates the light that a rough boundary transmits and reflects, over the normals that are visible.
#include "host/scene/plastic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace candela::scene {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr std::size_t kSlopes = 192;   // of normals, in units of alpha
constexpr std::size_t kAzimuths = 64;  // of normals, over half of the circle: the other half is its mirror image
constexpr double kLargestBeckmannSlope = 5.5;  // which 7e-14 of the normals exceed
constexpr double kMinCosine = 1e-6;

/// A normal by its slope, the tangent of its angle to z; `weight` is the integral of D cosH over its cell.
struct Slope {
  double tangent;
  double weight;
};

// Midpoints in a variable in which the integrands are smooth at both ends: the angle whose tangent is the slope in
// units of alpha for GGX, the slope itself for Beckmann.
std::vector<Slope> slopesOf(bool isBeckmann, double alpha) {
  std::vector<Slope> slopes;
  for (std::size_t i = 0; i < kSlopes; ++i) {
    const double part = (static_cast<double>(i) + 0.5) / kSlopes;
    if (isBeckmann) {
      const double t = kLargestBeckmannSlope * part;
      slopes.push_back({alpha * t, 2 * t * std::exp(-t * t) * kLargestBeckmannSlope / kSlopes});
    } else {
      const double angle = kPi / 2 * part;
      slopes.push_back({alpha * std::tan(angle), std::sin(2 * angle) * kPi / 2 / kSlopes});
    }
  }
  return slopes;
}

/// Reflection or refraction at a smooth boundary.
struct Facet {
  double reflectance;
  double cosTransmitted;
};

// `n`: index of refraction beyond the boundary relative to the near side.
Facet facetAt(double cosine, double n) {
  const double squared = 1 - (1 - cosine * cosine) / (n * n);
  if (squared <= 0) return {1, 0};
  const double beyond = std::sqrt(squared);
  const double across = (cosine - n * beyond) / (cosine + n * beyond);
  const double along = (n * cosine - beyond) / (n * cosine + beyond);
  return {(across * across + along * along) / 2, beyond};
}

class RoughBoundary {
 public:
  RoughBoundary(bool isBeckmann, double alpha)
      : isBeckmann_(isBeckmann), alpha_(alpha), slopes_(slopesOf(isBeckmann, alpha)) {}

  double transmittance(double cosine, double n) const {
    return meanOverVisible(cosine, [&](double cosAtFacet, double facetZ) {
      const Facet facet = facetAt(cosAtFacet, n);
      const double z = (cosAtFacet / n - facet.cosTransmitted) * facetZ - cosine / n;
      return z < 0 ? (1 - facet.reflectance) * masking(-z) : 0;
    });
  }
  double reflectance(double cosine, double n) const {
    return meanOverVisible(cosine, [&](double cosAtFacet, double facetZ) {
      const double z = 2 * cosAtFacet * facetZ - cosine;
      return z > 0 ? facetAt(cosAtFacet, n).reflectance * masking(z) : 0;
    });
  }

 private:
  // Smith's masking for one direction with this cosine; for Beckmann, the rational function of Walter et al. (2007).
  double masking(double cosine) const {
    const double slope = alpha_ * std::sqrt(std::max(0.0, 1 - cosine * cosine)) / cosine;
    if (!isBeckmann_) return 2 / (1 + std::hypot(1.0, slope));
    if (slope <= 1 / 1.6) return 1;
    const double a = 1 / slope;
    return a * (3.535 + 2.181 * a) / (1 + a * (2.276 + 2.577 * a));
  }

  // Returns the mean of value(w.m, m.z) over the normals m that are visible from a direction w with this cosine.
  template <class Value>
  double meanOverVisible(double cosine, const Value& value) const {
    const double sine = std::sqrt(1 - cosine * cosine);
    double sum = 0, visible = 0;
    for (const Slope& slope : slopes_) {
      const double z = 1 / std::hypot(1.0, slope.tangent);
      for (std::size_t j = 0; j < kAzimuths; ++j) {
        const double azimuth = kPi * (static_cast<double>(j) + 0.5) / kAzimuths;
        const double projected = cosine + sine * slope.tangent * std::cos(azimuth);  // w.m / m.z
        if (projected <= 0) continue;
        visible += slope.weight * projected;
        sum += slope.weight * projected * value(std::min(1.0, projected * z), z);
      }
    }
    return sum / visible;
  }

  bool isBeckmann_;
  double alpha_;
  std::vector<Slope> slopes_;
};

// The fit of Egan and Hilgeman (1973) to the reflectance of a smooth boundary for diffuse light from the inside.
double smoothInternalReflectance(double ior) { return 0.0636 * ior + 0.6681 + (0.7099 - 1.4399 / ior) / ior; }

}  // namespace

Plastic makePlastic(Interface boundary, float roughness, float ior, bool isNonlinear) {
  Plastic plastic{.boundary = boundary, .isNonlinear = isNonlinear};
  if (boundary == Interface::smooth) {
    plastic.internalReflectance = static_cast<float>(smoothInternalReflectance(ior));
    return plastic;
  }
  const double root = std::max(double{roughness}, 0.01);
  const RoughBoundary rough(boundary == Interface::beckmann, root * root);
  double internal = 0;
  for (std::size_t i = 0; i < Plastic::kNodes; ++i) {
    const double cosine = std::max(kMinCosine, static_cast<double>(i) / (Plastic::kNodes - 1));
    plastic.transmittances[i] = static_cast<float>(rough.transmittance(cosine, ior));
    internal += 2 * cosine * rough.reflectance(cosine, 1.0 / ior) / Plastic::kNodes;
  }
  plastic.internalReflectance = static_cast<float>(internal);
  return plastic;
}

}  // namespace candela::scene
