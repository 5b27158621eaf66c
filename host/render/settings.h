// What a render is asked for. The first half decides the image; the second half only how it is computed.
#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "host/render/extent.h"

namespace candela::render {

enum class Integrator { path, whitted, ao, normal, albedo, depth, id, cost };
/// Whether an integrator shows something of what camera rays meet: docs/light-transport.md section 10.
constexpr bool isView(Integrator integrator) { return integrator >= Integrator::ao; }

enum class SamplerKind { independent, stratified, sobol };
enum class FilterKind { box, tent };
enum class LensKind { disc, square };
/// Where rays go that are not jittered: through pixels' centres, or through the corners of a grid of one pixel less.
enum class PixelOrigin { centre, corner };
enum class AccelKind { none, grid, bvh };
/// How a BVH's nodes are split: by the surface area heuristic, or in the middle, as the path-tracing report does.
enum class BvhSplit { sah, midpoint };
/// How much work building by the surface area heuristic takes: a coarse build, the standard one, or that and a search
/// for better places of all nodes.
enum class BuildQuality { fast, standard, high };
/// Nodes of a BVH on the device: two children with single-precision boxes, or eight with quantised ones; automatic: as
/// layoutFor() chooses.
enum class BvhLayout { automatic, bvh2, cwbvh };
/// How the device reads the scene: one way for certain, or the way that AutomaticChoices names, where the scene fits so
/// (automatic).
enum class SceneLoads { automatic, texel, storage };
/// How a device traces paths: each to its end by one lane, or all a segment at a time, stage by stage; automatic: as
/// AutomaticChoices says. Other integrators have one kernel each.
enum class KernelKind { automatic, megakernel, wavefront };

/// What options stand for that are left to Candela. The default is what is built in, from docs/performance.md.
struct AutomaticChoices {
  BvhLayout bvhLayout = BvhLayout::cwbvh;      ///< one of both; midpoint splits have a rule of their own
  SceneLoads sceneLoads = SceneLoads::texel;   ///< one of both; where the scene does not fit, the other
  Extent workgroup{8, 8};                      ///< one that every device has
  KernelKind kernel = KernelKind::megakernel;  ///< one of both
  std::string origin = "built-in";             ///< for reports
};

/// Whitted's tree of rays is at most so deep: a node's number indexes random dimensions.
inline constexpr std::uint32_t kMaxTreeDepth = 20;

/// Of a command line that does not say.
constexpr std::uint32_t defaultMaxDepth(Integrator integrator) { return integrator == Integrator::whitted ? 4 : 64; }

struct RenderSettings {
  // --- These decide the image.
  Extent size;                     ///< pixels, each in [1, 65535]
  std::uint32_t sampleCount = 16;  ///< per pixel, >= 1
  std::uint32_t seed = 0;
  std::uint32_t maxDepth = 64;      ///< longest path, in rays; the camera ray is 1. Whitted: at most kMaxTreeDepth
  std::uint32_t rouletteStart = 4;  ///< path vertices that never face Russian roulette
  Integrator integrator = Integrator::path;
  std::optional<float> aoDistance;  ///< reach of `ao`'s rays in units of the scene, > 0; absent: |from - at| / 4
  bool nextEventEstimation = true;
  SamplerKind sampler = SamplerKind::sobol;
  FilterKind filter = FilterKind::box;
  LensKind lens = LensKind::disc;
  PixelOrigin pixelOrigin = PixelOrigin::centre;
  float lightSize = 0;    ///< side of the squares that point lights become, >= 0; Whitted only
  bool oneSided = false;  ///< hits on the back of triangles and planes with T = 0 are dropped

  // --- These never change a bit of it, but for Integrator::cost, which shows what `accel` makes of the scene.
  AccelKind accel = AccelKind::bvh;
  BvhSplit bvhSplit = BvhSplit::sah;
  BuildQuality bvhQuality = BuildQuality::standard;  ///< the report's split knows no other
  BvhLayout bvhLayout = BvhLayout::automatic;
  float gridDensity = 2;  ///< m of the report's rule: about m^3 cells a primitive, from 1/16 to 64
  SceneLoads sceneLoads = SceneLoads::automatic;
  KernelKind kernel = KernelKind::automatic;
  std::optional<Extent> workgroup;  ///< absent: as `automatic` says
  AutomaticChoices automatic;
  std::optional<Extent> tile;                        ///< region of one dispatch; absent: the governor chooses
  std::optional<std::uint32_t> segmentsPerDispatch;  ///< absent: the governor chooses
  std::uint32_t threads = 0;                         ///< of the reference; 0: one per core

  /// Records what each path decided (one sample per pixel only): see PathRecord.
  bool recordPaths = false;

  Extent workgroupInUse() const { return workgroup.value_or(automatic.workgroup); }
  /// Of Integrator::path.
  KernelKind kernelInUse() const { return kernel == KernelKind::automatic ? automatic.kernel : kernel; }

  /// Whether camera rays are spread by the pixel filter; if not, they go through the pixels' origins.
  bool jittersPixels() const { return integrator == Integrator::path || sampleCount > 1; }
};

}  // namespace candela::render
