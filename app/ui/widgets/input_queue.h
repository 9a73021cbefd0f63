// The person's input in its order, fed to Dear ImGui no faster than it can see: a key pressed and let go within one
// frame is spread over two. The one way in for the real window, the off-screen run and the tests. Window's thread.
// Units: pixel of the framebuffer, wheel notch (positive: away from the person).
#pragma once

#include <bitset>
#include <deque>
#include <glm/glm.hpp>

#include "app/ui/widgets/imgui_versions.h"

namespace moltact {

/// Buttons are in GLFW's and ImGui's common order: 0 left, 1 right, 2 middle.
struct InputEvent {
  enum class Kind { Pointer, Button, Wheel, Key, Character, FocusLost, PointerLeft };
  Kind kind = Kind::Pointer;
  glm::dvec2 place{0.0};  ///< Pointer: where; Wheel: notches
  int code = 0;           ///< Button: which; Character: the code point
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
  /// The window has lost the keyboard: every key and button is let go.
  void focusLost() { events_.push_back({InputEvent::Kind::FocusLost}); }

  bool empty() const { return events_.empty(); }

  /// Before a frame: hands over as many events as one frame can tell apart; the rest waits for the next.
  void feed(ImGuiIO& io);

 private:
  void tell(ImGuiIO& io, ImGuiKey key, bool down);

  std::deque<InputEvent> events_;
  std::bitset<kKeyCount> held_;  // keys, as ImGui was given them
};

}  // namespace moltact
