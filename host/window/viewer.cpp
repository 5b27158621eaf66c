// The loop of the window: events, state, engine, frame.
#include "host/window/viewer.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <atomic>
#include <mutex>

#include "host/core/errors.h"
#include "host/core/interrupt.h"
#include "host/core/progress.h"
#include "host/device/film_means.h"
#include "host/image/false_colour.h"
#include "host/view/camera_text.h"
#include "host/view/file_watch.h"
#include "host/view/navigation.h"
#include "host/window/gui_painter.h"
#include "host/window/key_map.h"
#include "host/window/panels.h"
#include "host/window/picture_painter.h"
#include "host/window/presenter.h"
#include "host/window/window.h"

namespace candela::window {
namespace {

constexpr double kIdleSeconds = 0.1;
constexpr double kFlyingSeconds = 0.008;
constexpr double kMaxFlightSeconds = 0.05;  // of one step
constexpr double kWatchSeconds = 0.25;      // between two looks at the scene's file
constexpr std::uint32_t kPanelWidth = 352;  // of the panels, beside which the picture is placed
constexpr render::Extent kMinWindow{640, 460};

// The picture that the engine fills on the device, and the window reads.
class DevicePicture {
 public:
  explicit DevicePicture(vulkan::Device device) : device_(std::move(device)) {}

  bool update(render::Session& session, const render::Extent& size) {
    const std::scoped_lock lock(mutex_);
    if (!means_ || means_->size() != size) means_ = std::make_unique<device::FilmMeans>(device_, size);
    return means_->update(session);
  }
  std::optional<vulkan::Buffer> buffer(const render::Extent& size) const {
    const std::scoped_lock lock(mutex_);
    return means_ && means_->size() == size ? std::optional(means_->buffer()) : std::nullopt;
  }

 private:
  mutable std::mutex mutex_;
  vulkan::Device device_;
  std::unique_ptr<device::FilmMeans> means_;
};

std::vector<std::string> windowExtensions(const Glfw& glfw) {
  std::uint32_t count = 0;
  const char** const names = glfw.GetRequiredInstanceExtensions(&count);
  if (names == nullptr)
    throw NoDeviceError(
        "candela view needs a Vulkan driver that can present to this display; `candela doctor` examines the drivers");
  return {names, names + count};
}

vulkan::Device openPresenting(const ViewerOptions& options, const Glfw& glfw) {
  vulkan::Device device = options.openDevice(windowExtensions(glfw));
  if (!device.canPresent()) throw NoDeviceError(device.info().name + " cannot draw windows; choose another --device");
  return device;
}

class Gui {
 public:
  Gui() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::StyleColorsDark();
    prepareKeys();
  }
  ~Gui() { ImGui::DestroyContext(); }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;
};

class Viewer {
 public:
  explicit Viewer(const ViewerOptions& options);
  ~Viewer();
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;
  ViewerReport run();

 private:
  view::EngineHooks hooks();
  void handle(const Event& event);
  void apply(view::Action action);
  void apply(const PanelChoice& choice);
  void moveCamera();
  void fly();
  void followScene();
  void followIntegrator();
  void watchFile();
  void showWorst();
  void inspect();
  void save(const std::string& file);
  void chooseNextIntegrator();
  PaintedView painted() const;
  void draw();
  void measure();
  std::string title() const;
  void resize();
  void place();

  const ViewerOptions& options_;
  const Glfw& glfw_;
  vulkan::Device device_;
  DesktopWindow window_;
  Presenter presenter_;
  Gui gui_;
  PicturePainter picturePainter_;
  GuiPainter guiPainter_;
  DevicePicture devicePicture_;
  Panels panels_;
  view::ViewState state_;
  view::Engine engine_;
  view::EngineView shown_;
  view::CameraControl camera_;
  view::Navigation navigation_;
  view::FileWatch file_;
  render::PixelSample explained_;
  std::shared_ptr<const scene::Scene> scene_;
  render::Extent pictureSize_;
  std::optional<render::Integrator> integrator_;
  image::ToneMap lightToneMap_ = image::ToneMap::srgb;
  double lastTime_ = 0;
  double flewAt_ = 0;
  double lastWatch_ = 0;
  struct Waiting {
    std::uint64_t viewSerial;
    double since;
  };
  std::vector<Waiting> waiting_;   ///< events whose views are not shown yet, oldest first
  std::optional<double> movedAt_;  ///< time of the event that moved the camera, if the engine does not know it yet
  double eventTime_ = 0;
  bool isClosed_ = false;
  double response_ = 0;
  int framesToDraw_ = 2;
  std::string title_;
  ViewerReport report_;
};

std::string proposedFile(const std::filesystem::path& scene) { return scene.stem().string() + ".png"; }

render::Extent windowSizeFor(const render::Extent& picture) {
  return {std::max(picture.width + kPanelWidth, kMinWindow.width), std::max(picture.height, kMinWindow.height)};
}

Viewer::Viewer(const ViewerOptions& options)
    : options_(options),
      glfw_(openGlfw()),
      device_(openPresenting(options, glfw_)),
      window_(glfw_, windowSizeFor(options.size), "candela: " + options.scene.filename().string()),
      presenter_(device_, window_.surface(device_.impl()->instance.handle), window_.framebuffer()),
      picturePainter_(device_),
      guiPainter_(device_, presenter_.renderPass()),
      devicePicture_(device_),
      panels_(proposedFile(options.scene)),
      state_{.mode = options.mode, .display = options.display},
      engine_(hooks(), options.choice, options.mode),
      shown_(engine_.view()),
      camera_(*shown_.scene->camera),
      navigation_(state_, camera_),
      file_(options.scene),
      scene_(shown_.scene),
      pictureSize_(shown_.size) {
  place();
}

// What the last frame uses must outlive it.
Viewer::~Viewer() {
  try {
    presenter_.waitForLastFrame();
  } catch (const Error&) {  // the device is lost, and uses nothing any more
  }
}

// Puts the whole picture beside the panels.
void Viewer::place() {
  const render::Extent window = presenter_.size();
  state_.placement = view::placed(pictureSize_, window, std::min(kPanelWidth, window.width * 3 / 5));
}

view::EngineHooks Viewer::hooks() {
  view::EngineHooks hooks = options_.hooks;
  hooks.showOnDevice = [this](render::Session& session, const render::Extent& size) {
    return devicePicture_.update(session, size);
  };
  hooks.wake = [this] { window_.wake(); };
  return hooks;
}

void Viewer::handle(const Event& event) {
  eventTime_ = monotonicSeconds();
  passToGui(event);
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

void Viewer::moveCamera() {
  if (!movedAt_) movedAt_ = eventTime_;
}

void Viewer::apply(view::Action action) {
  switch (action) {
    case view::Action::cameraMoved:
      return moveCamera();
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
      return window_.copy(view::cameraText(camera_.camera()));
    case view::Action::nextIntegrator:
      return chooseNextIntegrator();
    case view::Action::quit:
      isClosed_ = true;
      return;
    case view::Action::none:
      return;
  }
}

void Viewer::apply(const PanelChoice& choice) {
  if (choice.choice) engine_.setChoice(*choice.choice);
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

void Viewer::save(const std::string& file) { engine_.save(file, state_.display); }

void Viewer::inspect() {
  if (state_.inspected) engine_.explain({state_.inspected->x, state_.inspected->y, state_.inspectedSample}, false);
}

void Viewer::showWorst() {
  if (!shown_.difference) return;
  state_.inspected = shown_.difference->worst;
  engine_.explain({state_.inspected->x, state_.inspected->y, 0}, true);
}

void Viewer::chooseNextIntegrator() {
  const int next = (static_cast<int>(shown_.choice.integrator) + 1) % (static_cast<int>(render::Integrator::cost) + 1);
  engine_.setChoice({shown_.choice.device, static_cast<render::Integrator>(next)});
}

// The time since the last frame, but none of the time in which the window waited for events.
void Viewer::fly() {
  eventTime_ = monotonicSeconds();
  const double seconds = std::min(eventTime_ - flewAt_, kMaxFlightSeconds);
  flewAt_ = eventTime_;
  apply(navigation_.pass(seconds));
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

// Until the device has a picture, that of the reference is shown.
PaintedView Viewer::painted() const {
  const view::SideView& device = shown_.sides[0];
  const bool showsReference = device.scale == 0 && shown_.sides[1].scale > 0;
  return {.picture = pictureSize_,
          .pictures = {device.picture, shown_.sides[1].picture},
          .onDevice = device.isOnDevice ? devicePicture_.buffer(pictureSize_) : std::nullopt,
          .mode = showsReference ? view::Mode::reference : state_.mode,
          .state = state_};
}

// The number of samples that the picture has, which is that of both sides where they are compared.
std::string Viewer::title() const {
  const view::SideView& device = shown_.sides[0];
  const view::SideView& reference = shown_.sides[1];
  const std::string name = options_.scene.filename().string();
  if (shown_.isPreparing) return name + ": preview - candela";
  const bool isReference = painted().mode == view::Mode::reference;
  std::uint32_t samples = isReference ? reference.samples : device.samples;
  if (comparesSides(state_.mode)) samples = std::min(samples, reference.samples);
  return fmt::format("{}: {} of {} samples - candela", name, samples, shown_.sampleCount);
}

void Viewer::draw() {
  if (std::string now = title(); now != title_) window_.setTitle(title_ = std::move(now));
  presenter_.waitForLastFrame();
  const render::Extent size = presenter_.size();
  if (size.width == 0 || size.height == 0) return;
  const PaintedView view = painted();
  picturePainter_.prepare(size, view);
  ImGui::GetIO().DisplaySize = ImVec2(static_cast<float>(size.width), static_cast<float>(size.height));
  ImGui::GetIO().DeltaTime = static_cast<float>(std::max(1e-4, monotonicSeconds() - lastTime_));
  lastTime_ = monotonicSeconds();
  ImGui::NewFrame();
  const PanelInput input{shown_,    options_.devices, picturePainter_.pointed(),
                         view.mode, response_,        view.onDevice.has_value()};
  const PanelChoice choice = panels_.draw(state_, input);
  drawDivider(state_, input);
  ImGui::Render();
  const bool isShown = presenter_.draw([&](const Presenter::Frame& frame) {
    vulkan::CommandRecorder recorder(frame.recorder);
    picturePainter_.record(recorder, view, presenter_.isBlueFirst());
    frame.recorder.makeVisibleToNext();
    copyToImage(frame, picturePainter_.pixels());
    guiPainter_.record(frame, presenter_.renderPass(), *ImGui::GetDrawData());
  });
  if (isShown) measure();
  apply(choice);
}

void Viewer::measure() {
  const double now = monotonicSeconds();
  ++report_.frames;
  report_.presentsFromDevice = shown_.sides[0].isOnDevice;
  const bool hasPicture = shown_.sides[0].scale > 0 || shown_.sides[1].scale > 0;
  if (hasPicture && report_.firstPicture == 0) report_.firstPicture = now - options_.start;
  std::erase_if(waiting_, [&](const Waiting& each) {
    if (each.viewSerial > shown_.viewSerial) return false;
    response_ = now - each.since;
    report_.responses.push_back(response_);
    return true;
  });
}

void Viewer::resize() {
  const render::Extent before = presenter_.size();
  presenter_.resize(window_.framebuffer());
  if (presenter_.size() != before) place();
}

// A frame is drawn whenever something may have changed, and once more for what Dear ImGui does a frame late.
ViewerReport Viewer::run() {
  const std::atomic<bool>& interrupted = watchInterrupts();
  lastTime_ = monotonicSeconds();
  while (!isClosed_ && !window_.mustClose() && !interrupted) {
    const bool isBusy = navigation_.isFlying() || framesToDraw_ > 0;
    const std::vector<Event> events = window_.events(isBusy ? kFlyingSeconds : kIdleSeconds);
    for (const Event& event : events) handle(event);
    if (navigation_.isFlying()) fly();
    if (movedAt_) {
      waiting_.push_back({engine_.setCamera(camera_.camera()), *movedAt_});
      movedAt_.reset();
    }
    watchFile();
    const std::uint64_t serial = shown_.serial;
    shown_ = engine_.view();
    followScene();
    if (window_.framebuffer() != presenter_.size()) resize();
    if (!events.empty() || shown_.serial != serial) framesToDraw_ = 2;
    if (framesToDraw_ == 0) continue;
    --framesToDraw_;
    draw();
  }
  report_.last = engine_.view();
  return report_;
}

}  // namespace

ViewerReport runViewer(const ViewerOptions& options) {
  watchInterrupts();  // from here on, a signal closes the window
  return Viewer(options).run();
}

}  // namespace candela::window
