// The dispatch governor: chooses how much work one dispatch gets, so that submissions are short on any device.
#pragma once
#include <cstdint>

namespace candela::device {

struct GovernorOptions {
  double targetSeconds = 0.1;        ///< desired duration of a submission
  double limitSeconds = 0.25;        ///< maximum duration; a longer submission lowers the target
  std::uint32_t maxSegments = 1024;  ///< maximum of Plan::segments, e.g. from the device's loop limit
  std::uint64_t totalPixels = 0;     ///< of the image, or the band of it, that is rendered; > 0
  /// Fewer invocations would leave a large device idle. A dispatch has fewer only to limit the time.
  std::uint64_t minimumPixels = 16384;
  std::uint32_t workgroupPixels = 64;  ///< Plan::pixels is a multiple of it, or totalPixels
  std::uint64_t fixedPixels = 0;       ///< size of every region if the user set it; 0: free
  std::uint32_t fixedSegments = 0;     ///< Plan::segments if the user set it; 0: free
};

/// One dispatch: the number of pixels of its region, and the maximum number of path segments by which each is advanced.
struct Plan {
  std::uint64_t pixels = 0;
  std::uint32_t segments = 0;
};

/// Assumes that the duration of a dispatch is proportional to its *units*, active pixels times segments, at a cost that
/// depends on the device, the scene and the region. The governor has a budget of units: a dispatch that took too long
/// reduces it at once, short ones increase it step by step. It has no clock; durations are passed to it. The first
/// dispatch is tiny and its duration does not count, because drivers compile during it.
///
/// The budget is at most what the most expensive of the last regions permits, so that a cheap one, such as the sky,
/// does not decide how much work the next one gets. At first the governor *probes*: it aims at 1/32 of the target,
/// while its caller dispatches regions all over the image.
class Governor {
 public:
  explicit Governor(const GovernorOptions& options);

  /// Returns the next dispatch: all pixels if each then gets 128 segments or more (loading and storing a path's state
  /// has a cost), else fewer pixels with 128 segments, else `minimumPixels` with fewer segments, else fewer pixels
  /// still.
  Plan next() const;
  /// Returns the number of segments for a region that is already chosen and has this number of unfinished pixels.
  std::uint32_t segmentsFor(std::uint64_t activePixels) const;
  /// Records the duration of a dispatch. `plan` is the plan that was executed; `activePixels` of its pixels had work
  /// left when it began.
  void record(const Plan& plan, std::uint64_t activePixels, double seconds);
  /// Returns whether the next dispatch belongs into a region far from the last one.
  bool isProbing() const { return probesLeft_ > 0 && dispatchesLeftToProbe_ > 0; }

 private:
  double aim() const;
  void noteCost(const Plan& plan, double units, double seconds);
  void cut(double fittingUnits);
  void raise(double units, double fittingUnits, double seconds);

  GovernorOptions options_;
  bool isWarm_ = false;
  std::uint32_t probesLeft_;             ///< dispatches of representative duration until the end of probing
  std::uint32_t dispatchesLeftToProbe_;  ///< of any duration
  std::uint64_t probedPixels_ = 0;       ///< by dispatches of representative duration
  double maxCost_ = 0;                   ///< largest seconds per unit of the last regions, which decays; 0: unknown
  double aimSeconds_;                    ///< between a quarter of the target and the target
  double budget_;                        ///< units for the next dispatch
};

}  // namespace candela::device
