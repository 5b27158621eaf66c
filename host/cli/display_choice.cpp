// Transforms by integrator, and what is said about them.
#include "host/cli/display_choice.h"

#include <fmt/format.h>

#include <cmath>

#include "host/image/false_colour.h"

namespace candela::cli {
namespace {

// What v = 1 stands for (see DisplayTransform).
double valueAtOne(const DisplayTransform& display) { return display.scale * std::exp2(-double{display.exposure}); }

}  // namespace

DisplayTransform chooseDisplay(const Arguments& arguments, const Image& image) {
  DisplayTransform display = arguments.display;
  if (arguments.given.contains("--tonemap")) return display;
  if (arguments.settings.integrator == Integrator::depth) display.toneMap = ToneMap::depth;
  if (arguments.settings.integrator == Integrator::cost) display.toneMap = ToneMap::heat;
  if (isFalseColour(display.toneMap)) display.scale = falseColourScale(image, display.toneMap);
  return display;
}

std::string falseColourText(const DisplayTransform& display) {
  return fmt::format("{}, scale {:.9g}", display.toneMap == ToneMap::depth ? "depth" : "heat", valueAtOne(display));
}

std::string falseColourKey(const DisplayTransform& display) {
  if (display.toneMap == ToneMap::heat) {
    return fmt::format("cost: the palest colour stands for {:.6g} steps", valueAtOne(display));
  }
  return fmt::format("depth: near is white, far is dark, middle grey stands for {:.6g}", valueAtOne(display));
}

}  // namespace candela::cli
