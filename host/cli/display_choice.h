// How 8-bit files show an image, where the command line leaves that open.
#pragma once
#include <string>

#include "host/cli/arguments.h"

namespace candela::cli {

/// What the options say; but if there is no --tonemap, depths and costs get the false colours made for them, scaled to
/// the image.
image::DisplayTransform chooseDisplay(const Arguments& arguments, const image::Image& image);

/// A false colour with its scale, as metadata: "heat, scale 213".
std::string falseColourText(const image::DisplayTransform& display);
/// What lets a person read numbers off the picture: "cost: the palest colour stands for 213 steps".
std::string falseColourKey(const image::DisplayTransform& display);

}  // namespace candela::cli
