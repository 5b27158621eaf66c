// The counts and times of a session.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/trace/render/choices_in_use.h"

namespace candela::render {

/// Rays of the Whitted tracer by kind.
struct TreeRays {
  std::uint64_t cameraHits = 0;  ///< camera rays that hit a primitive
  std::uint64_t reflected = 0;   ///< by mirrors and by glass
  std::uint64_t refracted = 0;
};

/// The name of the reference tracer where devices are named: in options, reports and films.
inline constexpr const char* kReferenceDevice = "cpu";

/// Counts and times of one session since it was prepared or reset. Times in seconds.
struct RenderStatistics {
  std::string device;  ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)" or kReferenceDevice
  std::string driver;  ///< e.g. "llvmpipe Mesa 22.3.6", empty for the reference
  bool onGpu = false;  ///< the device is a GPU; false for devices in software and the reference
  /// The conditions on which the bytes of a film depend besides device, driver and kernels: the UUIDs of the driver and
  /// of its pipeline cache; for the reference: compiler, C library and instruction set.
  std::string platform;
  std::string kernels;                    ///< hash of the code of all kernels, or "reference"
  AccelKind structure = AccelKind::none;  ///< in use; a BVH of one leaf is a BVH, too
  SplitInUse bvhSplit = SplitInUse::none;
  std::optional<BuildQuality> bvhQuality;  ///< absent unless a device's BVH is built by SAH
  LayoutInUse layout = LayoutInUse::none;
  KernelInUse kernel = KernelInUse::reference;
  Extent workgroup{};  ///< in use; 0x0 for the reference
  Extent tile{};       ///< maximum region of one dispatch
  std::uint32_t maxSegmentsPerDispatch = 0;
  std::uint32_t threads = 0;             ///< of the reference
  std::optional<SceneLoads> sceneLoads;  ///< not automatic; absent for the reference
  std::string automaticOrigin;           ///< AutomaticChoices::origin; empty for the reference
  std::vector<std::string> warnings;     ///< one sentence for each preference that the session could not follow

  std::uint64_t samples = 0;  ///< pixel samples finished
  std::uint64_t cameraRays = 0;
  std::uint64_t bounceRays = 0;  ///< all rays except camera and shadow rays
  std::uint64_t shadowRays = 0;
  std::optional<TreeRays> treeRays;  ///< of the Whitted tracer
  std::uint64_t vertices = 0;        ///< surface hits of camera and bounce rays
  std::uint64_t traversalSteps = 0;  ///< nodes or cells visited plus primitives tested
  std::uint64_t truncated = 0;  ///< loops that ended before their work was done; any other value than 0 is an error
  std::uint64_t
      volumeFaults = 0;  ///< rays whose volumes are not nested or not closed: docs/light-transport.md section 5.6
  std::uint64_t badSamples = 0;  ///< samples that were not finite or beyond the film's range

  std::uint64_t rays() const { return cameraRays + bounceRays + shadowRays; }

  std::map<std::string, double>
      seconds;  ///< by phase: parse, build, structure (part of build), upload, pipeline, trace, readBack
  std::vector<double> dispatchSeconds;             ///< of each dispatch except the warm-up
  std::map<std::string, double> structureQuality;  ///< e.g. sahCost, depth, nodes, leaves
  std::uint64_t deviceBytes = 0;                   ///< device memory of the session's buffers
};

/// Throws if work was truncated, since the image would be wrong: FileError if a grid exceeds the loop limit of the
/// device, else InternalError.
void requireComplete(const RenderStatistics& statistics);

}  // namespace candela::render
