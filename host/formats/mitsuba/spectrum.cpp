// Integrates spectra.
#include "host/formats/mitsuba/spectrum.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/quote.h"
#include "host/formats/mitsuba/attributes.h"
#include "host/formats/mitsuba/observer_table.h"

namespace candela::mitsuba {
namespace {

constexpr std::array<std::string_view, 7> kSpectra{"uniform", "srgb",      "d65",        "blackbody",
                                                   "regular", "irregular", "rawconstant"};

constexpr int kSteps = 1000;

/// The integrals of the functions y of the observer, and y times D65, are normalised to 1 by these (the latter divides
/// D65 so that white has the luminance 1).
constexpr double kLuminanceIntegral = 106.7502593994140625;
constexpr double kIlluminantMean = 98.99741751876255;

/// From XYZ to linear sRGB, with the coefficients of IEC 61966-2-1's primaries and white point to six digits.
glm::dvec3 toRgb(const glm::dvec3& xyz) {
  return {3.240479 * xyz.x - 1.537150 * xyz.y - 0.498535 * xyz.z,
          -0.969256 * xyz.x + 1.875991 * xyz.y + 0.041556 * xyz.z,
          0.055648 * xyz.x - 0.204043 * xyz.y + 1.057311 * xyz.z};
}

ObserverRow observerAt(double wavelength) {
  const double position = (wavelength - kFirstWavelength) / (kLastWavelength - kFirstWavelength) *
                          (kObserver.size() - 1.0);
  const auto i = std::min(static_cast<std::size_t>(position), kObserver.size() - 2);
  const double t = position - static_cast<double>(i);
  const auto mix = [&](double ObserverRow::*member) {
    return (1 - t) * kObserver[i].*member + t * kObserver[i + 1].*member;
  };
  return {mix(&ObserverRow::x), mix(&ObserverRow::y), mix(&ObserverRow::z), mix(&ObserverRow::d65)};
}

/// Integrates a function of the wavelength at 1000 points, of which the last one counts once more, as Mitsuba does.
template <class Function>
glm::dvec3 integral(const Function& valueAt, bool hasIlluminant) {
  glm::dvec3 xyz(0);
  for (int i = 0; i < kSteps; ++i) {
    const double wavelength = kFirstWavelength + i / (kSteps - 1.0) * (kLastWavelength - kFirstWavelength);
    const ObserverRow observer = observerAt(wavelength);
    const double value = valueAt(wavelength) * (hasIlluminant ? observer.d65 / kIlluminantMean : 1);
    xyz += value * glm::dvec3(observer.x, observer.y, observer.z);
  }
  return toRgb(xyz * ((kLastWavelength - kFirstWavelength) / kLuminanceIntegral / kSteps));
}

glm::dvec3 limited(const glm::dvec3& rgb, ColourUse use) {
  return use == ColourUse::reflectance ? glm::clamp(rgb, 0.0, 1.0) : glm::max(rgb, 0.0);
}

double interpolated(const std::vector<std::pair<double, double>>& values, double wavelength) {
  if (wavelength < values.front().first || wavelength > values.back().first) return 0;
  const auto after = std::ranges::upper_bound(values, wavelength, {}, [](const auto& pair) { return pair.first; });
  if (after == values.end()) return values.back().second;
  const auto& [w0, v0] = *(after - 1);
  const auto& [w1, v1] = *after;
  return v0 + (v1 - v0) * (wavelength - w0) / (w1 - w0);
}

/// Planck's law, in W/(sr m^2 nm).
double planck(double nanometres, double kelvin) {
  constexpr double kSpeed = 2.99792458e8, kPlanck = 6.62607015e-34, kBoltzmann = 1.380649e-23;
  const double wavelength = nanometres * 1e-9;
  return 2e-9 * kPlanck * kSpeed * kSpeed / std::pow(wavelength, 5) /
         std::expm1(kPlanck * kSpeed / kBoltzmann / (wavelength * kelvin));
}

glm::dvec3 blackbody(const Object& object) {
  const double kelvin = object.number("temperature", 0);
  if (!(kelvin > 0)) throw PlacedError{object.place, "the temperature of a black body is positive"};
  const double first = object.number("wavelength_min", kFirstWavelength);
  const double last = object.number("wavelength_max", kLastWavelength);
  const auto valueAt = [&](double w) { return w >= first && w <= last ? planck(w, kelvin) : 0; };
  return object.number("scale", 1) * limited(integral(valueAt, false), ColourUse::emission);
}

Samples listOf(const Object& object) {
  Samples samples;
  const std::vector<double> values = numbersOf(object.text("values", ""), object.place);
  if (values.size() < 2) throw PlacedError{object.place, "the spectrum has fewer than two values"};
  std::vector<double> wavelengths;
  if (object.type == "irregular") {
    wavelengths = numbersOf(object.text("wavelengths", ""), object.place);
  } else {
    const double first = object.number("wavelength_min", kFirstWavelength);
    const double last = object.number("wavelength_max", kLastWavelength);
    for (std::size_t i = 0; i < values.size(); ++i) {
      wavelengths.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(values.size() - 1));
    }
  }
  if (wavelengths.size() != values.size()) {
    throw PlacedError{object.place,
                      fmt::format("the spectrum has {} wavelengths and {} values", wavelengths.size(), values.size())};
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i > 0 && !(wavelengths[i] > wavelengths[i - 1]))
      throw PlacedError{object.place, "the wavelengths of the spectrum do not rise"};
    samples.values.emplace_back(wavelengths[i], values[i]);
  }
  return samples;
}

glm::dvec3 colourOfObject(const Object& object, ColourUse use, Report& report) {
  const auto nested = [&](const char* name, double absent) {
    const Property* const property = object.find(name);
    return property ? colourOf(*property, use, report) : glm::dvec3(absent);
  };
  if (object.type == "uniform") {
    object.ignore({"wavelength_min", "wavelength_max"}, report);
    return glm::dvec3(object.number("value", 1));
  }
  if (object.type == "srgb") {
    object.ignore({"unbounded"}, report);
    return nested("color", 1);
  }
  if (object.type == "d65") return object.number("scale", 1) * nested("color", 1);
  if (object.type == "blackbody") return blackbody(object);
  if (object.type == "rawconstant") {
    const Property* const value = object.find("value");
    if (value && std::holds_alternative<glm::dvec3>(value->value)) return object.vector("value", glm::dvec3(0));
    return glm::dvec3(object.number("value", 1));
  }
  const Property* const value = object.find("value");
  return value ? colourOf(*value, use, report) : rgbOf(listOf(object), use);
}

glm::dvec3 anyColour(const Property& property, ColourUse use, Report& report) {
  if (const auto* const number = std::get_if<double>(&property.value)) return glm::dvec3(*number);
  if (const auto* const integer = std::get_if<std::int64_t>(&property.value)) {
    return glm::dvec3(static_cast<double>(*integer));
  }
  if (const auto* const rgb = std::get_if<Rgb>(&property.value)) return rgb->colour;
  if (const auto* const samples = std::get_if<Samples>(&property.value)) return rgbOf(*samples, use);
  const auto* const object = std::get_if<const Object*>(&property.value);
  if (object && isSpectrum(**object)) {
    const glm::dvec3 colour = colourOfObject(**object, use, report);
    (*object)->reportUnused(report);
    return colour;
  }
  throw PlacedError{property.place, fmt::format("{} is not a colour or a number", scene::quote(property.name))};
}

}  // namespace

glm::dvec3 rgbOf(const Samples& samples, ColourUse use) {
  const bool isEmission = use == ColourUse::emission;
  if (samples.values.size() == 1) {
    const double value = samples.values.front().second;
    return isEmission ? value * toRgb(glm::dvec3(1)) : glm::dvec3(value);
  }
  return limited(integral([&](double w) { return interpolated(samples.values, w); }, !isEmission), use);
}

bool isSpectrum(const Object& object) {
  return object.tag == "texture" && std::ranges::find(kSpectra, object.type) != kSpectra.end();
}

glm::dvec3 colourOf(const Property& property, ColourUse use, Report& report) {
  const glm::dvec3 colour = anyColour(property, use, report);
  const bool isNegative = glm::any(glm::lessThan(colour, glm::dvec3(0)));
  const bool isLarge = use == ColourUse::reflectance && glm::any(glm::greaterThan(colour, glm::dvec3(1)));
  const bool isHuge = glm::any(glm::greaterThan(colour, glm::dvec3(1e30)));
  if (isNegative || isLarge || isHuge) {
    report.deviate(property.place,
                   fmt::format("{} is out of range: {}", scene::quote(property.name),
                               isLarge      ? "a reflectance is at most 1"
                               : isNegative ? "a colour is not negative"
                                            : "it is above 1e30"),
                   "limits it");
  }
  return glm::clamp(colour, 0.0, use == ColourUse::reflectance ? 1.0 : 1e30);
}

}  // namespace candela::mitsuba
