// Translates mouse and keyboard input into changes of the view: camera, mode, divider. It is independent of the window
// system.
#pragma once
#include <cstdint>
#include <set>

#include "host/app/view/camera_control.h"
#include "host/app/view/view_state.h"

namespace candela::view {

enum class Button { left, middle, right };
enum class Key {
  a,
  c,
  d,
  e,
  h,
  i,
  k,
  l,
  n,
  p,
  q,
  r,
  s,
  t,
  v,
  w,
  one,
  two,
  three,
  four,
  space,
  escape,
  bracketLeft,
  bracketRight,
  comma,
  period
};
struct Modifiers {
  bool shift = false;
  bool control = false;
};

/// The action that an event requires of the caller; everything else is in the state.
enum class Action {
  none,
  cameraMoved,
  modeChanged,
  inspect,
  save,
  reload,
  copyCamera,
  nextIntegrator,
  nextLayer,
  previousLayer,
  worstPixel,
  playOrPause,
  quit
};

/// Dragging orbits (left), pans (middle, or left with Shift) or looks around (right); with Ctrl, it moves the picture
/// in the window. The wheel changes the distance from the target; with Ctrl, the magnification. W, A, S, D, Q and E fly
/// as long as they are pressed. A drag that begins at the divider moves it. A click inspects a pixel.
class Navigation {
 public:
  static constexpr double kDividerReach = 6;  ///< pixels of the window
  static constexpr double kClickReach = 3;    ///< pixels by which a click may move
  static constexpr double kRadiansPerPixel = 0.008;
  static constexpr double kFlightPerSecond = 0.5;  ///< distances from the target; four times as many with Shift

  Navigation(ViewState& state, CameraControl& camera) : state_(state), camera_(camera) {}

  /// `picture` is the size of the picture; positions are in pixels of the window.
  Action press(Button button, Modifiers modifiers, const render::Extent& picture);
  Action release(Button button, const render::Extent& picture);
  Action moveTo(const glm::dvec2& position, const render::Extent& picture);
  Action scroll(double steps, Modifiers modifiers);
  Action press(Key key, Modifiers modifiers);
  void release(Key key) { pressed_.erase(key); }
  /// Flies for a time; returns cameraMoved if a key for this is pressed.
  Action pass(double seconds);
  bool isFlying() const;
  /// Forgets which keys and buttons are pressed, when the window loses the focus.
  void letGo();

 private:
  enum class Drag { none, orbit, pan, look, picture, divider };
  Action drag(const glm::dvec2& moved, const render::Extent& picture);
  Action setMode(Mode mode);
  bool isAtDivider(const render::Extent& picture) const;

  ViewState& state_;
  CameraControl& camera_;
  Drag drag_ = Drag::none;
  glm::dvec2 dragStart_{0};
  bool isClick_ = false;
  bool isFast_ = false;
  std::set<Key> pressed_;
};

}  // namespace candela::view
