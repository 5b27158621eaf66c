// The settings of a render, in three types: one determines the image, one the acceleration structure, one how the work
// is executed.
#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "host/image/layers.h"
#include "host/scene/pixel_filter.h"
#include "host/trace/render/extent.h"

namespace candela::scene {
struct Scene;
}

namespace candela::render {

enum class Integrator { path, whitted, ao, normal, albedo, depth, id, cost };
/// Returns whether an integrator shows a property of the surfaces that camera rays hit: docs/light-transport.md
/// section 10.
constexpr bool isView(Integrator integrator) { return integrator >= Integrator::ao; }

enum class SamplerKind { independent, stratified, sobol };
using scene::FilterKind;
using scene::PixelFilter;
/// How lights are chosen: by their power, or by a tree, depending on the point: docs/light-transport.md section 6.
enum class LightSelection { power, tree };
enum class LensKind { disc, square };
/// Points through which camera rays pass without jitter: the centres of pixels, or the corners of a grid of (width - 1)
/// x (height - 1) cells.
enum class PixelOrigin { centre, corner };
/// The light that camera rays see where they hit nothing: that of the scene (environment, sky or background
/// colour), only the background colour, or none, so that the image has alpha. It changes no other light: rays after
/// the camera ray see the background that lights the scene.
enum class Backdrop { environment, colour, none };
enum class AccelKind { none, grid, bvh };
/// The rule that splits the nodes of a BVH: the surface area heuristic, or the midpoint of the longest axis.
enum class BvhSplit { sah, midpoint };
/// Effort of a build by the surface area heuristic: coarse; standard; or standard with a search for better positions of
/// all nodes.
enum class BuildQuality { fast, standard, high };
/// Nodes of a BVH on the device: binary with single-precision boxes, or 8-wide with quantised boxes. automatic: as
/// layoutFor() chooses.
enum class BvhLayout { automatic, bvh2, cwbvh };
/// Buffer type through which the device reads the scene. automatic: see AutomaticChoices, if the scene fits.
enum class SceneLoads { automatic, texel, storage };
/// The kernels with which a device traces paths: one invocation traces a path to its end, or each stage of a segment
/// has a separate kernel. automatic: see AutomaticChoices. Other integrators have one kernel each.
enum class KernelKind { automatic, megakernel, wavefront };

/// The values of options that are left to Candela. The defaults are built in; docs/performance-journal.md, section
/// "Experiments", has their measurements.
struct AutomaticChoices {
  BvhLayout bvhLayout = BvhLayout::cwbvh;         ///< not automatic; midpoint splits have a separate rule
  SceneLoads sceneLoads = SceneLoads::automatic;  ///< automatic: as the device reads faster; if the scene does not fit,
                                                  ///< the other one
  Extent workgroup{8, 8};                         ///< supported by every device
  KernelKind kernel = KernelKind::megakernel;     ///< not automatic
  std::string origin = "built-in";                ///< for reports

  bool operator==(const AutomaticChoices&) const = default;
};

/// Maximum depth of the Whitted tracer's tree of rays, because a node's index is a factor in the random dimensions.
inline constexpr std::uint32_t kMaxTreeDepth = 20;

/// Maximum number of samples per pixel.
inline constexpr std::uint32_t kMaxSampleCount = 1u << 30;

/// Default of the maximum depth on the command line.
constexpr std::uint32_t defaultMaxDepth(Integrator integrator) { return integrator == Integrator::whitted ? 4 : 64; }

/// The choices that determine an image, without those that a scene may request.
struct ImageChoices {
  std::uint32_t seed = 0;
  std::uint32_t rouletteStart = 4;  ///< number of path vertices before Russian roulette starts
  Integrator integrator = Integrator::path;
  std::optional<float> aoDistance;  ///< maximum length of `ao` rays in units of the scene, > 0; absent: |from - at| / 4
  bool nextEventEstimation = true;
  SamplerKind sampler = SamplerKind::sobol;
  LensKind lens = LensKind::disc;
  PixelOrigin pixelOrigin = PixelOrigin::centre;
  float lightSize = 0;                 ///< side of the squares that replace point lights, >= 0; Whitted only
  std::optional<float> indirectLimit;  ///< maximum of a contribution of light that was scattered twice or more, > 0
  Backdrop backdrop = Backdrop::environment;  ///< path tracer only
  image::LayerSet layers;                     ///< beside the film; path tracer only
  bool layersThroughSpecular = false;  ///< layers show the surfaces that are seen in perfect mirrors and through smooth
                                       ///< glass
  bool oneSided = false;               ///< hits on the back of triangles and planes with T = 0 are ignored

  /// Returns whether the film counts the samples whose camera rays hit something: FilmPixel::hitCount.
  bool hasAlpha() const { return backdrop == Backdrop::none; }

  bool operator==(const ImageChoices&) const = default;
};

/// Everything that determines the image. Two renders of one scene with equal ImageSettings have equal films, bit for
/// bit, on one device, whatever the other settings are (except that Integrator::cost shows the acceleration structure).
/// Settings that select another compiled kernel are an exception where a compiler contracts operations differently in
/// each: docs/testing.md, "Equal bits on other devices".
struct ImageSettings : ImageChoices {
  Extent size{};                   ///< pixels, each in [1, 65535]
  std::optional<Window> crop{};    ///< pixels that are rendered, within the image; absent: all. It changes none of them
  std::uint32_t sampleCount = 16;  ///< per pixel, >= 1; the total over all parts of the render
  PixelFilter filter{};
  bool antialiasing = true;  ///< false: each camera ray passes through its pixel's origin
  /// Maximum length of a path in rays, counting the camera ray. Whitted: at most kMaxTreeDepth.
  std::uint32_t maxDepth = 64;
  /// Exponent k of the film's scale, at most image::kMaxFilmScale: see image::Film.
  std::uint32_t filmScale = 0;
  LightSelection lights = LightSelection::power;  ///< path tracer only

  /// Returns the pixels that are rendered: those of the film.
  Window window() const { return crop.value_or(windowOf(size)); }
  /// Returns whether the pixel filter distributes the camera rays; otherwise they pass through the pixels' origins.
  bool jittersPixels() const { return antialiasing && (integrator == Integrator::path || sampleCount > 1); }

  bool operator==(const ImageSettings&) const = default;
};

/// The choices of an acceleration structure, without its kind, which a scene may request.
struct StructureChoices {
  BvhSplit bvhSplit = BvhSplit::sah;
  BuildQuality bvhQuality = BuildQuality::standard;  ///< of BvhSplit::sah only
  BvhLayout bvhLayout = BvhLayout::automatic;
  float gridDensity = 2;         ///< m of a grid with about m^3 cells per primitive, in [1/16, 64]
  bool copiesInstances = false;  ///< stores a copy of the mesh for each instance; for tests

  bool operator==(const StructureChoices&) const = default;
};

/// The acceleration structure. It changes no bit of the image (except with Integrator::cost).
struct StructureSettings : StructureChoices {
  AccelKind accel = AccelKind::bvh;
  /// True if `accel` is a preference. If it is AccelKind::none and the device cannot test all primitives of the scene
  /// sequentially, a preference is replaced by a BVH, with a sentence in RenderStatistics::warnings. Otherwise an
  /// exception is thrown.
  bool accelIsPreference = false;

  bool operator==(const StructureSettings&) const = default;
};

/// Settings of how the work is executed. They change no bit of the image.
struct ExecutionSettings {
  SceneLoads sceneLoads = SceneLoads::automatic;
  KernelKind kernel = KernelKind::automatic;
  std::optional<Extent> workgroup;  ///< absent: AutomaticChoices::workgroup
  AutomaticChoices automatic;
  std::optional<Extent> tile;                        ///< region of one dispatch; absent: the governor chooses
  std::optional<std::uint32_t> segmentsPerDispatch;  ///< absent: the governor chooses
  /// Target duration of a dispatch for the governor, in seconds, > 0. With short dispatches, a session stops sooner.
  double dispatchSeconds = 0.1;
  std::uint32_t threads = 0;   ///< of the reference; 0: one per core
  std::uint32_t replicas = 0;  ///< of each sample, only by the reference: see host/trace/render/replicas.h
  /// Maximum size of a band's largest buffer. Devices that lack the memory get bands of fewer rows in any case.
  std::uint64_t maxBandBytes = std::numeric_limits<std::uint64_t>::max();
  bool recordPaths = false;  ///< records the decisions of each pixel's path (one sample per pixel only): see PathRecord

  Extent workgroupInUse() const { return workgroup.value_or(automatic.workgroup); }
  /// The kernel of Integrator::path.
  KernelKind kernelInUse() const { return kernel == KernelKind::automatic ? automatic.kernel : kernel; }

  bool operator==(const ExecutionSettings&) const = default;
};

struct RenderRequest;

/// The settings of a render of one scene. Only resolve() makes them, so that a renderer never ignores the size, the
/// number of samples or the structure that the scene requests; they may be changed afterwards.
struct RenderSettings {
  ImageSettings image;
  StructureSettings structure;
  ExecutionSettings execution;

  bool operator==(const RenderSettings&) const = default;

 private:
  explicit RenderSettings(const RenderRequest& request);
  friend RenderSettings resolve(const RenderRequest& request, const scene::Scene& scene);
};

}  // namespace candela::render
