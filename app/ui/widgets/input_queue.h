// What the person does, in the order it was done, fed to Dear ImGui no faster than it can see: a key pressed and let go
// within one frame is spread over two. The one way in for the real window, the off-screen run and the tests.
// Window's thread. Units: pixel of the framebuffer, wheel notch (positive: away from the person).
#pragma once

#include <deque>
#include <glm/glm.hpp>

struct ImGuiIO;

namespace moltact {

/// Keys are GLFW's key codes (GLFW_KEY_…), buttons GLFW's and ImGui's common order: 0 left, 1 right, 2 middle.
struct InputEvent {
  enum class Kind { Pointer, Button, Wheel, Key, Character, FocusLost, PointerLeft };
  Kind kind = Kind::Pointer;
  glm::dvec2 place{0.0};  ///< Pointer: where; Wheel: notches
  int code = 0;           ///< Button, Key: which; Character: the code point
  bool down = false;      ///< Button, Key
};

class InputQueue {
 public:
  InputQueue();

  void pointer(double x, double y) { events_.push_back({InputEvent::Kind::Pointer, {x, y}}); }
  void pointerLeft() { events_.push_back({InputEvent::Kind::PointerLeft}); }
  void button(int button, bool down) { events_.push_back({InputEvent::Kind::Button, {}, button, down}); }
  void wheel(double x, double y) { events_.push_back({InputEvent::Kind::Wheel, {x, y}}); }
  void key(int key, bool down) { events_.push_back({InputEvent::Kind::Key, {}, key, down}); }
  void character(unsigned code_point) { events_.push_back({InputEvent::Kind::Character, {}, int(code_point)}); }
  /// The window has lost the keyboard: every key and button is let go.
  void focusLost() { events_.push_back({InputEvent::Kind::FocusLost}); }

  bool empty() const { return events_.empty(); }

  /// Before a frame: hands over as many events as one frame can tell apart; the rest waits for the next.
  void feed(ImGuiIO& io);

 private:
  std::deque<InputEvent> events_;
};

}  // namespace moltact
