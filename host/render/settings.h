// The settings of a render, in three types: one decides the image, one the search structure, one how the work is
// executed.
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

  bool operator==(const AutomaticChoices&) const = default;
};

/// Whitted's tree of rays is at most so deep: a node's number indexes random dimensions.
inline constexpr std::uint32_t kMaxTreeDepth = 20;

/// Of a command line that does not say.
constexpr std::uint32_t defaultMaxDepth(Integrator integrator) { return integrator == Integrator::whitted ? 4 : 64; }

/// Everything that decides the image. Two renders of one scene with equal ImageSettings have equal films, bit for bit,
/// on one device, whatever the other settings (but Integrator::cost shows the search structure).
struct ImageSettings {
  Extent size;                     ///< pixels, each in [1, 65535]
  std::uint32_t sampleCount = 16;  ///< per pixel, >= 1; the total, in however many parts it is rendered
  std::uint32_t seed = 0;
  std::uint32_t
      maxDepth = 64;  ///< maximum length of a path, in rays; the camera ray is 1. Whitted: at most kMaxTreeDepth
  std::uint32_t rouletteStart = 4;  ///< the first path vertices, so many, are exempt from Russian roulette
  Integrator integrator = Integrator::path;
  std::optional<float>
      aoDistance;  ///< maximum length of `ao`'s rays in units of the scene, > 0; absent: |from - at| / 4
  bool nextEventEstimation = true;
  SamplerKind sampler = SamplerKind::sobol;
  FilterKind filter = FilterKind::box;
  LensKind lens = LensKind::disc;
  PixelOrigin pixelOrigin = PixelOrigin::centre;
  bool antialiasing = true;  ///< false: each camera ray passes through its pixel's origin
  float lightSize = 0;       ///< side of the squares that point lights become, >= 0; Whitted only
  bool oneSided = false;     ///< hits on the back of triangles and planes with T = 0 are ignored

  /// Whether camera rays are distributed by the pixel filter; otherwise they pass through the pixels' origins.
  bool jittersPixels() const { return antialiasing && (integrator == Integrator::path || sampleCount > 1); }

  bool operator==(const ImageSettings&) const = default;
};

/// The search structure. It changes no bit of the image (except Integrator::cost).
struct StructureSettings {
  AccelKind accel = AccelKind::bvh;
  /// Whether `accel` is a preference: a device that cannot test all primitives of a scene one by one uses a BVH in
  /// place of AccelKind::none, and says so in RenderStatistics::warnings, instead of throwing.
  bool accelIsPreference = false;
  BvhSplit bvhSplit = BvhSplit::sah;
  BuildQuality bvhQuality = BuildQuality::standard;  ///< of BvhSplit::sah alone
  BvhLayout bvhLayout = BvhLayout::automatic;
  float gridDensity = 2;  ///< m of a grid with about m^3 cells per primitive, in [1/16, 64]

  bool operator==(const StructureSettings&) const = default;
};

/// How the work is executed. It changes no bit of the image.
struct ExecutionSettings {
  SceneLoads sceneLoads = SceneLoads::automatic;
  KernelKind kernel = KernelKind::automatic;
  std::optional<Extent> workgroup;  ///< absent: AutomaticChoices::workgroup
  AutomaticChoices automatic;
  std::optional<Extent> tile;                        ///< region of one dispatch; absent: the governor chooses
  std::optional<std::uint32_t> segmentsPerDispatch;  ///< absent: the governor chooses
  std::uint32_t threads = 0;                         ///< of the reference; 0: one per core
  bool recordPaths = false;  ///< records the decisions of each pixel's path (one sample per pixel only): see PathRecord

  Extent workgroupInUse() const { return workgroup.value_or(automatic.workgroup); }
  /// The kernel of Integrator::path.
  KernelKind kernelInUse() const { return kernel == KernelKind::automatic ? automatic.kernel : kernel; }

  bool operator==(const ExecutionSettings&) const = default;
};

struct RenderSettings {
  ImageSettings image;
  StructureSettings structure;
  ExecutionSettings execution;
};

}  // namespace candela::render
