#include "app/ui/widgets/input_queue.h"

#include <algorithm>
#include <bitset>
#include <cfloat>
#include <iterator>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

namespace moltact {
namespace {

bool isModifier(int key) { return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER; }
bool writes(int key) { return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2; }

void setModifiers(ImGuiIO& io) {
  const auto either = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
  io.KeyCtrl = either(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
  io.KeyShift = either(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
  io.KeyAlt = either(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
  io.KeySuper = either(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
}

}  // namespace

InputQueue::InputQueue() {
  ImGuiIO& io = ImGui::GetIO();
  io.KeyMap[ImGuiKey_Tab] = -1;  // leads everywhere and not only from field to field: key_focus.h
  io.KeyMap[ImGuiKey_LeftArrow] = GLFW_KEY_LEFT;
  io.KeyMap[ImGuiKey_RightArrow] = GLFW_KEY_RIGHT;
  io.KeyMap[ImGuiKey_UpArrow] = GLFW_KEY_UP;
  io.KeyMap[ImGuiKey_DownArrow] = GLFW_KEY_DOWN;
  io.KeyMap[ImGuiKey_PageUp] = GLFW_KEY_PAGE_UP;
  io.KeyMap[ImGuiKey_PageDown] = GLFW_KEY_PAGE_DOWN;
  io.KeyMap[ImGuiKey_Home] = GLFW_KEY_HOME;
  io.KeyMap[ImGuiKey_End] = GLFW_KEY_END;
  io.KeyMap[ImGuiKey_Insert] = GLFW_KEY_INSERT;
  io.KeyMap[ImGuiKey_Delete] = GLFW_KEY_DELETE;
  io.KeyMap[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
  io.KeyMap[ImGuiKey_Space] = GLFW_KEY_SPACE;
  io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
  io.KeyMap[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
  io.KeyMap[ImGuiKey_KeyPadEnter] = GLFW_KEY_KP_ENTER;
  io.KeyMap[ImGuiKey_A] = GLFW_KEY_A;
  io.KeyMap[ImGuiKey_C] = GLFW_KEY_C;
  io.KeyMap[ImGuiKey_V] = GLFW_KEY_V;
  io.KeyMap[ImGuiKey_X] = GLFW_KEY_X;
  io.KeyMap[ImGuiKey_Y] = GLFW_KEY_Y;
  io.KeyMap[ImGuiKey_Z] = GLFW_KEY_Z;
}

void InputQueue::feed(ImGuiIO& io) {
  // Within a frame nothing changes twice, and nothing that was done after a change takes effect before it.
  std::bitset<GLFW_KEY_LAST + 1> keys_changed;
  std::bitset<8> buttons_changed;
  bool wheeled = false, wrote = false;
  while (!events_.empty()) {
    const InputEvent e = events_.front();
    switch (e.kind) {
      case InputEvent::Kind::Pointer:
        if (buttons_changed.any() || wheeled) return;
        io.MousePos = {float(e.place.x), float(e.place.y)};
        break;
      case InputEvent::Kind::PointerLeft:
        if (buttons_changed.any() || wheeled) return;
        io.MousePos = {-FLT_MAX, -FLT_MAX};
        break;
      case InputEvent::Kind::Button:
        if (e.code >= 0 && e.code < IM_ARRAYSIZE(io.MouseDown)) {
          if (buttons_changed[std::size_t(e.code)] || wheeled || keys_changed.any()) return;
          buttons_changed.set(std::size_t(e.code));
          io.MouseDown[e.code] = e.down;
        }
        break;
      case InputEvent::Kind::Wheel:
        if (buttons_changed.any()) return;
        wheeled = true;
        io.MouseWheelH += float(e.place.x);
        io.MouseWheel += float(e.place.y);
        break;
      case InputEvent::Kind::Key:
        if (e.code >= 0 && e.code <= GLFW_KEY_LAST) {
          const bool after_others = isModifier(e.code) && keys_changed.any();
          if (keys_changed[std::size_t(e.code)] || after_others || buttons_changed.any() || (wrote && !writes(e.code)))
            return;
          // An auto-repeat of a key that is down already changes nothing: ImGui repeats by itself.
          if (io.KeysDown[e.code] != e.down) keys_changed.set(std::size_t(e.code));
          io.KeysDown[e.code] = e.down;
          setModifiers(io);
        }
        break;
      case InputEvent::Kind::Character:
        for (std::size_t key = 0; key < keys_changed.size(); ++key)
          if (keys_changed[key] && !writes(int(key)) && !isModifier(int(key))) return;
        wrote = true;
        io.AddInputCharacter(unsigned(e.code));
        break;
      case InputEvent::Kind::FocusLost:
        if (keys_changed.any() || buttons_changed.any()) return;
        std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
        std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
        setModifiers(io);
        keys_changed.set();
        buttons_changed.set();
        break;
    }
    events_.pop_front();
  }
}

}  // namespace moltact
