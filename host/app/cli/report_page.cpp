// Collects the content of the pages on device and reference.
#include "host/app/cli/report_page.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "host/app/cli/commands.h"
#include "host/app/cli/display_choice.h"
#include "host/app/cli/option_table.h"
#include "host/base/atomic_file.h"
#include "host/base/hash_text.h"

namespace candela::cli {
namespace {

using report::Report;

std::string commandText(const Arguments& arguments, std::initializer_list<OptionGroup> groups) {
  std::string line = fmt::format("candela {} {}", commandInfo(commandOf(arguments)).name,
                                 shellQuoted(partOf<GeneralArguments>(arguments).files.front()));
  for (const OptionGroup group : groups) {
    const std::string options = commandLineOf(arguments, group, true);
    if (!options.empty()) line += " " + options;
  }
  return line;
}

// Returns the common part of both reports on a scene: pictures, tracers, hashes.
Report tracersReport(const RenderJob& job, const PictureArguments& picture, const image::Film& device,
                     const image::Film& reference, const render::RenderStatistics& statistics) {
  Report page;
  page.nameA = "Device: " + statistics.device;
  page.nameB = "Reference";
  page.a = toImage(device);
  page.b = toImage(reference);
  page.display = chooseDisplay(picture, job.settings.image.integrator, page.b);
  page.comparison = compareImages(page.a, page.b);
  page.flip = computeFlip(displayed(page.a, page.display), displayed(page.b, page.display));
  const std::string sceneHash = hashText(job.scene().hash);
  page.facts = {{"Tracer", statistics.device, "the reference: double precision, on the CPU"},
                {"Driver", statistics.driver, "none"},
                {"Kernel", nameOf(statistics.kernel), "none"},
                {"Scene hash", sceneHash, sceneHash},
                {"Film hash", hashText(device.hash()), hashText(reference.hash())}};
  return page;
}

std::string agreementSentence(const verify::AgreementReport& agreement) {
  const verify::RegionResult& image = agreement.image();
  return fmt::format("At one sample {}. At {} samples the means differ by {:+.2g} % ({}; rounding may cause {:.2g} %).",
                     agreement.pixels.decisions.text(), agreement.samples, 100 * image.relativeDifference(),
                     verify::pValueText(image.test.pValue),
                     image.referenceMean == 0 ? 0 : 100 * image.margin / std::abs(image.referenceMean));
}

void addPaths(const verify::PixelAgreement& paths, Report& page) {
  page.figures.push_back({"Equal pixels at one sample",
                          fmt::format("{} of {} ({:.3f} %)", paths.equal, paths.pixels, 100 * paths.equalFraction())});
  page.figures.push_back({"Equal lit pixels", fmt::format("{} of {} ({:.3f} %)", paths.litEqual, paths.lit,
                                                          100 * paths.litEqualFraction())});
  page.figures.push_back({"Decidable pixels", paths.decisions.text()});
  for (const std::string& line : paths.undecided.lines()) page.figures.push_back({"Undecidable pixels", line});
  page.figures.push_back({"First differences of the other pixels", paths.causesText()});
}

}  // namespace

Report agreementReport(const CompareArguments& arguments, const RenderJob& job,
                       const verify::AgreementReport& agreement) {
  Report page = tracersReport(job, arguments, agreement.deviceFilm, agreement.referenceFilm,
                              agreement.deviceStatistics);
  page.title = job.scene().name + ": device and reference, equal random numbers";
  page.outcome = report::outcomeOf(agreement.conclusion());
  page.verdict = agreementSentence(agreement);
  if (agreement.doubt() != verify::Doubt::none) page.verdict = agreement.verdict() + " " + page.verdict;
  addPaths(agreement.pixels, page);
  page.figures.push_back({"Samples per pixel, each side", fmt::to_string(agreement.samples)});
  page.figures.push_back({"Seed", fmt::to_string(job.settings.image.seed)});
  page.commands = {commandText(arguments, {OptionGroup::image, OptionGroup::sceneFile, OptionGroup::execution})};
  return page;
}

Report verificationReport(const VerifyArguments& arguments, const RenderJob& job,
                          const verify::VerifyReport& verification) {
  const verify::LightTestResult& light = verification.light;
  Report page = tracersReport(job, {}, light.deviceFilm, light.referenceFilm, light.deviceStatistics);
  page.title = job.scene().name + ": the verdict on the device";
  page.outcome = report::outcomeOf(verification.conclusion());
  page.verdict = verification.verdict();
  page.tests = light;
  addPaths(verification.paths, page);
  page.figures.push_back(
      {"Samples per pixel, each side", fmt::format("{} in {} looks", light.samplesPerPixel, light.looks)});
  page.figures.push_back({"Seed", fmt::format("{}; each batch derives its own seed from it", job.settings.image.seed)});
  page.figures.push_back({"Alpha and bias", fmt::format("{:g}, {:g}", verification.options.alpha, light.bias)});
  if (verification.exact) {
    const verify::ExactTest& exact = *verification.exact;
    page.figures.push_back(
        {"Exact result",
         fmt::format("{:.6g}; device {:.6g} (p = {:.1e}), reference {:.6g} (p = {:.1e})", exact.expected, exact.device,
                     exact.devicePValue, exact.reference, exact.referencePValue)});
  }
  page.commands = {commandText(
      arguments, {OptionGroup::image, OptionGroup::sceneFile, OptionGroup::execution, OptionGroup::verification})};
  return page;
}

void writeReport(const std::filesystem::path& file, const Report& report) {
  const std::string page = toHtml(report);
  writeFileAtomically(file, std::as_bytes(std::span(page)));
}

}  // namespace candela::cli
