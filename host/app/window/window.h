// A window of the desktop, whose events become calls of view::Navigation or of Dear ImGui.
#pragma once
#include <functional>
#include <string>
#include <vector>
#include <vulkan/vulkan_raii.hpp>

#include "host/app/view/navigation.h"
#include "host/app/window/glfw.h"
#include "host/trace/render/extent.h"

namespace candela::window {

/// One event of the window. Positions are in pixels of the framebuffer.
struct Event {
  enum class Kind { move, button, scroll, key, text, leave };
  Kind kind;
  glm::dvec2 position{0};  ///< of `move`
  int code = 0;            ///< button or key of GLFW, or the Unicode character of `text`
  bool isDown = false;
  double steps = 0;  ///< of `scroll`
  view::Modifiers modifiers{};
};

class DesktopWindow {
 public:
  /// Throws NoDeviceError.
  DesktopWindow(const Glfw& glfw, const render::Extent& size, const std::string& title);
  ~DesktopWindow();
  DesktopWindow(const DesktopWindow&) = delete;
  DesktopWindow& operator=(const DesktopWindow&) = delete;

  /// Waits for events, at most `seconds`, and returns them in their order. wake() of any thread ends the wait.
  std::vector<Event> events(double seconds);
  void wake() const { glfw_.PostEmptyEvent(); }
  bool mustClose() const { return glfw_.WindowShouldClose(window_) == GLFW_TRUE; }
  render::Extent framebuffer() const;
  void setTitle(const std::string& title) const { glfw_.SetWindowTitle(window_, title.c_str()); }
  void copy(const std::string& text) const { glfw_.SetClipboardString(window_, text.c_str()); }
  vk::raii::SurfaceKHR surface(const vk::raii::Instance& instance) const;

 private:
  static DesktopWindow& of(GLFWwindow* window);
  void connectEvents();

  const Glfw& glfw_;
  GLFWwindow* window_;
  std::vector<Event> events_;
};

}  // namespace candela::window
