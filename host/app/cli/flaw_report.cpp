// Warns of bad samples, open volumes and clamped values of layers.
#include <fmt/format.h>

#include "host/app/cli/bad_samples.h"
#include "host/app/cli/statistics_report.h"
#include "host/base/counted.h"
#include "host/base/statistics/quantiles.h"

namespace candela::cli {
namespace {

using statistics::ratio;

// Rays that graze the edge of a closed volume may enter it and miss its other side by rounding. Volumes that are not
// closed affect every ray through the gap.
constexpr double kMaxRoundingFaults = 1e-4;  ///< per sample

void reportVolumeFaults(const render::RenderStatistics& statistics, const Log& log) {
  const std::uint64_t faults = statistics.volumeFaults;
  if (faults == 0) return;
  const double fraction = ratio(static_cast<double>(faults), static_cast<double>(statistics.samples));
  if (fraction <= kMaxRoundingFaults) {
    log.detail(fmt::format("{} entered or left a volume on one side only, {:.2g} % of the samples: probably rounding",
                           counted(faults, "ray"), 100 * fraction));
    return;
  }
  log.warning(fmt::format(
      "{} ({:.2g} % of the samples) hit volumes that are not closed, or that overlap or contain each other; "
      "each surface refracts as if it bordered on air, and only the volume that a ray entered last absorbs",
      counted(faults, "ray"), 100 * fraction));
}

}  // namespace

void reportFlaws(const RenderReport& report, const Log& log) {
  for (const std::string& line : badSampleLines(report.badSamples, report.job)) log.problem(line);
  reportVolumeFaults(report.result.statistics, log);
  if (const std::uint64_t count = badLayerCount(report.result.film); count > 0) {
    log.warning(
        fmt::format("layer values of {} are not finite or above 2^20; these were clamped", counted(count, "sample")));
  }
}

}  // namespace candela::cli
