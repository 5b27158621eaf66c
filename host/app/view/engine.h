// The worker of a viewer: renders with one tracer or both, on a separate thread, so that input never waits.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "host/app/view/device_preparation.h"
#include "host/app/view/engine_hooks.h"
#include "host/app/view/requests.h"
#include "host/trace/render/renderer.h"

namespace candela::view {

/// All public members but the constructor belong to the window's thread, and return at once.
class Engine {
 public:
  /// Loads the scene; throws the exceptions of EngineHooks::load.
  Engine(EngineHooks hooks, Choice choice, Mode mode);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  EngineView view() const;
  /// Returns the number that EngineView::viewSerial has when the pictures show this camera.
  std::uint64_t setCamera(const scene::Camera& camera);
  void setMode(Mode mode, bool isPaused);
  void setChoice(const Choice& choice);
  /// Reads the scene again. After an error, the picture stays.
  void reload();
  /// Writes the picture as soon as each of its pixels has a sample, so that it is never a preview or an earlier view.
  void save(const std::filesystem::path& file, const image::DisplayTransform& display);
  /// Explains a sample of a pixel; the text appears in EngineView::explanation. With `searches`, it is the one of the
  /// pixel's first samples whose values on the two sides are furthest apart.
  void explain(const render::PixelSample& sample, bool searches);

 private:
  void loop();
  void iterate();
  std::optional<Step> nextStep() const;
  void apply(const Requests& requests);
  void load(const Choice& choice, bool reads);
  void measureRanges();
  void adopt(Sessions sessions, bool keepsPictures);
  void startDevice();
  void adoptDevice();
  void setMode(const NewMode& mode);
  void want();
  void restart();
  void run(const Step& step);
  bool trace(const Step& step, double start);
  void finish(const Step& step, double seconds);
  void show(Side side);
  void compareSides();
  void startSave(const SaveRequest& request);
  void finishSave();
  void saveNow(Side side, const SaveRequest& request);
  void explainNow(render::PixelSample sample, bool searches);
  void publish();
  void say(const std::string& message, bool isError);
  bool guarded(const std::function<void()>& work);
  void dropDevice(const std::string& reason);

  EngineHooks hooks_;

  // Used only by the engine's thread.
  Choice choice_;
  Mode mode_;
  bool isPaused_ = false;
  bool hasFailed_ = false;  ///< the next step; it waits for a request
  Sessions sessions_;
  scene::Camera camera_;
  std::optional<Schedule> schedule_;
  std::array<std::uint32_t, kSideCount> preparedScale_{};  ///< of the session's current view; 0: it is out of date
  std::array<std::shared_ptr<Picture>, kSideCount> pictures_;
  std::optional<SaveRequest> pendingSave_;  ///< waits until each pixel of the picture has a sample
  DevicePreparation coming_;
  EngineView next_;

  Inbox inbox_;
  mutable std::mutex mutex_;  ///< of `published_`
  EngineView published_;
  std::thread thread_;
};

}  // namespace candela::view
