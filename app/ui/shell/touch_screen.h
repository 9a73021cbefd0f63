// The fingers on the window's touch screen. GLFW 3.3 reports only a first finger, as a mouse. On Linux under X11,
// fingers are read by XInput 2.2 on a separate connection (touch_screen_x11.cpp); the server then sends no mouse
// buttons for them. Elsewhere, and under Wayland, no fingers are reported (touch_screen_none.cpp). Window's thread.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

struct GLFWwindow;

namespace moltact {

struct FingerEvent {
  enum class Kind { Down, Move, Up };
  Kind kind;
  int id;               ///< constant from Down to Up; different for the next finger
  glm::dvec2 place_px;  ///< in the framebuffer
};

class TouchScreen {
 public:
  /// GLFW's window must outlive this object.
  explicit TouchScreen(GLFWwindow* window);
  ~TouchScreen();
  TouchScreen(const TouchScreen&) = delete;
  TouchScreen& operator=(const TouchScreen&) = delete;

  /// Returns the events since the last call, in order.
  std::vector<FingerEvent> take();
  /// Like glfwWaitEventsTimeout, but also returns at a finger's event.
  void waitForEvents(double at_most_s);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;  // null if no fingers are reported
};

}  // namespace moltact
