// A render that is ready to run: its scene, its settings, and what becomes of its samples.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "host/formats/loading/load.h"
#include "host/scene/scene.h"
#include "host/trace/render/adaptive_plan.h"
#include "host/trace/render/session.h"
#include "host/trace/render/settings.h"

namespace candela::job {

/// The renderer that finishes a job after its device has failed for good.
enum class Fallback { none, reference };

/// The samples that a job adds, the files of its film, and its course if a device fails or time runs out.
struct FilmPolicy {
  std::optional<render::SampleRange> samples{};  ///< part of the samples of each pixel; empty: all
  /// Relative error at which regions stop, > 0; empty: all pixels have the same number of samples.
  std::optional<double> noiseThreshold{};
  std::filesystem::path checkpoint{};  ///< film file that is written during the render and at its end; empty: none
  double checkpointEvery = 60;         ///< minimum time between two writes in seconds
  std::filesystem::path resume{};      ///< film file that the render continues; empty: none
  bool resumeAnyway = false;           ///< a film of another scene, other settings or another device is continued, too
  std::optional<double> timeLimit{};   ///< in seconds, after which the render stops
  Fallback fallback = Fallback::none;
  /// File beside which the film is written if the device fails and there is no checkpoint; empty: nowhere.
  std::filesystem::path rescueBeside{};
};

struct Job {
  /// Jobs may share a scene, which has a camera and lives as long as one of them.
  std::shared_ptr<const scene::Scene> sharedScene;
  scene::LoadOptions reading;  ///< with which the scene was read
  render::RenderSettings settings;
  FilmPolicy film{};

  const scene::Scene& scene() const { return *sharedScene; }
};

/// Throws UsageError if a range exceeds the samples that each pixel has in the whole render.
void requireSamples(const render::SampleRange& range, std::uint32_t total);
/// Returns the samples of each pixel that a job renders. Throws UsageError if it has fewer.
render::SampleRange samplesOf(const Job& job);

/// Returns the plan of adaptive sampling; nothing without a noise threshold.
std::optional<render::AdaptivePlan> planOf(const Job& job);

/// Throws UsageError if the tracers cannot render the scene with these settings, or if the settings or the film's
/// policy contradict each other; FileError if the image exceeds the limit of pixels; and OutOfMemoryError if scene,
/// film and, with `makesPictures`, pictures of the film do not fit into memory.
void requirePossible(const scene::Scene& scene, const render::RenderSettings& settings, const FilmPolicy& film,
                     bool makesPictures);

}  // namespace candela::job
