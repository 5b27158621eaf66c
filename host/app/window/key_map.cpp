// Tables of keys.
#include "host/app/window/key_map.h"

#include <imgui.h>

#include <algorithm>
#include <array>

namespace candela::window {
namespace {

using view::Key;

struct KeyPair {
  int glfw;
  Key key;
};
constexpr std::array kKeys{KeyPair{GLFW_KEY_A, Key::a},
                           KeyPair{GLFW_KEY_C, Key::c},
                           KeyPair{GLFW_KEY_D, Key::d},
                           KeyPair{GLFW_KEY_E, Key::e},
                           KeyPair{GLFW_KEY_H, Key::h},
                           KeyPair{GLFW_KEY_I, Key::i},
                           KeyPair{GLFW_KEY_K, Key::k},
                           KeyPair{GLFW_KEY_L, Key::l},
                           KeyPair{GLFW_KEY_N, Key::n},
                           KeyPair{GLFW_KEY_P, Key::p},
                           KeyPair{GLFW_KEY_Q, Key::q},
                           KeyPair{GLFW_KEY_R, Key::r},
                           KeyPair{GLFW_KEY_S, Key::s},
                           KeyPair{GLFW_KEY_T, Key::t},
                           KeyPair{GLFW_KEY_V, Key::v},
                           KeyPair{GLFW_KEY_W, Key::w},
                           KeyPair{GLFW_KEY_1, Key::one},
                           KeyPair{GLFW_KEY_2, Key::two},
                           KeyPair{GLFW_KEY_3, Key::three},
                           KeyPair{GLFW_KEY_4, Key::four},
                           KeyPair{GLFW_KEY_SPACE, Key::space},
                           KeyPair{GLFW_KEY_ESCAPE, Key::escape},
                           KeyPair{GLFW_KEY_LEFT_BRACKET, Key::bracketLeft},
                           KeyPair{GLFW_KEY_COMMA, Key::comma},
                           KeyPair{GLFW_KEY_PERIOD, Key::period},
                           KeyPair{GLFW_KEY_RIGHT_BRACKET, Key::bracketRight}};

// The keys that edit text.
struct EditingKey {
  int glfw;
  ImGuiKey gui;
};
constexpr std::array kEditingKeys{
    EditingKey{GLFW_KEY_BACKSPACE, ImGuiKey_Backspace}, EditingKey{GLFW_KEY_DELETE, ImGuiKey_Delete},
    EditingKey{GLFW_KEY_LEFT, ImGuiKey_LeftArrow},      EditingKey{GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    EditingKey{GLFW_KEY_HOME, ImGuiKey_Home},           EditingKey{GLFW_KEY_END, ImGuiKey_End},
    EditingKey{GLFW_KEY_ENTER, ImGuiKey_Enter},         EditingKey{GLFW_KEY_TAB, ImGuiKey_Tab},
    EditingKey{GLFW_KEY_ESCAPE, ImGuiKey_Escape}};

// Version 1.87 of Dear ImGui replaced the table of keys by events.
void passKey(const EditingKey& key, bool isDown) {
#if IMGUI_VERSION_NUM >= 18700
  ImGui::GetIO().AddKeyEvent(key.gui, isDown);
#else
  ImGui::GetIO().KeysDown[key.glfw] = isDown;
#endif
}

bool isSameInput(const Event& a, const Event& b) { return a.kind == b.kind && a.code == b.code; }

void passNow(const Event& event) {
  ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case Event::Kind::move:
      io.MousePos = ImVec2(static_cast<float>(event.position.x), static_cast<float>(event.position.y));
      return;
    case Event::Kind::button:
      if (event.code >= 0 && event.code < 3) io.MouseDown[event.code] = event.isDown;
      return;
    case Event::Kind::scroll:
      io.MouseWheel += static_cast<float>(event.steps);
      return;
    case Event::Kind::text:
      io.AddInputCharacter(static_cast<unsigned int>(event.code));
      return;
    case Event::Kind::key:
      io.KeyShift = event.modifiers.shift;
      io.KeyCtrl = event.modifiers.control;
      for (const EditingKey& key : kEditingKeys) {
        if (key.glfw == event.code) passKey(key, event.isDown);
      }
      return;
    case Event::Kind::leave:
      return;
  }
}

}  // namespace

view::Button buttonOf(int glfwButton) {
  if (glfwButton == GLFW_MOUSE_BUTTON_RIGHT) return view::Button::right;
  return glfwButton == GLFW_MOUSE_BUTTON_MIDDLE ? view::Button::middle : view::Button::left;
}

std::optional<view::Key> keyOf(int glfwKey) {
  const auto found = std::ranges::find(kKeys, glfwKey, &KeyPair::glfw);
  return found == kKeys.end() ? std::nullopt : std::optional(found->key);
}

void prepareKeys() {
#if IMGUI_VERSION_NUM < 18700
  for (const EditingKey& key : kEditingKeys) ImGui::GetIO().KeyMap[key.gui] = key.glfw;
#endif
}

void GuiInput::pass(const Event& event) {
  const auto isSame = [&](const Event& other) { return isSameInput(other, event); };
  if (event.isDown) {
    std::erase_if(postponed_, isSame);
    unseen_.push_back(event);
  } else if (std::ranges::any_of(unseen_, isSame)) {
    postponed_.push_back(event);
    return;
  }
  passNow(event);
}

void GuiInput::finishFrame() {
  unseen_.clear();
  for (const Event& event : postponed_) passNow(event);
  postponed_.clear();
}

}  // namespace candela::window
