// GLFW, opened at run time.
#pragma once
#include <vulkan/vulkan.h>
// GLFW declares its functions for surfaces only after Vulkan's header.
#include <GLFW/glfw3.h>

namespace candela::window {

// clang-format off
#define CANDELA_GLFW_FUNCTIONS(F) \
  F(CreateWindow) F(CreateWindowSurface) F(DestroyWindow) F(GetError) F(GetFramebufferSize) \
  F(GetRequiredInstanceExtensions) F(GetWindowSize) F(GetWindowUserPointer) F(Init) \
  F(PostEmptyEvent) F(PollEvents) F(SetCharCallback) F(SetClipboardString) F(SetCursorPosCallback) \
  F(SetFramebufferSizeCallback) F(SetKeyCallback) F(SetMouseButtonCallback) F(SetScrollCallback) \
  F(SetWindowFocusCallback) F(SetWindowTitle) F(SetWindowUserPointer) F(Terminate) \
  F(WaitEventsTimeout) F(WindowHint) F(WindowShouldClose)
// clang-format on

/// The functions of the library, without its prefix.
struct Glfw {
#define CANDELA_DECLARE(name) decltype(&::glfw##name) name = nullptr;
  CANDELA_GLFW_FUNCTIONS(CANDELA_DECLARE)
#undef CANDELA_DECLARE
};

/// Opens the library once and connects to the display. Throws NoDeviceError with the package to install, or with the
/// remedy if there is no display.
const Glfw& openGlfw();

}  // namespace candela::window
