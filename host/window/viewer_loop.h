// The loop of the viewer's window. viewer.cpp has the frames, viewer_input.cpp the user's input.
#pragma once
#include <memory>
#include <optional>
#include <string>

#include "host/view/file_watch.h"
#include "host/view/navigation.h"
#include "host/window/panels.h"
#include "host/window/response_meter.h"
#include "host/window/screen.h"
#include "host/window/viewer.h"

namespace candela::window {

/// The window, its state and the engine behind it.
class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options);
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  ViewerReport run();

 private:
  view::EngineHooks hooks();
  void handle(const Event& event);
  void apply(view::Action action);
  void apply(const PanelChoice& choice);
  void fly();
  void followScene();
  void followIntegrator();
  void watchFile();
  void showWorst();
  void inspect();
  void save(const std::string& file);
  void sendCamera();
  void chooseNextIntegrator();
  void choose(const view::Choice& choice);
  PaintedView painted() const;
  void draw();
  void measure();
  void place();

  const ViewerOptions& options_;
  Screen screen_;
  Panels panels_;
  view::ViewState state_;
  view::Engine engine_;
  view::EngineView shown_;
  view::Choice choice_;  ///< the last one, which the engine may not have adopted yet
  view::CameraControl camera_;
  view::Navigation navigation_;
  view::FileWatch file_;
  render::PixelSample explained_;
  std::shared_ptr<const scene::Scene> scene_;
  render::Extent pictureSize_;
  std::optional<render::Integrator> integrator_;
  image::ToneMap lightToneMap_ = image::ToneMap::srgb;
  double flewAt_ = 0;
  double lastWatch_ = 0;
  ResponseMeter responses_;
  double eventTime_ = 0;
  bool isClosed_ = false;
  int framesToDraw_ = 2;
  ViewerReport report_;
};

}  // namespace candela::window
