// `candela compare A... --with B...`: tests whether two sets of renders show the same light.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <ostream>

#include "host/app/cli/bad_samples.h"
#include "host/app/cli/comparison.h"
#include "host/app/cli/conclusion_code.h"
#include "host/app/cli/json_output.h"
#include "host/app/cli/output_check.h"
#include "host/app/cli/report_page.h"
#include "host/app/cli/text_output.h"
#include "host/base/report_head.h"
#include "host/base/setting_words.h"
#include "host/image/moments.h"
#include "host/judge/verify/film_test.h"
#include "host/judge/verify/picture_test.h"

namespace candela::cli {
namespace {

// A set, and what its files state about their samples.
struct Side {
  verify::RenderSet renders;
  std::vector<std::uint32_t> sampleCounts;  ///< for each pixel, of all renders; empty if a file does not state them
  std::vector<std::string> seeds;           ///< of Candela's files
  image::Image last;
  std::uint64_t badSamples = 0;
  std::uint64_t badPixels = 0;
};

// Adds the number of samples of the last render.
void addCounts(Side& side) {
  const std::vector<std::uint32_t>& counts = side.last.sampleCounts;
  if (side.renders.count() == 1) side.sampleCounts.resize(counts.size());
  if (counts.empty()) side.sampleCounts.clear();
  for (std::size_t i = 0; i < side.sampleCounts.size(); ++i) {
    side.sampleCounts[i] += std::min(counts[i], std::numeric_limits<std::uint32_t>::max() - side.sampleCounts[i]);
  }
}

void addFile(const std::string& file, const std::vector<std::string>& files, const Log& log, Side& side) {
  side.last = image::readImage(file, image::ImageParts::withLayers);
  const image::Image& render = side.last;
  for (const std::string& warning : render.warnings) log.warning(fmt::format("{}: {}", file, warning));
  if (const auto bias = render.metadata.find(verify::kBiasMetadata); bias != render.metadata.end()) {
    log.warning(fmt::format("{}: it is biased on purpose ({}: {})", file, bias->first, bias->second));
  }
  if (const auto seed = render.metadata.find(verify::kSeedMetadata); seed != render.metadata.end()) {
    side.seeds.push_back(seed->second);
  }
  try {
    side.renders.add(render);
    if (render.luminanceVariance.empty()) takeMoments(side.last);
  } catch (const FileError& error) {
    throw FileError(fmt::format("{}: {}", file, error.what()));
  }
  if (const auto twin = side.renders.twinOfLast()) {
    throw FileError(fmt::format(
        "{}: it equals {}: the renders of a set must have different random numbers; {} compares pictures without noise",
        file, files[*twin], settingWords("tolerance", "0")));
  }
  addCounts(side);
  side.badSamples += badSampleCount(render);
  side.badPixels += static_cast<std::uint64_t>(
      std::ranges::count_if(render.badSampleCounts, [](std::uint32_t count) { return count > 0; }));
}

Side readSide(const std::vector<std::string>& files, const Log& log) {
  Side side;
  for (const std::string& file : files) addFile(file, files, log, side);
  return side;
}

void requireMatching(const CompareArguments& arguments, const verify::RenderSet& a, const verify::RenderSet& b) {
  if (a.window() != b.window() || a.frame() != b.frame()) {
    throw FileError(fmt::format("{}: it has {}, and {} has {}", arguments.others.front(), b.placeText(),
                                arguments.files.front(), a.placeText()));
  }
}

// Returns whether B is one picture with variances.
bool hasPicture(const CompareArguments& arguments, const Side& b) {
  return b.renders.count() == 1 && !arguments.paired &&
         (!arguments.othersVariance.empty() || !b.last.luminanceVariance.empty());
}

void requireVariances(const std::string& file, const image::Image& render) {
  if (const auto reason = verify::whyNotMeasured(file + ":", render)) throw FileError(*reason);
}

// Completes the picture by the options.
void completePicture(const CompareArguments& arguments, image::Image& picture) {
  const std::string& file = arguments.others.front();
  if (!arguments.othersVariance.empty()) {
    try {
      takeVariances(picture, image::readImage(arguments.othersVariance));
    } catch (const FileError& error) {
      throw FileError(fmt::format("{}: {}", arguments.othersVariance.string(), error.what()));
    }
  }
  if (arguments.othersSamples) picture.sampleCounts.assign(picture.rgb.size(), *arguments.othersSamples);
  if (picture.sampleCounts.empty()) {
    throw UsageError(fmt::format("{}: its variances need its number of samples per pixel; {} states it", file,
                                 settingWords("with-spp")));
  }
  requireVariances(file, picture);
}

verify::SamplesOfA samplesOf(const CompareArguments& arguments, Side& a) {
  const std::string& file = arguments.files.front();
  const std::size_t pixels = a.last.rgb.size();
  if (arguments.setSamples) {
    const std::uint64_t all = std::uint64_t{*arguments.setSamples} * a.renders.count();
    a.sampleCounts.assign(
        pixels, static_cast<std::uint32_t>(std::min<std::uint64_t>(all, std::numeric_limits<std::uint32_t>::max())));
  }
  if (a.sampleCounts.empty()) {
    throw UsageError(
        fmt::format("{}: a comparison with one picture needs its number of samples per pixel; {} states it", file,
                    settingWords("set-spp")));
  }
  if (a.renders.count() > 1) return {a.sampleCounts};
  a.last.sampleCounts = a.sampleCounts;
  if (!verify::carriesVariance(a.last)) {
    throw UsageError(
        fmt::format("{}: it has no variances, and a single render without them does not show its noise; "
                    "compare at least two renders with different seeds",
                    file));
  }
  requireVariances(file, a.last);
  return {a.sampleCounts, a.last.luminanceVariance};
}

void requireOtherSeeds(const CompareArguments& arguments, const Side& a, const Side& b) {
  if (b.seeds.empty() || std::ranges::find(a.seeds, b.seeds.front()) == a.seeds.end()) return;
  throw UsageError(
      fmt::format("{}: a render that it is compared with has the same seed, {}, but their noise must be "
                  "independent",
                  arguments.others.front(), b.seeds.front()));
}

verify::SetTestResult compareSides(const CompareArguments& arguments, Side& a, Side& b) {
  const verify::SetTestOptions options{arguments.paired ? verify::SetDesign::paired : verify::SetDesign::independent,
                                       arguments.verification.alpha, arguments.verification.maxOverlooked()};
  if (!hasPicture(arguments, b)) {
    for (const char* option : {"--with-spp", "--set-spp", "--with-variance"}) {
      if (arguments.given.contains(option))
        throw UsageError(fmt::format("{} is for a comparison with one picture that has variances", option));
    }
    return testRenderSets(a.renders, b.renders, options);
  }
  requireOtherSeeds(arguments, a, b);
  completePicture(arguments, b.last);
  return testAgainstPicture(a.renders, samplesOf(arguments, a), b.last, options);
}

void requireSettings(const CompareArguments& arguments) {
  if (arguments.verification.alpha < statistics::kMinPermutationLevel) {
    throw UsageError(fmt::format("{}: the minimum of a permutation test is {:g}",
                                 settingWords("alpha", fmt::format("{:g}", arguments.verification.alpha)),
                                 statistics::kMinPermutationLevel));
  }
  if (arguments.paired && arguments.files.size() != arguments.others.size()) {
    throw UsageError(fmt::format("{}: both sets need equal numbers of renders, and have {} and {}",
                                 settingWords("paired"), arguments.files.size(), arguments.others.size()));
  }
}

// Equal random numbers on both sides make the test of independent sets less sensitive, not wrong.
void noteSharedSeeds(const CompareArguments& arguments, const verify::RenderSet& a, const verify::RenderSet& b,
                     const Log& log) {
  if (arguments.paired) return;
  for (std::size_t i = 0; i < a.count(); ++i) {
    const auto twin = std::ranges::find(b.means(), a.means()[i]);
    if (twin == b.means().end()) continue;
    log.note(fmt::format("{} equals {}: if both sets have the same seeds, {} finds smaller differences",
                         arguments.files[i], arguments.others[static_cast<std::size_t>(twin - b.means().begin())],
                         settingWords("paired")));
    return;
  }
}

void writePictures(const CompareArguments& arguments, const report::Report& page) {
  constexpr image::DisplayTransform kAsTheyAre{};  // the pictures are already display-referred
  if (!arguments.differenceFile.empty()) {
    writeImage(arguments.differenceFile, differencePicture(page.a, page.b), kAsTheyAre);
  }
  if (!arguments.flipFile.empty()) writeImage(arguments.flipFile, errorPicture(page.flip), kAsTheyAre);
  if (!arguments.report.empty()) writeReport(arguments.report, page);
}

nlohmann::ordered_json badSamplesOf(const Side& side) {
  return {{"samples", side.badSamples}, {"pixels", side.badPixels}, {"firstPixels", nlohmann::ordered_json::array()}};
}

nlohmann::ordered_json document(const CompareArguments& arguments, const Side& a, const Side& b,
                                const verify::SetTestResult& result) {
  nlohmann::ordered_json json = reportHead("candela-compare-renders/1");
  json["filesOfA"] = arguments.files;
  json["filesOfB"] = arguments.others;
  json["window"] = boxText(a.renders.window());
  json["frame"] = boxText(a.renders.frame());
  json["badSamples"] = {{"a", badSamplesOf(a)}, {"b", badSamplesOf(b)}};
  json.update(toJson(result));
  return json;
}

}  // namespace

ExitCode compareRenderSets(const CompareArguments& arguments, const Log& log) {
  requireSettings(arguments);
  for (const auto& file : {arguments.differenceFile, arguments.flipFile}) {
    if (!file.empty()) requireWritableImage(file);
  }
  if (!arguments.report.empty()) requireWritableFile(arguments.report);
  requireWritableReport(arguments.json);
  Side a = readSide(arguments.files, log);
  Side b = readSide(arguments.others, log);
  requireMatching(arguments, a.renders, b.renders);
  noteSharedSeeds(arguments, a.renders, b.renders, log);
  const verify::SetTestResult result = compareSides(arguments, a, b);

  if (!arguments.differenceFile.empty() || !arguments.flipFile.empty() || !arguments.report.empty()) {
    writePictures(arguments, renderSetReport(arguments, a.renders, b.renders, result));
  }
  if (wantsText(arguments, {arguments.json}))
    textStream(std::array{arguments.differenceFile, arguments.flipFile}) << toText(result) << std::flush;
  writeJson(arguments.json, document(arguments, a, b, result));
  const std::uint64_t badSamples = a.badSamples + b.badSamples;
  if (badSamples > 0) log.problem(fmt::format("the files contain {} bad samples", badSamples));
  return strictly(exitCodeOf(result.conclusion(), arguments), badSamples, arguments, log);
}

}  // namespace candela::cli
