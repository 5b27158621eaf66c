// Applies events, keys and the choices of panels.
#include <imgui.h>

#include <algorithm>

#include "host/core/progress.h"
#include "host/view/camera_text.h"
#include "host/window/key_map.h"
#include "host/window/viewer_loop.h"

namespace candela::window {
namespace {

constexpr double kMaxFlightSeconds = 0.05;  // of one step

}  // namespace

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
    case view::Action::quit:
      isClosed_ = true;
      return;
    case view::Action::none:
      return;
  }
}

void Viewer::apply(const PanelChoice& choice) {
  if (choice.choice) choose(*choice.choice);
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

}  // namespace candela::window
