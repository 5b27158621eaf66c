// Pictures of quantities other than light: one number per pixel, shown as a shade of grey or a colour.
#pragma once
#include "host/image/image.h"

namespace candela::image {

bool isFalseColour(ToneMap toneMap);

/// Returns the sRGB signal, in [0, 1], of a value >= 0 that was divided by the scale. `toneMap` is a false colour.
glm::dvec3 falseColour(double value, ToneMap toneMap);

/// Returns a suitable scale for an image. `heat`: the maximum. `depth`: the median of the positive values (the upper
/// one of an even number), since the depth of a plane that reaches the horizon has no useful maximum. 1 if no value is
/// positive and finite.
float falseColourScale(const Image& image, ToneMap toneMap);

}  // namespace candela::image
