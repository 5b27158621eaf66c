// Chooses how 8-bit files show an image, if the command line does not.
#pragma once
#include <string>

#include "host/app/cli/arguments.h"

namespace candela::cli {

/// Returns the transform of the options for an image of an integrator; without --tonemap, depths and costs get their
/// false colours, scaled to the image. `--exposure auto` is computed from the image, and is 0 for false colours.
image::DisplayTransform chooseDisplay(const PictureArguments& arguments, render::Integrator integrator,
                                      const image::Image& image);

/// Returns a false colour with its scale, as metadata: "heat, scale 213".
std::string falseColourText(const image::DisplayTransform& display);
/// Returns a legend for the colours: "cost: the palest colour stands for 213 steps".
std::string falseColourKey(const image::DisplayTransform& display);

}  // namespace candela::cli
