// The keys and buttons of GLFW, and Dear ImGui's view of them.
#pragma once
#include <optional>

#include "host/view/navigation.h"
#include "host/window/window.h"

namespace candela::window {

view::Button buttonOf(int glfwButton);
/// Returns nothing for a key without a meaning.
std::optional<view::Key> keyOf(int glfwKey);

/// Registers the keys that edit text with Dear ImGui, whose context must exist.
void prepareKeys();
/// Passes an event to Dear ImGui.
void passToGui(const Event& event);

}  // namespace candela::window
