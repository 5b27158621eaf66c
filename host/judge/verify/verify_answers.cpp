// The answers of a verification in words.
#include "host/judge/verify/verify_answers.h"

#include <fmt/format.h>

namespace candela::verify {
namespace {

std::size_t differingTiles(const LightTestResult& light) {
  std::size_t count = 0;
  for (const RegionResult& result : light.regions) count += result.differs && result.region.tileSize > 0 ? 1 : 0;
  return count;
}

const char* answerText(bool agrees, bool isOpen) {
  if (!agrees) return "NO";
  return isOpen ? "not decided" : "yes";
}

}  // namespace

std::string pathsText(const VerifyReport& report) {
  const PixelAgreement& paths = report.paths;
  std::string text = fmt::format("1 Same numbers, same paths?  {}: {}\n",
                                 !paths.decisions.isPossible ? "not asked"
                                 : paths.agree()             ? "yes"
                                                             : "NO",
                                 paths.decisions.summary());
  for (const std::string& line : paths.decisions.details()) text += fmt::format("{:29}{}\n", "", line);
  for (const std::string& line : paths.undecided.lines()) text += fmt::format("{:29}{}\n", "", line);
  return text + fmt::format(
                    "                             {:.3f} % of {} pixels are equal to {:.0e}\n"
                    "                             first differences of the others:{}\n",
                    100 * paths.equalFraction(), paths.pixels, kRelativeTolerance, paths.causesText());
}

std::string lightText(const VerifyReport& report) {
  const LightTestResult& light = report.light;
  std::string text = fmt::format(
      "2 Same light?                {}: {} samples per pixel on each side, {} look{}, {} tests at p < {:.1e}\n",
      answerText(!light.differs(), report.doubt() != Doubt::none), light.samplesPerPixel, light.looks,
      light.looks == 1 ? "" : "s", light.regions.size(), light.level);
  text += fmt::format("                             {}\n", differenceText(light.image()));
  if (report.doubt() != Doubt::none) {
    text += fmt::format("                             {}\n",
                        doubtText(report.doubt(), light.image(), report.options.maxOverlooked()));
  }
  const RegionResult& most = light.mostSignificant();
  if (&most != &light.image()) text += fmt::format("                             {}\n", differenceText(most));
  if (const std::size_t tiles = differingTiles(light))
    text += fmt::format("                             {} tiles differ\n", tiles);
  if (light.badSamples.samples() > 0)
    text += fmt::format("                             {} bad samples\n", light.badSamples.samples());
  return text;
}

std::string exactText(const VerifyReport& report) {
  if (!report.exact) return "3 Right light?               the scene does not state an exact result\n";
  const ExactTest& exact = *report.exact;
  std::string text = fmt::format(
      "3 Right light?               {}: exact {:.6g}, device {:.6g} (p = {:.1e}), reference {:.6g} (p = {:.1e})\n",
      answerText(exact.isMet(), report.isExactOpen()), exact.expected, exact.device, exact.devicePValue,
      exact.reference, exact.referencePValue);
  if (exact.samplesPerPixel == 0) return text;
  text += fmt::format("                             {} more samples per pixel on the device", exact.samplesPerPixel);
  if (exact.referenceSamplesPerPixel > 0) text += fmt::format(", {} on the reference", exact.referenceSamplesPerPixel);
  return text + "\n";
}

}  // namespace candela::verify
