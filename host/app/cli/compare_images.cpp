// `candela compare A B`: computes the differences between two images, and judges them.
#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <ostream>

#include "host/app/cli/bad_samples.h"
#include "host/app/cli/comparison.h"
#include "host/app/cli/conclusion_code.h"
#include "host/app/cli/image_pair.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/report_page.h"
#include "host/app/cli/text_output.h"

namespace candela::cli {
namespace {

image::Image readPicture(const std::string& file, const Log& log) {
  image::Image picture = image::readImage(file, image::ImageParts::withLayers);
  for (const std::string& warning : picture.warnings) log.warning(fmt::format("{}: {}", file, warning));
  return picture;
}

void writePictures(const CompareArguments& arguments, const image::Image& a, const image::Image& reference,
                   const image::FlipResult& flip) {
  constexpr image::DisplayTransform kAsTheyAre{};  // the pictures are already display-referred
  if (!arguments.differenceFile.empty()) {
    writeImage(arguments.differenceFile, differencePicture(a, reference), kAsTheyAre);
  }
  if (!arguments.flipFile.empty()) writeImage(arguments.flipFile, errorPicture(flip), kAsTheyAre);
}

}  // namespace

ExitCode compareImageFiles(const CompareArguments& arguments, const Log& log) {
  for (const auto& file : {arguments.differenceFile, arguments.flipFile}) {
    if (!file.empty()) requireWritableImage(file);
  }
  if (!arguments.report.empty()) requireWritableFile(arguments.report);
  requireWritableReport(arguments.json);
  image::Image a = readPicture(arguments.files[0], log);
  image::Image reference = readPicture(arguments.files[1], log);
  const ImagePair pair = comparePair(arguments, a, reference);
  const bool isApart = !pair.verdict.whyApart.empty();

  if (!isApart) writePictures(arguments, a, reference, pair.flip);
  if (wantsText(arguments, {arguments.json}))
    textStream(std::array{arguments.differenceFile, arguments.flipFile}) << toText(pair) << std::flush;
  writeJson(arguments.json, toJson(pair));
  if (!arguments.report.empty() && !isApart) {
    writeReport(arguments.report, imageReport(arguments, a, reference, pair.comparison, pair.flip, pair.verdict));
  }
  if (isApart && !(arguments.differenceFile.empty() && arguments.flipFile.empty() && arguments.report.empty())) {
    log.note("without common pixels there is no picture of the difference, and no report; none is written");
  }
  if (pair.badSamples() > 0) log.problem(fmt::format("the files contain {} bad samples", pair.badSamples()));
  return strictly(exitCodeOf(pair.verdict.conclusion(), arguments), pair.badSamples(), arguments, log);
}

}  // namespace candela::cli
