// The worker of a viewer: renders with one tracer or both, on a thread of its own, so that input never waits.
#pragma once
#include <atomic>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/render/renderer.h"
#include "host/view/picture.h"
#include "host/view/view_state.h"

namespace candela::view {

/// The choices of a user for a render, besides the camera.
struct Choice {
  std::string device;  ///< as --device; "cpu": the reference alone
  render::Integrator integrator = render::Integrator::path;

  bool operator==(const Choice&) const = default;
};

/// A scene and the sessions that render it. The order of the members is that in which they depend on each other.
struct Sessions {
  std::shared_ptr<const scene::Scene> scene;
  render::RenderSettings settings;  ///< `image.size` is the full resolution
  std::unique_ptr<render::Renderer> deviceRenderer, referenceRenderer;
  std::unique_ptr<render::Session> device, reference;  ///< the device's is null if the reference is alone
  std::string deviceName;

  render::Session* session(Side side) const { return side == Side::device ? device.get() : reference.get(); }
};

/// The functions of the program around the engine. All may throw Error.
struct EngineHooks {
  /// Prepares the reference, which takes little time, with the scene as it is, or as it is in its file now.
  std::function<Sessions(const Choice&, bool reads)> load;
  /// Adds the device's session to a copy of `sessions` without any, and has its driver compile. On another thread.
  std::function<void(const Choice&, Sessions&)> addDevice;
  /// Copies the film of the device to the picture that the window shows, on the device. Returns false if the window
  /// cannot show it from there, so that the engine reads the film.
  std::function<bool(render::Session&, const render::Extent& size)> showOnDevice;
  /// Writes an image file.
  std::function<void(const std::filesystem::path&, const Sessions&, const image::Film&, const render::RenderStatistics&,
                     const Choice&, const image::DisplayTransform&)>
      save;
  /// Called from the engine's thread whenever there is something new to show.
  std::function<void()> wake;
};

/// The state and the picture of one side.
struct SideView {
  bool hasSession = false;
  std::uint32_t scale = 0;                 ///< of the picture; 0: none yet
  std::uint32_t samples = 0;               ///< of each pixel
  double seconds = 0;                      ///< of rendering since the last change of the view
  bool isOnDevice = false;                 ///< the picture is what EngineHooks::showOnDevice last showed
  std::shared_ptr<const Picture> picture;  ///< null if it is on the device, or there is none
};

/// A consistent state of the engine, for the window.
struct EngineView {
  std::uint64_t serial = 0;
  Choice choice;
  render::Extent size;
  std::uint32_t sampleCount = 0;
  std::string deviceName;
  bool isPreparing = false;  ///< the device's session is not ready, and the reference is shown
  std::array<SideView, kSideCount> sides;
  std::uint64_t viewSerial = 0;  ///< number of setCamera() that the pictures show
  std::optional<PictureDifference> difference;
  float falseColourScale = 1;                 ///< image::falseColourScale() of the integrators `depth` and `cost`
  std::string message;                        ///< about the last save, reload or failure; empty: none
  bool isError = false;                       ///< of `message`
  render::PixelSample explained;              ///< by `explanation`
  std::string explanation;                    ///< text of `candela explain`
  std::shared_ptr<const scene::Scene> scene;  ///< changes when a file was read again
};

/// All public members but the constructor belong to the window's thread, and return at once.
class Engine {
 public:
  /// Loads the scene; throws what EngineHooks::load throws.
  Engine(EngineHooks hooks, Choice choice, Mode mode);
  ~Engine();
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  EngineView view() const;
  /// Returns the number that EngineView::viewSerial has when the pictures show this camera.
  std::uint64_t setCamera(const scene::Camera& camera);
  void setMode(Mode mode, bool isPaused);
  void setChoice(const Choice& choice);
  /// Reads the scene again. An error leaves what is shown.
  void reload();
  void save(const std::filesystem::path& file, const image::DisplayTransform& display);
  /// Explains a sample of a pixel; the text appears in EngineView::explanation. With `searches`, it is the one of the
  /// pixel's first samples whose values on the two sides are furthest apart.
  void explain(const render::PixelSample& sample, bool searches);

 private:
  struct SaveRequest {
    std::filesystem::path file;
    image::DisplayTransform display;
  };
  struct Requests {
    std::optional<scene::Camera> camera;
    std::uint64_t viewSerial = 0;
    std::optional<Choice> load;
    bool reads = false;  ///< the file, before `load`
    std::optional<SaveRequest> save;
    std::optional<render::PixelSample> sample;
    bool searches = false;  ///< for the `sample` that differs most
    struct NewMode {
      Mode mode;
      bool isPaused;
    };
    std::optional<NewMode> mode;
    bool hasAny() const { return camera || load || save || sample || mode; }
  };

  void request(const std::function<void(Requests&)>& set);
  void loop();
  void iterate();
  std::optional<Requests> takeRequests(bool mayWait);
  void apply(const Requests& requests);
  void load(const Choice& choice, bool reads);
  void measureFalseColours();
  void adopt(Sessions sessions);
  void startDevice();
  void adoptDevice();
  void setMode(const Requests::NewMode& mode);
  void want();
  void restart();
  void run(const Step& step);
  bool trace(const Step& step, double start);
  void finish(const Step& step, double seconds);
  void show(Side side);
  void compareSides();
  void saveNow(const SaveRequest& request);
  void explainNow(render::PixelSample sample, bool searches);
  std::uint32_t worstSample(render::PixelSample sample);
  void publish();
  void say(const std::string& message, bool isError);
  bool guarded(const std::function<void()>& work);
  void dropDevice(const std::string& reason);

  EngineHooks hooks_;

  // Of the engine's thread.
  Choice choice_;
  Mode mode_;
  bool isPaused_ = false;
  Sessions sessions_;
  scene::Camera camera_;
  std::optional<Schedule> schedule_;
  std::array<std::uint32_t, kSideCount> preparedScale_{};  ///< of the session's current view; 0: it is out of date
  std::array<std::shared_ptr<Picture>, kSideCount> pictures_;
  std::future<Sessions> coming_;                  ///< the sessions with that of the device
  std::vector<std::future<Sessions>> abandoned_;  ///< preparations whose results are not wanted any more
  EngineView next_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Requests requests_;
  EngineView published_;
  std::atomic<bool> interrupted_{false};  ///< there are requests
  std::atomic<bool> ended_{false};
  std::thread thread_;
};

}  // namespace candela::view
