// Chooses the display transform by integrator.
#include "host/app/cli/display_choice.h"

#include <fmt/format.h>

#include <cmath>

#include "host/image/exposure.h"
#include "host/image/false_colour.h"

namespace candela::cli {
namespace {

// Returns the value that v = 1 represents (see DisplayTransform).
double valueAtOne(const image::DisplayTransform& display) {
  return display.scale * std::exp2(-double{display.exposure});
}

}  // namespace

image::DisplayTransform chooseDisplay(const PictureArguments& arguments, render::Integrator integrator,
                                      const image::Image& image) {
  image::DisplayTransform display;
  display.exposure = arguments.exposure ? *arguments.exposure : automaticExposure(image);
  if (arguments.toneMap) {
    display.toneMap = *arguments.toneMap;
    return display;
  }
  if (integrator == render::Integrator::depth) display.toneMap = image::ToneMap::depth;
  if (integrator == render::Integrator::cost) display.toneMap = image::ToneMap::heat;
  if (isFalseColour(display.toneMap)) {
    display.exposure = arguments.exposure.value_or(0);
    display.scale = falseColourScale(image, display.toneMap);
  }
  return display;
}

std::string falseColourText(const image::DisplayTransform& display) {
  return fmt::format("{}, scale {:.9g}", display.toneMap == image::ToneMap::depth ? "depth" : "heat",
                     valueAtOne(display));
}

std::string falseColourKey(const image::DisplayTransform& display) {
  if (display.toneMap == image::ToneMap::heat) {
    return fmt::format("cost: the palest colour stands for {:.6g} steps", valueAtOne(display));
  }
  return fmt::format("depth: near is white, far is dark, middle grey stands for {:.6g}", valueAtOne(display));
}

}  // namespace candela::cli
