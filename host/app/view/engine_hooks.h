// The functions that the program provides to the engine.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "host/app/view/engine_view.h"

namespace candela::view {

/// A scene and the sessions that render it. Members depend on the members before them.
struct Sessions {
  std::shared_ptr<const scene::Scene> scene;
  render::RenderSettings settings;                         ///< `image.size` is the full resolution
  std::optional<double> animationEnd{};                    ///< scene::LoadedScene::animationEnd
  std::unique_ptr<render::Session> device{}, reference{};  ///< the device's is null if only the reference renders
  std::string deviceName{};

  render::Session* session(Side side) const { return side == Side::device ? device.get() : reference.get(); }
};

/// The functions of the program around the engine. All may throw Error.
struct EngineHooks {
  /// Prepares the reference, which takes little time, with the scene as it is, or as it is in its file now.
  std::function<Sessions(const Choice&, bool reads)> load;
  /// Adds the device's session to a copy of `sessions` without any, and lets its driver compile. Called on another
  /// thread.
  std::function<void(const Choice&, Sessions&)> addDevice;
  /// Copies the film of the device to the picture that the window shows, on the device. Returns false if the window
  /// cannot show it from there, so that the engine reads the film.
  std::function<bool(render::Session&, const render::Extent& size)> showOnDevice;
  /// Writes an image file of a film that was rendered with this camera, which may differ from the scene's.
  std::function<void(const std::filesystem::path&, const Sessions&, const scene::Camera&, const image::Film&,
                     const render::RenderStatistics&, const Choice&, const image::DisplayTransform&)>
      save;
  /// Called from the engine's thread whenever there is something new to show.
  std::function<void()> wake;
};

}  // namespace candela::view
