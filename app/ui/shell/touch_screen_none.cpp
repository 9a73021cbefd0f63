// For window systems whose fingers are not reported.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/ui/shell/touch_screen.h"

namespace moltact {

struct TouchScreen::Connection {};

TouchScreen::TouchScreen(GLFWwindow*) {}
TouchScreen::~TouchScreen() = default;

std::vector<FingerEvent> TouchScreen::take() { return {}; }

void TouchScreen::waitForEvents(double at_most_s) { glfwWaitEventsTimeout(at_most_s); }

}  // namespace moltact
