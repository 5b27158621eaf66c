// Events of the window, as Dear ImGui sees them.
#include <imgui.h>

#include <catch2/catch.hpp>
#include <vector>

#include "host/app/window/key_map.h"

using namespace candela::window;

namespace {

class Gui {
 public:
  Gui() {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = ImVec2(100, 100);
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
  }
  ~Gui() { ImGui::DestroyContext(); }
  Gui(const Gui&) = delete;
  Gui& operator=(const Gui&) = delete;

  void button(bool isDown) { input_.pass({.kind = Event::Kind::button, .code = 0, .isDown = isDown}); }
  /// Draws a frame; returns whether it sees the left button pressed.
  bool isDownInFrame() {
    ImGui::NewFrame();
    const bool isDown = ImGui::IsMouseDown(0);
    ImGui::EndFrame();
    input_.finishFrame();
    return isDown;
  }

 private:
  GuiInput input_;
};

}  // namespace

TEST_CASE("a click between two frames is seen by one of them") {
  Gui gui;
  gui.button(true);
  gui.button(false);
  CHECK(gui.isDownInFrame());
  CHECK(!gui.isDownInFrame());
}

TEST_CASE("a button that is pressed again between two frames stays pressed") {
  Gui gui;
  gui.button(true);
  gui.button(false);
  gui.button(true);
  CHECK(gui.isDownInFrame());
  CHECK(gui.isDownInFrame());
  gui.button(false);
  CHECK(!gui.isDownInFrame());
}
