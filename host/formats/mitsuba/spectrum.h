// Spectra as colours, as the RGB mode of Mitsuba converts them.
#pragma once
#include <glm/glm.hpp>

#include "host/formats/mitsuba/object.h"

namespace candela::mitsuba {

/// The kind of quantity that a spectrum states.
enum class ColourUse {
  reflectance,  ///< from 0 to 1
  emission,     ///< >= 0, relative to no illuminant
  unbounded     ///< such as an index of refraction
};

/// Returns linear RGB: the integral over 360 to 830 nm with the CIE 1931 observer, for other uses than emission below
/// the illuminant D65. Colours outside of sRGB are limited to 0, reflectances also to 1. One value alone is grey, or
/// for emission the colour of a constant spectrum, which is reddish in sRGB.
glm::dvec3 rgbOf(const Samples& samples, ColourUse use);

/// Returns whether an object is a spectrum rather than a texture with an image: "uniform", "blackbody", ...
bool isSpectrum(const Object& object);

/// Returns the colour of a number, of an <rgb>, of a <spectrum> or of an object for which isSpectrum() holds. Throws
/// PlacedError for another value, and for colours out of range, which with `--lenient` are limited.
glm::dvec3 colourOf(const Property& property, ColourUse use, Report& report);

}  // namespace candela::mitsuba
