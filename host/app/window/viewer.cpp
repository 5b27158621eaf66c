// The loop of the window: events, state, engine, frame.
#include "host/app/window/viewer.h"

#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <optional>
#include <string>

#include "host/app/view/camera_text.h"
#include "host/app/view/file_watch.h"
#include "host/app/view/navigation.h"
#include "host/app/view/playback.h"
#include "host/app/window/key_map.h"
#include "host/app/window/panels.h"
#include "host/app/window/response_meter.h"
#include "host/app/window/screen.h"
#include "host/base/interrupt.h"
#include "host/base/progress.h"
#include "host/image/false_colour.h"

namespace candela::window {
namespace {

constexpr double kIdleSeconds = 0.1;
constexpr double kFlyingSeconds = 0.008;
constexpr double kMaxFlightSeconds = 0.05;  // of one step
constexpr double kWatchSeconds = 0.25;      // between two checks of the scene's file
constexpr std::uint32_t kPanelWidth = 352;  // of the panels, beside which the picture is placed
constexpr render::Extent kMinWindow{640, 460};

std::string proposedFile(const std::filesystem::path& scene) { return scene.stem().string() + ".png"; }

render::Extent windowSizeFor(const render::Extent& picture) {
  return {std::max(picture.width + kPanelWidth, kMinWindow.width), std::max(picture.height, kMinWindow.height)};
}

// The window, its state and the engine behind it.
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
  view::Choice withTime(view::Choice choice) const;
  void chooseTime(double time);
  void playOrPause();
  void playOn();
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
  view::Playback playback_;
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

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      screen_(options, windowSizeFor(options.size)),
      panels_(proposedFile(options.scene)),
      state_{.mode = options.mode, .display = options.display},
      engine_(hooks(), options.choice, options.mode),
      shown_(engine_.view()),
      choice_(options.choice),
      camera_(*shown_.scene->camera),
      navigation_(state_, camera_),
      file_(options.scene),
      scene_(shown_.scene),
      pictureSize_(shown_.size) {
  place();
}

// Puts the whole picture beside the panels.
void Viewer::place() {
  const render::Extent window = screen_.size();
  state_.placement = view::placed(pictureSize_, window, std::min(kPanelWidth, window.width * 3 / 5));
}

view::EngineHooks Viewer::hooks() {
  view::EngineHooks hooks = options_.hooks;
  hooks.showOnDevice = [this](render::Session& session, const render::Extent& size) {
    return screen_.devicePicture().update(session, size);
  };
  hooks.wake = [this] { screen_.window().wake(); };
  return hooks;
}

// Depths and costs are shown in false colours.
void Viewer::followIntegrator() {
  state_.display.scale = shown_.falseColourScale;
  if (integrator_ == shown_.choice.integrator) return;
  integrator_ = shown_.choice.integrator;
  if (!isFalseColour(state_.display.toneMap)) lightToneMap_ = state_.display.toneMap;
  const bool isDepth = integrator_ == render::Integrator::depth;
  const image::ToneMap falseColours = isDepth ? image::ToneMap::depth : image::ToneMap::heat;
  state_.display.toneMap = isDepth || integrator_ == render::Integrator::cost ? falseColours : lightToneMap_;
}

// A scene that was read again keeps the user's camera unless the file has another one.
void Viewer::followScene() {
  followIntegrator();
  if (explained_ != shown_.explained) state_.inspectedSample = shown_.explained.index;
  explained_ = shown_.explained;
  if (shown_.scene == scene_) return;
  if (view::cameraText(*shown_.scene->camera) != view::cameraText(*scene_->camera))
    camera_.restart(*shown_.scene->camera);
  scene_ = shown_.scene;
  state_.inspected.reset();
  if (shown_.size == pictureSize_) return;
  pictureSize_ = shown_.size;
  place();
}

void Viewer::watchFile() {
  const double now = monotonicSeconds();
  if (now - lastWatch_ < kWatchSeconds) return;
  lastWatch_ = now;
  if (file_.hasChanged()) engine_.reload();
}

void Viewer::handle(const Event& event) {
  eventTime_ = monotonicSeconds();
  screen_.guiInput().pass(event);
  const ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Event::Kind::move:
      return apply(navigation_.moveTo(event.position, pictureSize_));
    case Event::Kind::button:
      if (!event.isDown) return apply(navigation_.release(buttonOf(event.code), pictureSize_));
      if (!io.WantCaptureMouse) apply(navigation_.press(buttonOf(event.code), event.modifiers, pictureSize_));
      return;
    case Event::Kind::scroll:
      if (!io.WantCaptureMouse) apply(navigation_.scroll(event.steps, {io.KeyShift, io.KeyCtrl}));
      return;
    case Event::Kind::key:
      if (const auto key = keyOf(event.code)) {
        if (!event.isDown)
          navigation_.release(*key);
        else if (!io.WantTextInput)
          apply(navigation_.press(*key, event.modifiers));
      }
      return;
    case Event::Kind::leave:
      return navigation_.letGo();
    case Event::Kind::text:
      return;
  }
}

void Viewer::apply(view::Action action) {
  switch (action) {
    case view::Action::cameraMoved:
      return responses_.moved(eventTime_);
    case view::Action::modeChanged:
      return engine_.setMode(state_.mode, state_.isPaused);
    case view::Action::inspect:
      return inspect();
    case view::Action::worstPixel:
      return showWorst();
    case view::Action::save:
      return save(panels_.file());
    case view::Action::reload:
      return engine_.reload();
    case view::Action::copyCamera:
      return screen_.window().copy(view::cameraText(camera_.camera()));
    case view::Action::nextIntegrator:
      return chooseNextIntegrator();
    case view::Action::nextLayer:
    case view::Action::previousLayer:
      return choose(withLayer(choice_, view::nextLayer(choice_.layer, action == view::Action::previousLayer)));
    case view::Action::playOrPause:
      return playOrPause();
    case view::Action::quit:
      isClosed_ = true;
      return;
    case view::Action::none:
      return;
  }
}

void Viewer::apply(const PanelChoice& choice) {
  if (choice.choice) choose(withTime(*choice.choice));
  if (choice.time) {
    playback_.pause();
    chooseTime(*choice.time);
  }
  if (choice.playOrPause) apply(view::Action::playOrPause);
  if (choice.mode) {
    state_.mode = *choice.mode;
    apply(view::Action::modeChanged);
  }
  if (choice.file) save(*choice.file);
  if (choice.reload) apply(view::Action::reload);
  if (choice.copyCamera) apply(view::Action::copyCamera);
  if (choice.inspect) inspect();
  if (choice.inspectWorst) showWorst();
}

// The camera may have moved by an event just before.
void Viewer::save(const std::string& file) {
  sendCamera();
  engine_.save(file, state_.display);
}

void Viewer::sendCamera() {
  if (responses_.hasMoved()) responses_.sent(engine_.setCamera(camera_.camera()));
}

void Viewer::inspect() {
  if (state_.inspected) engine_.explain({state_.inspected->x, state_.inspected->y, state_.inspectedSample}, false);
}

void Viewer::showWorst() {
  if (!shown_.difference) return;
  state_.inspected = shown_.difference->worst;
  engine_.explain({state_.inspected->x, state_.inspected->y, 0}, true);
}

void Viewer::chooseNextIntegrator() {
  const int next = (static_cast<int>(choice_.integrator) + 1) % (static_cast<int>(render::Integrator::cost) + 1);
  choose(withIntegrator(choice_, static_cast<render::Integrator>(next)));
}

// The choices of panels are made from those of the picture, whose time may be an earlier one.
view::Choice Viewer::withTime(view::Choice choice) const {
  choice.time = choice_.time;
  return choice;
}

void Viewer::chooseTime(double time) {
  view::Choice next = choice_;
  next.time = time;
  if (next != choice_) choose(next);
}

void Viewer::playOrPause() {
  if (playback_.isPlaying()) return playback_.pause();
  if (shown_.animationEnd.value_or(0) > 0) playback_.play(choice_.time.value_or(0), monotonicSeconds());
}

// Each frame is shown with a sample of each pixel at least.
void Viewer::playOn() {
  if (!playback_.isPlaying() || !showsTime(shown_, choice_, state_.mode)) return;
  const double end = shown_.animationEnd.value_or(0);
  if (end <= 0) return playback_.pause();
  chooseTime(playback_.timeAt(monotonicSeconds(), end));
}

void Viewer::choose(const view::Choice& choice) {
  choice_ = choice;
  engine_.setChoice(choice);
}

// The time since the last frame, but none of the time in which the window waited for events.
void Viewer::fly() {
  eventTime_ = monotonicSeconds();
  const double seconds = std::min(eventTime_ - flewAt_, kMaxFlightSeconds);
  flewAt_ = eventTime_;
  apply(navigation_.pass(seconds));
}

PaintedView Viewer::painted() const {
  const view::SideView& device = shown_.sides[0];
  return {.picture = pictureSize_,
          .pictures = {device.picture, shown_.sides[1].picture},
          .onDevice = device.isOnDevice ? screen_.devicePicture().buffer(pictureSize_) : std::nullopt,
          .mode = shownMode(shown_, state_.mode),
          .colours = view::coloursOf(shown_.choice.layer, state_.display, shown_.layerRange, shown_.sampleCount),
          .isLight = view::isLight(shown_.choice.layer),
          .state = state_};
}

void Viewer::draw() {
  screen_.setTitle(titleOf(shown_, state_.mode, options_.scene.filename().string()));
  const PaintedView view = painted();
  PanelChoice choice;
  const bool isShown = screen_.draw(view, [&](const gpu::PointedValues& pointed) {
    const PanelInput input{shown_,
                           options_.devices,
                           pointed,
                           view.mode,
                           responses_.last(),
                           view.onDevice.has_value(),
                           playback_.isPlaying()};
    choice = panels_.draw(state_, input);
    drawDivider(state_, input);
  });
  const bool isMinimised = screen_.size().width == 0 || screen_.size().height == 0;
  if (isShown) {
    measure();
  } else if (!isMinimised) {
    framesToDraw_ = std::max(framesToDraw_, 1);
  }
  apply(choice);
}

void Viewer::measure() {
  ++report_.frames;
  report_.presentsFromDevice = shown_.sides[0].isOnDevice;
  const bool hasPicture = shown_.sides[0].scale > 0 || shown_.sides[1].scale > 0;
  if (hasPicture && report_.firstPicture == 0) report_.firstPicture = monotonicSeconds() - options_.start;
  responses_.shown(shown_.viewSerial);
}

// A frame is drawn whenever something may have changed, and once more for changes that Dear ImGui draws one frame
// later.
ViewerReport Viewer::run() {
  const std::atomic<bool>& interrupted = watchInterrupts();
  while (!isClosed_ && !screen_.window().mustClose() && !interrupted) {
    const bool isBusy = navigation_.isFlying() || playback_.isPlaying() || framesToDraw_ > 0;
    const std::vector<Event> events = screen_.window().events(isBusy ? kFlyingSeconds : kIdleSeconds);
    for (const Event& event : events) handle(event);
    if (navigation_.isFlying()) fly();
    sendCamera();
    watchFile();
    const std::uint64_t serial = shown_.serial;
    shown_ = engine_.view();
    followScene();
    playOn();
    if (screen_.resize()) {
      place();
      framesToDraw_ = 2;
    }
    if (!events.empty() || shown_.serial != serial) framesToDraw_ = 2;
    if (shown_.isError && shown_.serial != serial) choice_ = shown_.choice;  // a choice may have been refused
    if (framesToDraw_ == 0) continue;
    --framesToDraw_;
    draw();
  }
  report_.responses = responses_.seconds();
  report_.last = engine_.view();
  return report_;
}

}  // namespace

ViewerReport runViewer(const ViewerOptions& options) {
  watchInterrupts();  // from here on, a signal closes the window
  return Viewer(options).run();
}

}  // namespace candela::window
