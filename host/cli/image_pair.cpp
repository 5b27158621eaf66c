// Compares two images.
#include "host/cli/image_pair.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "host/cli/display_choice.h"
#include "host/core/report_head.h"

namespace candela::cli {

ImagePair comparePair(const Arguments& arguments, const image::Image& a, const image::Image& reference) {
  ImagePair pair;
  pair.comparison = compareImages(a, reference);
  const image::DisplayTransform display = chooseDisplay(arguments, reference);
  pair.flip = computeFlip(displayed(a, display), displayed(reference, display));
  pair.verdict = judgeImages(arguments, a, reference, pair.comparison);
  pair.badSamples = badSampleCount(a) + badSampleCount(reference);
  return pair;
}

std::string toText(const ImagePair& pair) {
  return toText(pair.comparison) +
         fmt::format("FLIP                  mean {:.6g}, maximum {:.6g}\n", pair.flip.mean, pair.flip.maximum) +
         toText(pair.verdict);
}

nlohmann::ordered_json toJson(const ImagePair& pair) {
  nlohmann::ordered_json json = reportHead("candela-compare-images/1");
  json.update(toJson(pair.comparison));
  json["flipMean"] = pair.flip.mean;
  json["flipMaximum"] = pair.flip.maximum;
  json["badSamples"] = pair.badSamples;
  addToJson(pair.verdict, json);
  return json;
}

}  // namespace candela::cli
