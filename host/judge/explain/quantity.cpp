// Compares the values of one quantity.
#include "host/judge/explain/quantity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "host/base/finite.h"

namespace candela::explain {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double ratio(double difference, double scale) { return scale > 0 ? difference / scale : kInfinity; }

double apartOf(double a, double b) {
  if (a == b || (std::isnan(a) && std::isnan(b))) return 0;
  if (!std::isfinite(a) || !std::isfinite(b)) return kInfinity;
  return ratio(std::abs(a - b), std::max(std::abs(a), std::abs(b)));
}

double channelApart(double a, double b) { return std::abs(a - b) <= verify::kAbsoluteTolerance ? 0 : apartOf(a, b); }

Value valueOf(std::optional<double> number) { return number ? Value{{}, {*number}} : Value{}; }

Value valueOf(const std::optional<glm::dvec3>& v) { return v ? Value{{}, {v->x, v->y, v->z}} : Value{}; }

template <class T, class Apart>
Quantity numbers(std::string name, const std::optional<T>& device, const std::optional<T>& reference, Apart apart) {
  Quantity quantity{std::move(name), Quantity::Kind::number, valueOf(device), valueOf(reference)};
  if (device && reference) quantity.apart = apart(*device, *reference);
  quantity.differs = quantity.apart > kTolerance;
  return quantity;
}

}  // namespace

Quantity decision(std::string name, std::string device, std::string reference) {
  const bool differs = device != reference;
  return {std::move(name), Quantity::Kind::decision, {std::move(device), {}}, {std::move(reference), {}}, 0, differs};
}

Quantity randomNumber(std::string name, std::uint32_t device, std::uint32_t reference) {
  const double a = (device >> 8) * 0x1p-24;
  const double b = (reference >> 8) * 0x1p-24;
  return {std::move(name), Quantity::Kind::randomNumber, valueOf(a), valueOf(b), std::abs(a - b), device != reference};
}

Quantity scalar(std::string name, std::optional<double> device, std::optional<double> reference) {
  return numbers(std::move(name), device, reference, apartOf);
}

Quantity colour(std::string name, std::optional<glm::dvec3> device, std::optional<glm::dvec3> reference) {
  return numbers(std::move(name), device, reference, [](const glm::dvec3& a, const glm::dvec3& b) {
    return std::max({channelApart(a.x, b.x), channelApart(a.y, b.y), channelApart(a.z, b.z)});
  });
}

Quantity vector(std::string name, std::optional<glm::dvec3> device, std::optional<glm::dvec3> reference, double scale) {
  return numbers(std::move(name), device, reference, [=](const glm::dvec3& a, const glm::dvec3& b) {
    if (a == b) return 0.0;
    return isFinite(a) && isFinite(b) ? ratio(glm::length(a - b), scale) : kInfinity;
  });
}

}  // namespace candela::explain
