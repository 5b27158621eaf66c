// The one interface of both tracers: a Scene and settings in, an exact film and statistics out.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/image/film.h"
#include "host/render/path_record.h"
#include "host/render/settings.h"
#include "host/scene/scene.h"

namespace candela::render {

/// Rays of Whitted's tracer by kind.
struct TreeRays {
  std::uint64_t cameraHits = 0;  ///< camera rays that hit a primitive
  std::uint64_t reflected = 0;   ///< by mirrors and by glass
  std::uint64_t refracted = 0;
};

/// Counts and times of one render. Times in seconds.
struct RenderStatistics {
  std::string device;     ///< e.g. "llvmpipe (LLVM 15.0.6, 256 bits)" or "cpu"
  std::string driver;     ///< e.g. "llvmpipe Mesa 22.3.6", empty for the reference
  std::string structure;  ///< "bvh", "grid" or "none"; a tree of one leaf is "bvh", though there is nothing to traverse
  std::string bvhSplit;   ///< "sah", "midpoint", or "median", the reference's own; empty without a BVH
  std::string bvhQuality;  ///< "fast", "default" or "high"; empty but for a device's BVH by SAH
  std::string layout;      ///< of a BVH's nodes: "bvh2" or "cwbvh"; "row": none, the scene is small; else empty
  std::string kernel;      ///< "megakernel", "wavefront", "whitted", "views" or "reference"
  Extent workgroup{};      ///< in use; 0x0 for the reference
  Extent tile{};           ///< largest region of one dispatch
  std::uint32_t maxSegmentsPerDispatch = 0;
  std::uint32_t threads = 0;    ///< of the reference
  std::string sceneLoads;       ///< "texel" or "storage"
  std::string automaticOrigin;  ///< AutomaticChoices::origin; empty for the reference

  std::uint64_t samples = 0;  ///< pixel samples finished
  std::uint64_t cameraRays = 0;
  std::uint64_t bounceRays = 0;  ///< all but camera and shadow rays
  std::uint64_t shadowRays = 0;
  std::optional<TreeRays> treeRays;  ///< of Whitted's tracer
  std::uint64_t vertices = 0;        ///< surface hits of camera and bounce rays
  std::uint64_t traversalSteps = 0;  ///< nodes or cells visited plus primitives tested
  std::uint64_t truncated = 0;       ///< loops that ended before their work was done; anything but 0 is an error
  std::uint64_t badSamples = 0;      ///< samples that were not finite or beyond the film's range

  std::uint64_t rays() const { return cameraRays + bounceRays + shadowRays; }

  std::map<std::string, double>
      seconds;  ///< by phase: parse, build (structure, a part of it), upload, pipeline, trace, readBack, ...
  std::vector<double> dispatchSeconds;             ///< each dispatch but the warm-up
  std::map<std::string, double> structureQuality;  ///< e.g. sahCost, depth, nodes, leaves
  std::uint64_t deviceBytes = 0;                   ///< device memory in use at the peak
};

struct RenderResult {
  image::Film film;
  RenderStatistics statistics;
  bool interrupted = false;  ///< stopped early by `RenderControl::stop`; the film holds what was done
  PathRecords paths;         ///< empty unless RenderSettings::recordPaths
};

/// How a caller watches and stops a render.
struct RenderControl {
  const std::atomic<bool>* stop = nullptr;                                   ///< polled between dispatches or tiles
  std::function<void(double fraction, std::uint64_t samplesDone)> progress;  ///< may be empty; called often
};

class Renderer {
 public:
  virtual ~Renderer() = default;
  /// Renders `scene` (its camera is present) and returns what was summed.
  /// Throws NoDeviceError, DeviceLostError, OutOfMemoryError, FileError (a size beyond the device's limits).
  virtual RenderResult render(const scene::Scene& scene, const RenderSettings& settings,
                              const RenderControl& control) = 0;
};

}  // namespace candela::render
