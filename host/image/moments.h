// Variances of pixels as other renderers store them.
#pragma once
#include "host/image/image.h"

namespace candela::image {

/// Computes `luminanceVariance` from the moments that Mitsuba's integrator `moment` stores: channels NAME.X, NAME.Y and
/// NAME.Z have the mean of a sample, and m2_NAME.X, m2_NAME.Y and m2_NAME.Z that of its square, so that the variance of
/// the luminance is m2_NAME.Y - NAME.Y^2. Rounding may make it negative; it is then 0. Returns false if the image,
/// which must have been read with its layers, has no such channels. Throws FileError if it has those of several
/// integrators.
bool takeMoments(Image& image);

/// Sets `luminanceVariance` to a picture of variances of one sample in the form of Mitsuba's references: computed in X,
/// Y and Z, and then converted to R, G and B like a colour, so that red, green and blue may be negative. Y, which their
/// luminance gives back, is the variance of the luminance. Throws FileError if it is not finite, or negative by more
/// than rounding, or if the places of the pictures differ.
void takeVariances(Image& image, const Image& variances);

}  // namespace candela::image
