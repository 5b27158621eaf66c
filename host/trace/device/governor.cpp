// Chooses how much work one dispatch gets.
#include "host/trace/device/governor.h"

#include <algorithm>
#include <cmath>

namespace candela::device {
namespace {

// Storing and loading a path costs as much as two or three segments (docs/performance-journal.md, "First kernel").
constexpr std::uint32_t kPreferredSegments = 128;
constexpr double kGrowth = 2.0;         // per step, near the target
constexpr double kFastGrowth = 8.0;     // per step, while even this growth stays below the target
constexpr double kSmoothing = 0.3;      // fraction of an increase applied at once, near the target
constexpr double kAimRecovery = 1.001;  // per dispatch: expensive regions, such as a strip of the image, recur in the
                                        // next sweep
constexpr std::uint32_t kProbes = 8;
constexpr std::uint32_t kMaxDispatchesToProbe = 32;  // if they stay short, such as those of a small image
constexpr double kProbingFraction = 1.0 / 32;        // of the target
constexpr double kRepresentative = 0.125;            // fraction of the aim: overhead dominates shorter dispatches
constexpr double kSlack = 2;                         // times the aim, for the most expensive region; below limitSeconds
constexpr double kCostDecay = 0.9;                   // per target duration of work

std::uint64_t roundToWorkgroups(double pixels, std::uint32_t workgroupPixels, std::uint64_t maxPixels) {
  if (pixels >= static_cast<double>(maxPixels)) return maxPixels;
  const std::uint64_t groups = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(pixels) / workgroupPixels);
  return std::min(groups * workgroupPixels, maxPixels);
}

}  // namespace

Governor::Governor(const GovernorOptions& options)
    : options_(options),
      probesLeft_(kProbes),
      dispatchesLeftToProbe_(kMaxDispatchesToProbe),
      aimSeconds_(options.targetSeconds),
      budget_(static_cast<double>(std::min<std::uint64_t>(options.workgroupPixels, options.totalPixels))) {}

std::uint32_t Governor::segmentsFor(std::uint64_t activePixels) const {
  if (options_.fixedSegments > 0) return options_.fixedSegments;
  const double segments = budget_ / static_cast<double>(std::max<std::uint64_t>(1, activePixels));
  return static_cast<std::uint32_t>(std::clamp(segments, 1.0, static_cast<double>(options_.maxSegments)));
}

Plan Governor::next() const {
  if (options_.fixedPixels > 0) {
    const std::uint64_t pixels = std::min(options_.fixedPixels, options_.totalPixels);
    return {pixels, segmentsFor(pixels)};
  }
  const auto total = static_cast<double>(options_.totalPixels);
  const std::uint32_t preferred = options_.fixedSegments > 0 ? options_.fixedSegments
                                                             : std::min(kPreferredSegments, options_.maxSegments);
  const double minPixels = options_.fixedSegments > 0 ? 1.0
                                                      : std::min(static_cast<double>(options_.minimumPixels), total);
  const double wanted = std::clamp(budget_ / preferred, minPixels, total);
  const std::uint32_t segments = segmentsFor(static_cast<std::uint64_t>(wanted));
  return {roundToWorkgroups(budget_ / segments, options_.workgroupPixels, options_.totalPixels), segments};
}

double Governor::aim() const {
  return isProbing() ? std::min(aimSeconds_, options_.targetSeconds * kProbingFraction) : aimSeconds_;
}

void Governor::noteCost(const Plan& plan, double units, double seconds) {
  maxCost_ *= std::pow(kCostDecay, seconds / options_.targetSeconds);
  const bool isRepresentative = seconds >= aim() * kRepresentative;
  if (isRepresentative) maxCost_ = std::max(maxCost_, seconds / units);
  if (!isProbing()) return;
  --dispatchesLeftToProbe_;
  if (!isRepresentative) return;
  probedPixels_ += plan.pixels;
  probesLeft_ = probedPixels_ >= options_.totalPixels ? 0 : probesLeft_ - 1;
}

void Governor::record(const Plan& plan, std::uint64_t activePixels, double seconds) {
  if (!isWarm_) {
    isWarm_ = true;
    return;
  }
  const double units = static_cast<double>(std::max<std::uint64_t>(1, activePixels)) * plan.segments;
  noteCost(plan, units, seconds);
  // The image's last strip, or one that is nearly finished. Its duration is mostly overhead and has no information.
  if (units < budget_ / 2 && seconds < options_.targetSeconds / 2) return;

  const bool isOverLimit = seconds > options_.limitSeconds;
  aimSeconds_ = isOverLimit ? std::max(aimSeconds_ / 2, options_.targetSeconds / 4)
                            : std::min(aimSeconds_ * kAimRecovery, options_.targetSeconds);
  const double fitting = aim() / std::max(maxCost_ / kSlack, std::max(seconds, 1e-9) / units);
  if (fitting < budget_) {
    cut(fitting);
  } else {
    raise(units, fitting, seconds);
  }
}

void Governor::cut(double fittingUnits) { budget_ = std::max(fittingUnits, 1.0); }

void Governor::raise(double units, double fittingUnits, double seconds) {
  const double base = std::max(budget_, units);
  if (seconds * kFastGrowth < aim()) {
    budget_ = std::min(fittingUnits, base * kFastGrowth);
    return;
  }
  const double maxUnits = std::min(fittingUnits, base * kGrowth);
  budget_ += (maxUnits - budget_) * (seconds * kGrowth < aim() ? 1.0 : kSmoothing);
}

}  // namespace candela::device
