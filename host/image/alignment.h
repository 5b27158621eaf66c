// Lays two pictures over each other by the places of their pixels.
#pragma once
#include <string>

#include "host/image/image.h"

namespace candela::image {

/// Returns why two pictures cannot be compared pixel by pixel, as a sentence about "A" and "B"; empty if they can.
/// Their frames must be equal, and the pixels of one must lie within those of the other: either the windows are equal,
/// or one picture is a crop of the other. Equal pixels in different places are a difference.
std::string whyApart(const Image& a, const Image& b);

/// Cuts both pictures, for which whyApart() is empty, to their common window.
void cutToCommonWindow(Image& a, Image& b);

}  // namespace candela::image
