// Compares the tracers by their pixels and by the light of several samples.
#include "host/judge/verify/agreement.h"

#include <fmt/format.h>

#include <cmath>
#include <span>

#include "host/base/report_head.h"
#include "host/base/setting_words.h"
#include "host/base/statistics/error_rates.h"
#include "host/judge/verify/paired_sums.h"

namespace candela::verify {
namespace {

void testRegions(AgreementReport& report, std::span<const render::Deviation> deviations, double alpha) {
  const std::vector<Region> regions = regionsOf({report.deviceFilm.width(), report.deviceFilm.height()});
  PairedSums sums(regions, report.pixels.referenceMean);
  sums.add(report.deviceFilm, report.referenceFilm, deviations);
  report.level = statistics::sidakLevel(alpha, regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) report.regions.push_back(sums.test(i, report.level));
}

}  // namespace

AgreementReport compareTracers(const scene::Scene& scene, const render::RenderSettings& settings,
                               render::Renderer& device, render::Renderer& reference, const LightTestOptions& options,
                               const render::RenderControl& control) {
  AgreementReport report;
  report.maxOverlooked = options.maxOverlooked();
  report.scene = scene.name;
  report.samples = settings.image.sampleCount;
  PathRenders renders;
  const std::optional<PixelAgreement> pixels = comparePaths(scene, settings, device, reference, options.alpha / 2,
                                                            control, renders);
  report.badSamples = renders.badSamples;
  report.pixels = pixels.value_or(PixelAgreement{});
  render::RenderResult many = device.render(scene, settings, control);
  render::RenderSettings replicated = settings;
  replicated.execution.replicas = 1;
  const std::unique_ptr<render::Session> session = reference.prepare(scene, replicated);
  const bool finished = session->advance({0, report.samples}, control);
  report.interrupted = !pixels || many.interrupted || !finished;
  report.referenceFilm = session->film();
  report.badSamples.device.add(many.film, settings.image);
  report.badSamples.reference.add(report.referenceFilm, settings.image);
  report.deviceStatistics = many.statistics;
  report.deviceStatistics.truncated += renders.deviceStatistics.truncated;
  report.deviceFilm = std::move(many.film);
  if (!report.interrupted) testRegions(report, deviationsOf(*session), options.alpha / 2);
  return report;
}

Conclusion AgreementReport::conclusion() const {
  if (!pixels.agree() || differs()) return Conclusion::different;
  return doubt() == Doubt::none ? Conclusion::same : Conclusion::undecided;
}

Doubt AgreementReport::doubt() const {
  return pixels.agree() && !differs() ? doubtOf(image(), maxOverlooked) : Doubt::none;
}

std::string AgreementReport::verdict() const {
  switch (conclusion()) {
    case Conclusion::same:
      return "the tracers agree";
    case Conclusion::different:
      return "the tracers differ";
    case Conclusion::undecided:
      break;
  }
  return doubtText(doubt(), image(), maxOverlooked) +
         remedyText(doubt(), image(), fmt::format("More samples ({})", settingWords("spp")));
}

std::string AgreementReport::toText() const {
  std::string text = fmt::format("{}: {} compared with the reference\n", scene, deviceStatistics.device);
  if (interrupted) return text + "  interrupted: no verdict\n";
  text += fmt::format(
      "  1 sample: {:.3f} % of {} pixels equal to {:.0e}, {:.3f} % of {} lit pixels; first differences:{}\n",
      100 * pixels.equalFraction(), pixels.pixels, kRelativeTolerance, 100 * pixels.litEqualFraction(), pixels.lit,
      pixels.causesText());
  text += fmt::format("  {}\n", pixels.decisions.text());
  for (const std::string& line : pixels.undecided.lines()) text += fmt::format("  {}\n", line);
  text += fmt::format("  {} samples, {} tests at p < {:.1e}:\n  {}\n", samples, regions.size(), level,
                      differenceText(image()));
  const RegionResult& most = mostSignificant();
  if (&most != &image()) text += fmt::format("  {}\n", differenceText(most));
  switch (conclusion()) {
    case Conclusion::same:
      return text + "  they agree\n";
    case Conclusion::different:
      return text + "  they DIFFER\n";
    case Conclusion::undecided:
      break;
  }
  return text + fmt::format("  {}\n", verdict());
}

nlohmann::ordered_json AgreementReport::toJson() const {
  nlohmann::ordered_json json = reportHead("candela-compare-tracers/1");
  json["scene"] = scene;
  json["device"] = deviceStatistics.device;
  json["driver"] = deviceStatistics.driver;
  json["interrupted"] = interrupted;
  json["agrees"] = nullptr;
  if (interrupted) return json;
  json["agrees"] = agreesJson(conclusion());
  json["verdict"] = verdict();
  json["undecided"] = doubtJson(doubt(), image(), maxOverlooked);
  json["pixels"] = pixels.json();
  json["mean"] = {{"samplesPerPixel", samples},
                  {"device", image().deviceMean},
                  {"reference", image().referenceMean},
                  {"relativeDifference", std::abs(image().relativeDifference())},
                  {"margin", image().margin}};
  json["level"] = level;
  for (const RegionResult& region : regions) json["regions"].push_back(regionJson(region, "device"));
  return json;
}

}  // namespace candela::verify
