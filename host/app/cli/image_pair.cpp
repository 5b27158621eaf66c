// Compares two images.
#include "host/app/cli/image_pair.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "host/app/cli/display_choice.h"
#include "host/base/report_head.h"
#include "host/image/alignment.h"
#include "host/trace/render/bad_sample_tally.h"

namespace candela::cli {
namespace {

ImageBadSamples badSamplesOf(const image::Image& image) {
  ImageBadSamples bad;
  for (std::size_t i = 0; i < image.badSampleCounts.size(); ++i) {
    const std::uint32_t samples = image.badSampleCounts[i];
    if (samples == 0) continue;
    bad.samples += samples;
    if (bad.pixels++ >= render::BadSampleTally::kPixelsKept) continue;
    bad.firstPixels.push_back({image.origin.x + static_cast<std::int64_t>(i % image.width),
                               image.origin.y + static_cast<std::int64_t>(i / image.width), samples});
  }
  return bad;
}

nlohmann::ordered_json toJson(const ImageBadSamples& bad) {
  nlohmann::ordered_json json{
      {"samples", bad.samples}, {"pixels", bad.pixels}, {"firstPixels", nlohmann::ordered_json::array()}};
  for (const auto& [x, y, samples] : bad.firstPixels) {
    json["firstPixels"].push_back({{"x", x}, {"y", y}, {"samples", samples}});
  }
  return json;
}

}  // namespace

ImagePair comparePair(const CompareArguments& arguments, image::Image& a, image::Image& reference) {
  ImagePair pair;
  pair.verdict.whyApart = image::whyApart(a, reference);
  if (!pair.verdict.whyApart.empty()) return pair;
  cutToCommonWindow(a, reference);
  pair.window = windowOf(a);
  pair.frame = frameOf(a);
  pair.channels = compareChannels(a, reference, arguments.channels);
  pair.comparison = compareImages(a, reference);
  const image::DisplayTransform display = chooseDisplay(arguments, render::Integrator::path, reference);
  pair.flip = computeFlip(displayed(a, display), displayed(reference, display));
  pair.verdict = judgeImages(arguments, a, reference, pair.comparison, pair.channels);
  pair.badInA = badSamplesOf(a);
  pair.badInB = badSamplesOf(reference);
  return pair;
}

std::string toText(const ImagePair& pair) {
  if (!pair.verdict.whyApart.empty()) return toText(pair.verdict);
  const image::ChannelComparison& channels = pair.channels;
  const bool isIdentical = image::isIdentical(pair.comparison) && channels.onlyInA.empty() &&
                           channels.onlyInB.empty() &&
                           std::ranges::all_of(channels.channels, &image::ChannelDifference::isEqual);
  std::string text = isIdentical ? "the images are identical\n" : "";
  if (pair.window != pair.frame) {
    text += fmt::format("window                {} of the frame {}\n", boxText(pair.window), boxText(pair.frame));
  }
  return text + toText(pair.comparison) + toText(channels) +
         fmt::format("FLIP                  mean {:.6g}, maximum {:.6g}\n", pair.flip.mean, pair.flip.maximum) +
         toText(pair.verdict);
}

nlohmann::ordered_json toJson(const ImagePair& pair) {
  nlohmann::ordered_json json = reportHead("candela-compare-images/1");
  if (!pair.verdict.whyApart.empty()) {
    addToJson(pair.verdict, json);
    return json;
  }
  json["window"] = boxText(pair.window);
  json["frame"] = boxText(pair.frame);
  json.update(toJson(pair.comparison));
  addToJson(pair.channels, json);
  json["meanFlip"] = pair.flip.mean;
  json["maxFlip"] = pair.flip.maximum;
  json["badSamples"] = {{"a", toJson(pair.badInA)}, {"b", toJson(pair.badInB)}};
  addToJson(pair.verdict, json);
  return json;
}

}  // namespace candela::cli
