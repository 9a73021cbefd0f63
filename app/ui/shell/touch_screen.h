// The fingers on the window's touch screen, which GLFW 3.3 does not hear: a first finger comes as a mouse, the others not at
// all. On Linux under X11 they come by XInput 2.2, on a connection of our own (touch_screen_x11.cpp); the server then makes no
// mouse's buttons of them. Elsewhere none come (touch_screen_none.cpp), and under Wayland none either. Window's thread.
#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

struct GLFWwindow;

namespace moltact {

struct FingerEvent {
  enum class Kind { Down, Move, Up };
  Kind kind;
  int id;               ///< the same from Down to Up, another for the next finger
  glm::dvec2 place_px;  ///< of the framebuffer
};

class TouchScreen {
 public:
  /// GLFW's window outlives it.
  explicit TouchScreen(GLFWwindow* window);
  ~TouchScreen();
  TouchScreen(const TouchScreen&) = delete;
  TouchScreen& operator=(const TouchScreen&) = delete;

  /// What fingers have done since the last call, in order.
  std::vector<FingerEvent> take();
  /// As glfwWaitEventsTimeout, which no finger wakes; here one does.
  void waitForEvents(double at_most_s);

 private:
  struct Connection;
  std::unique_ptr<Connection> connection_;  // none where no fingers can be heard
};

}  // namespace moltact
