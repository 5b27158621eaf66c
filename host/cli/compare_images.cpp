// `candela compare A B`: computes the differences between two images, and judges them.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/bad_samples.h"
#include "host/cli/comparison.h"
#include "host/cli/display_choice.h"
#include "host/cli/image_verdict.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/cli/report_page.h"
#include "host/image/flip.h"
#include "host/image/metrics.h"

namespace candela::cli {
namespace {

void writePictures(const Arguments& arguments, const image::Image& a, const image::Image& reference,
                   const image::FlipResult& flip) {
  constexpr image::DisplayTransform kAsTheyAre{};  // the pictures are already display-referred
  if (!arguments.differenceFile.empty()) {
    writeImage(arguments.differenceFile, differencePicture(a, reference), kAsTheyAre);
  }
  if (!arguments.flipFile.empty()) writeImage(arguments.flipFile, errorPicture(flip), kAsTheyAre);
}

}  // namespace

ExitCode compareImageFiles(const Arguments& arguments, const Log& log) {
  for (const auto& file : {arguments.differenceFile, arguments.flipFile}) {
    if (!file.empty()) requireWritableImage(file);
  }
  if (!arguments.report.empty()) requireWritableFile(arguments.report);
  requireWritableReport(arguments.json);
  const image::Image a = image::readImage(arguments.files[0]);
  const image::Image reference = image::readImage(arguments.files[1]);
  const image::ImageComparison comparison = compareImages(a, reference);
  const image::DisplayTransform display = chooseDisplay(arguments, reference);
  const image::FlipResult flip = computeFlip(displayed(a, display), displayed(reference, display));
  const ImageVerdict verdict = judgeImages(arguments, a, reference, comparison);

  writePictures(arguments, a, reference, flip);
  if (arguments.wantsText()) {
    std::cout << toText(comparison) << fmt::format("FLIP mean {:.6g}, maximum {:.6g}\n", flip.mean, flip.maximum)
              << toText(verdict) << std::flush;
  }
  nlohmann::ordered_json json = toJson(comparison);
  json["flipMean"] = flip.mean;
  json["flipMaximum"] = flip.maximum;
  const std::uint64_t badSamples = badSampleCount(a) + badSampleCount(reference);
  json["badSamples"] = badSamples;
  addToJson(verdict, json);
  writeJson(arguments.json, json);
  if (!arguments.report.empty()) {
    writeReport(arguments.report, imageReport(arguments, a, reference, comparison, flip, verdict));
  }
  if (badSamples > 0) log.problem(fmt::format("the files contain {} bad samples", badSamples));
  return strictly(verdict.passes() ? ExitCode::done : ExitCode::differ, badSamples, arguments, log);
}

}  // namespace candela::cli
