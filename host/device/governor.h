// Chooses how much work one dispatch gets, so that submissions stay short on any device: the dispatch governor.
#pragma once
#include <cstdint>

namespace candela::device {

struct GovernorOptions {
  double targetSeconds = 0.1;           ///< what a submission should take
  double limitSeconds = 0.25;           ///< what it should not exceed; one that does makes the governor aim lower
  std::uint32_t maxSegments = 1024;     ///< upper bound of Plan::segments, e.g. by the device's loop limit
  std::uint64_t totalPixels = 0;        ///< of the image, or the band of it, that is rendered; > 0
  std::uint64_t minimumPixels = 16384;  ///< fewer lanes would leave a large device idle; undercut only to keep time
  std::uint32_t workgroupPixels = 64;   ///< Plan::pixels is a multiple of it, or totalPixels
  std::uint64_t fixedPixels = 0;        ///< the size of every region if the user set it; 0: free
  std::uint32_t fixedSegments = 0;      ///< Plan::segments if the user set it; 0: free
};

/// One dispatch: a region of so many pixels, each advanced by at most so many path segments.
struct Plan {
  std::uint64_t pixels = 0;
  std::uint32_t segments = 0;
};

/// Takes a dispatch's time to be in proportion to its *units*, active pixels times segments, at a cost that depends on
/// device and scene and changes as the render goes on. It holds a budget of units: any dispatch that took too long cuts
/// it at once, short ones raise it step by step. It has no clock; it is told durations. The first dispatch is a tiny
/// one whose duration does not count, since drivers compile in it.
class Governor {
 public:
  explicit Governor(const GovernorOptions& options);

  /// What to dispatch next: all pixels if that leaves each 128 segments or more (loading and storing a path's state
  /// costs something), else fewer pixels of 128 segments, else `minimumPixels` of fewer segments, else fewer pixels
  /// still.
  Plan next() const;
  /// Segments for a region that is chosen already and has so many unfinished pixels.
  std::uint32_t segmentsFor(std::uint64_t activePixels) const;
  /// Tells what a dispatch took: `plan` as it was run, of whose pixels `activePixels` had work left when it began.
  void record(const Plan& plan, std::uint64_t activePixels, double seconds);

 private:
  void cut(double fittingUnits);
  void raise(double units, double fittingUnits, double seconds);

  GovernorOptions options_;
  bool isWarm_ = false;
  double aimSeconds_;  ///< between a quarter of the target and the target
  double budget_;      ///< units for the next dispatch
};

}  // namespace candela::device
