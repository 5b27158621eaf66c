// Pictures of quantities that are no light: one number a pixel, shown as a shade or a colour of its own.
#pragma once
#include "host/image/image.h"

namespace candela::image {

bool isFalseColour(ToneMap toneMap);

/// The sRGB signal, in [0, 1], of a value that was divided by the scale; value >= 0, `toneMap` a false colour.
glm::dvec3 falseColour(double value, ToneMap toneMap);

/// The scale that suits an image. `heat`: the largest value. `depth`: the median of the positive ones (the upper, if
/// their number is even), since a plane that reaches the horizon has no largest. 1 if no value is positive and finite.
float falseColourScale(const Image& image, ToneMap toneMap);

}  // namespace candela::image
