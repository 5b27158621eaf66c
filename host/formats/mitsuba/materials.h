// Materials that Mitsuba knows by name: metals and dielectrics.
#pragma once
#include <string>

#include "host/formats/mitsuba/object.h"
#include "host/scene/surface_parameters.h"

namespace candela::mitsuba {

/// The least index of refraction of a conductor: one of 0 has no reflectance that single precision could compute.
inline constexpr float kMinIor = 1e-3f;

/// Returns the complex index of refraction of a metal or another conductor ("Cu", "Au", "Al", ...). The table has the
/// RGB values that Mitsuba's RGB mode computes from measured spectra (luxpop.com; Palik, "Handbook of Optical Constants
/// of Solids", 1985 and 1991): the integrals of rgbOf() without an illuminant. Names ending in "_palik" are known, too.
/// Throws PlacedError, at the place of the property, for an unknown name.
scene::Conductor metalOf(const Property& property, const std::string& name);

/// Returns an index of refraction: a number, or that of a material by name ("bk7", "water", ...) at 589 nm (Hecht,
/// "Optics", 4th edition, 2002). `absent`: the name if there is no such property. Throws PlacedError.
double iorOf(const Object& object, const char* property, const char* absent);

}  // namespace candela::mitsuba
