// `candela compare A B`: computes the differences between two images, and judges them.
#include <fmt/format.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "host/cli/bad_samples.h"
#include "host/cli/comparison.h"
#include "host/cli/conclusion_code.h"
#include "host/cli/image_pair.h"
#include "host/cli/json_output.h"
#include "host/cli/output_check.h"
#include "host/cli/report_page.h"

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
  const ImagePair pair = comparePair(arguments, a, reference);

  writePictures(arguments, a, reference, pair.flip);
  if (arguments.wantsText()) std::cout << toText(pair) << std::flush;
  writeJson(arguments.json, toJson(pair));
  if (!arguments.report.empty()) {
    writeReport(arguments.report, imageReport(arguments, a, reference, pair.comparison, pair.flip, pair.verdict));
  }
  if (pair.badSamples() > 0) log.problem(fmt::format("the files contain {} bad samples", pair.badSamples()));
  return strictly(exitCodeOf(pair.verdict.conclusion(), arguments), pair.badSamples(), arguments, log);
}

}  // namespace candela::cli
