// The meaning of each key and drag.
#include "host/app/view/navigation.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela::view {
namespace {

struct Flight {
  Key key;
  glm::dvec3 direction;
};
const std::array kFlights{Flight{Key::w, {0, 0, 1}}, Flight{Key::s, {0, 0, -1}}, Flight{Key::a, {-1, 0, 0}},
                          Flight{Key::d, {1, 0, 0}}, Flight{Key::e, {0, 1, 0}},  Flight{Key::q, {0, -1, 0}}};

constexpr double kDollyPerStep = 0.9;
constexpr double kZoomPerStep = 1.25;
constexpr float kExposureStep = 0.25f;

}  // namespace

bool Navigation::isAtDivider(const render::Extent& picture) const {
  if (state_.mode != Mode::split) return false;
  const double x = state_.placement.origin.x + state_.placement.zoom * state_.divider * picture.width;
  return std::abs(state_.pointer.x - x) <= kDividerReach;
}

Action Navigation::press(Button button, Modifiers modifiers, const render::Extent& picture) {
  dragStart_ = state_.pointer;
  isClick_ = button == Button::left && !modifiers.shift && !modifiers.control;
  if (modifiers.control) {
    drag_ = Drag::picture;
  } else if (button == Button::right) {
    drag_ = Drag::look;
  } else if (button == Button::middle || modifiers.shift) {
    drag_ = Drag::pan;
  } else {
    drag_ = isAtDivider(picture) ? Drag::divider : Drag::orbit;
  }
  return Action::none;
}

Action Navigation::release(Button button, const render::Extent& picture) {
  const Drag ended = drag_;
  drag_ = Drag::none;
  if (button != Button::left || !isClick_ || ended == Drag::divider) return Action::none;
  isClick_ = false;
  state_.inspected = pixelAt(state_, picture, state_.pointer);
  return Action::inspect;
}

Action Navigation::moveTo(const glm::dvec2& position, const render::Extent& picture) {
  const glm::dvec2 moved = position - state_.pointer;
  if (glm::distance(position, dragStart_) > kClickReach) isClick_ = false;
  if (drag_ == Drag::orbit && isClick_) return Action::none;  // the pointer stays where it was for the drag
  state_.pointer = position;
  return drag_ == Drag::none ? Action::none : drag(moved, picture);
}

Action Navigation::drag(const glm::dvec2& moved, const render::Extent& picture) {
  const double height = state_.placement.zoom * picture.height;
  switch (drag_) {
    case Drag::orbit:
      camera_.orbit(kRadiansPerPixel * moved);
      return Action::cameraMoved;
    case Drag::look:
      camera_.look({kRadiansPerPixel * moved.x, -kRadiansPerPixel * moved.y});
      return Action::cameraMoved;
    case Drag::pan:
      camera_.pan(glm::dvec2(-moved.x, moved.y) / height);
      return Action::cameraMoved;
    case Drag::picture:
      state_.placement.origin += moved;
      return Action::none;
    default:
      state_.divider = std::clamp(state_.placement.toPicture(state_.pointer).x / picture.width, 0.0, 1.0);
      return Action::none;
  }
}

Action Navigation::scroll(double steps, Modifiers modifiers) {
  if (modifiers.control) {
    state_.placement.zoomAt(state_.pointer, state_.placement.zoom * std::pow(kZoomPerStep, steps));
    return Action::none;
  }
  camera_.dolly(std::pow(kDollyPerStep, steps));
  return Action::cameraMoved;
}

Action Navigation::setMode(Mode mode) {
  state_.mode = mode;
  return Action::modeChanged;
}

Action Navigation::press(Key key, Modifiers modifiers) {
  isFast_ = modifiers.shift;
  const auto expose = [&](float stops) {
    state_.display.exposure = std::clamp(state_.display.exposure + stops, -ViewState::kMaxExposure,
                                         ViewState::kMaxExposure);
    return Action::none;
  };
  const auto amplify = [&](int stops) {
    state_.differenceStops = std::clamp(state_.differenceStops + stops, 0, ViewState::kMaxGainStops);
    return Action::none;
  };
  switch (key) {
    case Key::one:
      return setMode(Mode::device);
    case Key::two:
      return setMode(Mode::reference);
    case Key::three:
      return setMode(Mode::split);
    case Key::four:
      return setMode(Mode::difference);
    case Key::bracketLeft:
      return expose(-kExposureStep);
    case Key::bracketRight:
      return expose(kExposureStep);
    case Key::comma:
      return amplify(-1);
    case Key::period:
      return amplify(1);
    case Key::t:
      cycleToneMap(state_);
      return Action::none;
    case Key::h:
      state_.arePanelsShown = !state_.arePanelsShown;
      return Action::none;
    case Key::space:
      state_.isPaused = !state_.isPaused;
      return Action::modeChanged;
    case Key::r:
      camera_.reset();
      return Action::cameraMoved;
    case Key::c:
      return Action::copyCamera;
    case Key::p:
      return Action::save;
    case Key::k:
      return Action::playOrPause;
    case Key::l:
      return Action::reload;
    case Key::i:
      return Action::nextIntegrator;
    case Key::v:
      return modifiers.shift ? Action::previousLayer : Action::nextLayer;
    case Key::n:
      return Action::worstPixel;
    case Key::escape:
      return Action::quit;
    default:
      pressed_.insert(key);
      return Action::none;
  }
}

bool Navigation::isFlying() const {
  return std::ranges::any_of(kFlights, [&](const Flight& flight) { return pressed_.contains(flight.key); });
}

Action Navigation::pass(double seconds) {
  glm::dvec3 direction(0);
  for (const Flight& flight : kFlights) {
    if (pressed_.contains(flight.key)) direction += flight.direction;
  }
  if (direction == glm::dvec3(0)) return Action::none;
  camera_.fly(direction * (seconds * kFlightPerSecond * (isFast_ ? 4 : 1)));
  return Action::cameraMoved;
}

void Navigation::letGo() {
  pressed_.clear();
  drag_ = Drag::none;
  isClick_ = false;
}

}  // namespace candela::view
