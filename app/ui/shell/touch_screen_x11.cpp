#include <poll.h>

#include <array>
#include <cmath>
#include <optional>

#include "app/ui/shell/touch_screen.h"

// Xlib's macros are common words (None, Bool, Status). Its headers are therefore included last, and this file is
// excluded from unity builds.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <X11/Xlib.h>
#include <X11/extensions/XInput2.h>

// Declared as in GLFW's native header, which would also include Xrandr's headers. A GLFW 3.3 built only for Wayland has
// neither function.
extern "C" {
__attribute__((weak)) Display* glfwGetX11Display();
__attribute__((weak)) Window glfwGetX11Window(GLFWwindow*);
}

namespace moltact {
namespace {

bool refused = false;

// Without this error handler, Xlib ends the program at the first request that the server rejects.
class CatchRefusals {
 public:
  CatchRefusals() {
    refused = false;
    before_ = XSetErrorHandler([](Display*, XErrorEvent*) {
      refused = true;
      return 0;
    });
  }
  ~CatchRefusals() { XSetErrorHandler(before_); }
  CatchRefusals(const CatchRefusals&) = delete;
  CatchRefusals& operator=(const CatchRefusals&) = delete;

 private:
  XErrorHandler before_;
};

std::optional<FingerEvent::Kind> kindOf(int xi_event) {
  switch (xi_event) {
    case XI_TouchBegin:
      return FingerEvent::Kind::Down;
    case XI_TouchUpdate:
      return FingerEvent::Kind::Move;
    case XI_TouchEnd:
      return FingerEvent::Kind::Up;
    default:
      return std::nullopt;
  }
}

}  // namespace

struct TouchScreen::Connection {
  Display* window_system = nullptr;  // GLFW's connection
  Display* display = nullptr;
  int extension = 0;

  Connection() = default;
  ~Connection() {
    if (display) XCloseDisplay(display);
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  bool open(GLFWwindow* window) {
    if (!glfwGetX11Display || !glfwGetX11Window) return false;
    window_system = glfwGetX11Display();
    if (!window_system) return false;
    display = XOpenDisplay(DisplayString(window_system));
    int unused = 0, major = 2, minor = 2;
    if (!display || !XQueryExtension(display, "XInputExtension", &extension, &unused, &unused) ||
        XIQueryVersion(display, &major, &minor) != Success || major < 2 || (major == 2 && minor < 2))
      return false;
    std::array<unsigned char, XIMaskLen(XI_LASTEVENT)> wanted{};
    for (const int event : {XI_TouchBegin, XI_TouchUpdate, XI_TouchEnd}) XISetMask(wanted.data(), event);
    XIEventMask mask{XIAllMasterDevices, int(wanted.size()),
                     wanted.data()};  // includes devices that are plugged in later
    const CatchRefusals refusals;
    XISelectEvents(display, glfwGetX11Window(window), &mask, 1);
    XSync(display, False);
    return !refused;
  }

  // False for a touchpad, whose fingers have no place in the window.
  bool isScreen(int device) {
    int count = 0;
    XIDeviceInfo* all = XIQueryDevice(display, XIAllDevices, &count);
    bool direct = false;
    for (int k = 0; k < count; ++k)
      for (int c = 0; all[k].deviceid == device && c < all[k].num_classes; ++c)
        if (all[k].classes[c]->type == XITouchClass)
          direct = reinterpret_cast<const XITouchClassInfo*>(all[k].classes[c])->mode == XIDirectTouch;
    if (all) XIFreeDeviceInfo(all);
    return direct;
  }
};

TouchScreen::TouchScreen(GLFWwindow* window) : connection_(std::make_unique<Connection>()) {
  if (!connection_->open(window)) connection_.reset();
}

TouchScreen::~TouchScreen() = default;

std::vector<FingerEvent> TouchScreen::take() {
  std::vector<FingerEvent> out;
  if (!connection_) return out;
  Display* display = connection_->display;
  while (XPending(display) > 0) {
    XEvent event;
    XNextEvent(display, &event);
    if (event.type != GenericEvent || event.xcookie.extension != connection_->extension ||
        !XGetEventData(display, &event.xcookie))
      continue;
    if (const auto kind = kindOf(event.xcookie.evtype)) {
      const auto& touch = *static_cast<const XIDeviceEvent*>(event.xcookie.data);
      // Here a window's unit is a pixel of its framebuffer.
      if (*kind != FingerEvent::Kind::Down || connection_->isScreen(touch.sourceid))
        out.push_back({*kind, touch.detail, {touch.event_x, touch.event_y}});
    }
    XFreeEventData(display, &event.xcookie);
  }
  return out;
}

void TouchScreen::waitForEvents(double at_most_s) {
  if (!connection_) return glfwWaitEventsTimeout(at_most_s);
  Display* window_system = connection_->window_system;
  Display* fingers = connection_->display;
  if (XPending(window_system) == 0 && XPending(fingers) == 0) {
    std::array<pollfd, 2> either{pollfd{ConnectionNumber(window_system), POLLIN, 0},
                                 pollfd{ConnectionNumber(fingers), POLLIN, 0}};
    poll(either.data(), either.size(), int(std::ceil(1000.0 * at_most_s)));
  }
  glfwPollEvents();
}

}  // namespace moltact
