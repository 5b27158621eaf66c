// The scene of `candela view`.
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

#include "host/app/cli/cached_device.h"
#include "host/app/cli/render_job.h"
#include "host/app/view/engine.h"
#include "host/formats/load_scene.h"

namespace candela::cli {

/// Provides the engine with scenes and sessions, and writes its image files.
class ViewedScene {
 public:
  ViewedScene(const ViewArguments& arguments, const Log& log) : arguments_(arguments), log_(log) {}

  /// The job of the next sessions, read from the file again if `reads`.
  RenderJob job(const view::Choice& choice, bool reads);

  view::Sessions load(const view::Choice& choice, bool reads);

  /// Opens the device of a choice, or returns the one that is open.
  vulkan::Device open(const view::Choice& choice, const std::vector<std::string>& windowExtensions = {});

  /// Prepares a session of the device. Blocks while another preparation is under way.
  void addDevice(const view::Choice& choice, view::Sessions& sessions);

  void save(const std::filesystem::path& file, const view::Sessions& sessions, const scene::Camera& camera,
            const image::Film& film, const render::RenderStatistics& statistics, const view::Choice& choice,
            const image::DisplayTransform& display);

 private:
  /// Makes the scene at the time of a choice, from the file as it is now if `reads`.
  void makeScene(const view::Choice& choice, bool reads);

  /// Throws UsageError for a file that cannot be written, or that would replace one that is in use.
  void requireSavable(const std::filesystem::path& file);

  const ViewArguments& arguments_;
  const Log& log_;
  std::mutex mutex_;
  std::unique_ptr<formats::SceneSource> source_;  ///< of an animated scene
  std::shared_ptr<const scene::Scene> scene_;
  std::optional<double> time_;  ///< of `scene_`
  std::optional<double> animationEnd_;
  std::set<std::string> warnings_;         ///< that the log has
  std::set<std::filesystem::path> files_;  ///< that the scene has read, now or before it changed
  std::mutex deviceMutex_;
  /// A device, and a renderer that caches its pipelines.
  struct OpenedDevice {
    std::unique_ptr<CachedDevice> device;
    std::unique_ptr<render::Renderer> renderer;
  };
  std::map<std::string, OpenedDevice> devices_;  ///< by their selectors
};

}  // namespace candela::cli
