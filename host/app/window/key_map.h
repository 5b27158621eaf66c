// The keys and buttons of GLFW, and Dear ImGui's view of them.
#pragma once
#include <optional>
#include <vector>

#include "host/app/view/navigation.h"
#include "host/app/window/window.h"

namespace candela::window {

view::Button buttonOf(int glfwButton);
/// Returns nothing for a key without a meaning.
std::optional<view::Key> keyOf(int glfwKey);

/// Registers the keys that edit text with Dear ImGui, whose context must exist.
void prepareKeys();

/// Passes events to Dear ImGui, whose context must exist. Before version 1.87 it sees only what is pressed at the start
/// of a frame, so that a release is postponed if its press has not been seen yet.
class GuiInput {
 public:
  void pass(const Event& event);
  /// Call it after the widgets of each frame.
  void finishFrame();

 private:
  std::vector<Event> unseen_;     ///< presses since the last frame
  std::vector<Event> postponed_;  ///< releases of some of them
};

}  // namespace candela::window
