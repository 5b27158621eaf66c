// Collects the events that GLFW's callbacks report.
#include "host/app/window/window.h"

#include <fmt/format.h>

#include "host/base/errors.h"

namespace candela::window {
namespace {

view::Modifiers modifiersOf(int bits) { return {(bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_CONTROL) != 0}; }

}  // namespace

DesktopWindow::DesktopWindow(const Glfw& glfw, const render::Extent& size, const std::string& title) : glfw_(glfw) {
  glfw_.WindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfw_.CreateWindow(static_cast<int>(size.width), static_cast<int>(size.height), title.c_str(), nullptr,
                               nullptr);
  if (window_ == nullptr) {
    const char* reason = nullptr;
    glfw_.GetError(&reason);
    throw NoDeviceError(
        fmt::format("candela view cannot open a window: {}", reason != nullptr ? reason : "GLFW refuses"));
  }
  glfw_.SetWindowUserPointer(window_, this);
  connectEvents();
}

DesktopWindow::~DesktopWindow() { glfw_.DestroyWindow(window_); }

DesktopWindow& DesktopWindow::of(GLFWwindow* window) {
  return *static_cast<DesktopWindow*>(openGlfw().GetWindowUserPointer(window));
}

void DesktopWindow::connectEvents() {
  using Kind = Event::Kind;
  glfw_.SetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
    of(window).events_.push_back({.kind = Kind::move, .position = {x, y}});
  });
  glfw_.SetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int bits) {
    of(window).events_.push_back(
        {.kind = Kind::button, .code = button, .isDown = action == GLFW_PRESS, .modifiers = modifiersOf(bits)});
  });
  glfw_.SetScrollCallback(window_, [](GLFWwindow* window, double, double y) {
    of(window).events_.push_back({.kind = Kind::scroll, .steps = y});
  });
  glfw_.SetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int bits) {
    if (action == GLFW_REPEAT) return;
    of(window).events_.push_back(
        {.kind = Kind::key, .code = key, .isDown = action == GLFW_PRESS, .modifiers = modifiersOf(bits)});
  });
  glfw_.SetCharCallback(window_, [](GLFWwindow* window, unsigned int character) {
    of(window).events_.push_back({.kind = Kind::text, .code = static_cast<int>(character)});
  });
  glfw_.SetWindowFocusCallback(window_, [](GLFWwindow* window, int isFocused) {
    if (isFocused == GLFW_FALSE) of(window).events_.push_back({.kind = Kind::leave});
  });
}

// GLFW reports positions in units of the screen.
std::vector<Event> DesktopWindow::events(double seconds) {
  events_.clear();
  if (seconds > 0)
    glfw_.WaitEventsTimeout(seconds);
  else
    glfw_.PollEvents();
  int width = 0, height = 0;
  glfw_.GetWindowSize(window_, &width, &height);
  const double scale = width > 0 ? 1.0 * framebuffer().width / width : 1;
  for (Event& event : events_) event.position *= scale;
  return std::move(events_);
}

render::Extent DesktopWindow::framebuffer() const {
  int width = 0, height = 0;
  glfw_.GetFramebufferSize(window_, &width, &height);
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

vk::raii::SurfaceKHR DesktopWindow::surface(const vk::raii::Instance& instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  const VkResult result = glfw_.CreateWindowSurface(*instance, window_, nullptr, &surface);
  if (result != VK_SUCCESS)
    throw NoDeviceError(fmt::format("the window has no Vulkan surface: {}", vk::to_string(vk::Result(result))));
  return {instance, surface};
}

}  // namespace candela::window
