// Queues the user's input in its order and passes it to Dear ImGui at a rate that ImGui can process. A key that is
// pressed and released within one frame is spread over two frames. The window, the off-screen run and the tests all use
// this queue. Window's thread. Units: pixel of the framebuffer, wheel notch (positive: away from the user).
#pragma once

#include <bitset>
#include <deque>
#include <glm/glm.hpp>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// Buttons have the order that GLFW and ImGui share: 0 left, 1 right, 2 middle.
struct InputEvent {
  enum class Kind { Pointer, Button, Wheel, Key, Character, FocusLost, PointerLeft };
  Kind kind = Kind::Pointer;
  glm::dvec2 place{0.0};  ///< Pointer: position; Wheel: notches
  int code = 0;           ///< Button: its number; Character: the code point
  bool down = false;      ///< Button, Key
  ImGuiKey key = ImGuiKey_None;
};

class InputQueue {
 public:
  InputQueue();

  void pointer(double x, double y) { events_.push_back({InputEvent::Kind::Pointer, {x, y}}); }
  void pointerLeft() { events_.push_back({InputEvent::Kind::PointerLeft}); }
  void button(int button, bool down) { events_.push_back({InputEvent::Kind::Button, {}, button, down}); }
  void wheel(double x, double y) { events_.push_back({InputEvent::Kind::Wheel, {x, y}}); }
  void key(ImGuiKey key, bool down) { events_.push_back({InputEvent::Kind::Key, {}, 0, down, key}); }
  void character(unsigned code_point) { events_.push_back({InputEvent::Kind::Character, {}, int(code_point)}); }
  /// The window has lost the keyboard: every key and button is released.
  void focusLost() { events_.push_back({InputEvent::Kind::FocusLost}); }

  bool empty() const { return events_.empty(); }

  /// Called before a frame. Passes on as many events as one frame can distinguish; the rest waits for the next frame.
  void feed(ImGuiIO& io);

 private:
  void tell(ImGuiIO& io, ImGuiKey key, bool down);

  std::deque<InputEvent> events_;
  std::bitset<kKeyCount> held_;  // the keys that ImGui regards as held
};

}  // namespace moltact
