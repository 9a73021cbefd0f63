#include "app/ui/shell/window.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/files/user_folders.h"
#include "app/ui/shell/application_parts.h"
#include "app/ui/shell/frame_stats.h"
#include "app/ui/shell/glfw_keys.h"
#include "app/ui/shell/keyboard_layout.h"
#include "app/ui/shell/pointers.h"
#include "app/ui/shell/shell.h"
#include "app/ui/shell/touch_screen.h"
#include "engine/language/catalogue.h"
#include "engine/pack/unpack.h"
#include "engine/platform/folders.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"
#include "engine/render/picture.h"
#include "engine/results/attempt_file.h"

namespace moltact {
namespace {

constexpr double kIdle_s = 0.2;     // interval between two frames while nothing moves; plots and figures still advance
constexpr double kFinger_s = 0.05;  // the same while a finger is down, to detect a long rest
constexpr int kSettle_frames = 3;   // frames drawn after the last event, until hovers and popups are settled

// The objects that the callbacks reach through the window's user pointer.
struct Link {
  Shell& shell;
  Application& app;
  Pointers pointers{app, shell.input()};
  int settle = kSettle_frames;
};

Link& linkOf(GLFWwindow* w) {
  Link& link = *static_cast<Link*>(glfwGetWindowUserPointer(w));
  link.settle = kSettle_frames;
  return link;
}

// Pixels of the framebuffer per unit of the window; not 1 on some systems.
glm::dvec2 pixelsPerUnit(GLFWwindow* w) {
  int units_x = 1, units_y = 1, px_x = 1, px_y = 1;
  glfwGetWindowSize(w, &units_x, &units_y);
  glfwGetFramebufferSize(w, &px_x, &px_y);
  return {double(px_x) / std::max(1, units_x), double(px_y) / std::max(1, units_y)};
}

// Queries the display server each time, because the user may change the layout while the program runs.
std::string_view layoutInUse(ImGuiKey place) {
  const char* name = glfwGetKeyName(glfwKeyOf(place), 0);
  return name ? name : "";
}

// An X server moves the mouse with the first finger, also into and out of the window. Mouse events are ignored while a
// finger is down.
void connect(GLFWwindow* window) {
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
    const glm::dvec2 px = pixelsPerUnit(w);
    if (!linkOf(w).pointers.anyFinger()) linkOf(w).pointers.mouse({x * px.x, y * px.y});
  });
  glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int entered) {
    if (!entered && !linkOf(w).pointers.anyFinger()) linkOf(w).shell.input().pointerLeft();
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
    linkOf(w).shell.input().button(button, action == GLFW_PRESS);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { linkOf(w).shell.input().wheel(x, y); });
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
    const ImGuiKey named = keyOnLayout(keyOfGlfw(key), layoutInUse);
    if (isKey(named) && action != GLFW_REPEAT) linkOf(w).shell.input().key(named, action == GLFW_PRESS);
  });
  glfwSetCharCallback(window, [](GLFWwindow* w, unsigned c) { linkOf(w).shell.input().character(c); });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) {
    if (!focused) linkOf(w).shell.input().focusLost();
  });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { linkOf(w); });
  glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
    linkOf(w).app.drop({paths, paths + std::max(0, count)});
  });
}

void hear(Link& link, const FingerEvent& finger, double now_s) {
  link.settle = kSettle_frames;
  switch (finger.kind) {
    case FingerEvent::Kind::Down:
      return link.pointers.fingerDown(finger.id, finger.place_px, now_s);
    case FingerEvent::Kind::Move:
      return link.pointers.fingerMove(finger.id, finger.place_px);
    case FingerEvent::Kind::Up:
      return link.pointers.fingerUp(finger.id);
  }
}

class Cursors {
 public:
  Cursors() {
    shapes_[ImGuiMouseCursor_Arrow] = glfwCreateStandardCursor(GLFW_ARROW_CURSOR);
    shapes_[ImGuiMouseCursor_TextInput] = glfwCreateStandardCursor(GLFW_IBEAM_CURSOR);
    shapes_[ImGuiMouseCursor_ResizeEW] = glfwCreateStandardCursor(GLFW_HRESIZE_CURSOR);
    shapes_[ImGuiMouseCursor_ResizeNS] = glfwCreateStandardCursor(GLFW_VRESIZE_CURSOR);
    shapes_[ImGuiMouseCursor_Hand] = glfwCreateStandardCursor(GLFW_HAND_CURSOR);
  }
  // Hides the pointer instead of capturing it: under some servers a captured pointer jumps.
  void show(GLFWwindow* window) {
    const int wanted = ImGui::GetMouseCursor();
    if (wanted == shown_) return;
    shown_ = wanted;
    glfwSetInputMode(window, GLFW_CURSOR, wanted == ImGuiMouseCursor_None ? GLFW_CURSOR_HIDDEN : GLFW_CURSOR_NORMAL);
    if (wanted != ImGuiMouseCursor_None)
      glfwSetCursor(window, shapes_[wanted] ? shapes_[wanted] : shapes_[ImGuiMouseCursor_Arrow]);
  }

 private:
  GLFWcursor* shapes_[ImGuiMouseCursor_COUNT] = {};
  int shown_ = ImGuiMouseCursor_Arrow;
};

// Fills the monitor that shows the window, and restores the window's place afterwards.
class FullScreen {
 public:
  void show(GLFWwindow* window, bool wanted) {
    if (wanted == on_) return;
    on_ = wanted;
    if (!wanted) {
      glfwSetWindowMonitor(window, nullptr, x_, y_, width_, height_, GLFW_DONT_CARE);
      return;
    }
    glfwGetWindowPos(window, &x_, &y_);
    glfwGetWindowSize(window, &width_, &height_);
    GLFWmonitor* monitor = monitorAt(x_ + width_ / 2, y_ + height_ / 2);
    const GLFWvidmode* mode = monitor ? glfwGetVideoMode(monitor) : nullptr;
    if (mode) glfwSetWindowMonitor(window, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }

 private:
  static GLFWmonitor* monitorAt(int x, int y) {
    int count = 0;
    GLFWmonitor** all = glfwGetMonitors(&count);
    for (int k = 0; k < count; ++k) {
      int left = 0, top = 0;
      glfwGetMonitorPos(all[k], &left, &top);
      const GLFWvidmode* mode = glfwGetVideoMode(all[k]);
      if (mode && x >= left && y >= top && x < left + mode->width && y < top + mode->height) return all[k];
    }
    return glfwGetPrimaryMonitor();
  }
  bool on_ = false;
  int x_ = 0, y_ = 0, width_ = 1280, height_ = 800;
};

GLFWwindow* openWindow() {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "Moltact");
  glfwWindowHintString(GLFW_X11_INSTANCE_NAME, "moltact");
#ifdef GLFW_WAYLAND_APP_ID  // since GLFW 3.4
  glfwWindowHintString(GLFW_WAYLAND_APP_ID, "org.moltact.Moltact");
#endif
  GLFWwindow* window = glfwCreateWindow(1280, 800, "Moltact", nullptr, nullptr);
  if (window) glfwSetWindowSizeLimits(window, 480, 360, GLFW_DONT_CARE, GLFW_DONT_CARE);
  return window;
}

// Without the file, or if the server takes no icons, the server's default icon stays.
void setIcon(GLFWwindow* window) {
  const Expected<Picture> icon = readPng(assetsFolder() / "icon.png");
  if (!icon) return;
  std::vector<unsigned char> rgba;
  rgba.reserve(icon->rgb.size() / 3 * 4);
  for (std::size_t k = 0; k + 2 < icon->rgb.size(); k += 3)
    rgba.insert(rgba.end(), {icon->rgb[k], icon->rgb[k + 1], icon->rgb[k + 2], 255});
  const GLFWimage image{icon->width_px, icon->height_px, rgba.data()};
  glfwSetWindowIcon(window, 1, &image);
}

int noDisplay(const char* why) {
  err()
      << "moltact: " << trf("no window can be opened ({0})", why) << '\n'
      << tr("Without a display the commands work that moltact --help lists, such as info, render, check, play, report "
            "and bench.")
      << '\n';
  return 1;
}

const char* lastGlfwError() {
  const char* why = nullptr;
  glfwGetError(&why);
  return why ? why : tr("the display server gives no reason");
}

// Stores the running application for exit(): when the display server dies, its library calls exit() in the middle of a
// frame.
class AtExit {
 public:
  explicit AtExit(Application& app) {
    running = &app;
    static const bool once = std::atexit([] {
                               if (running) std::exchange(running, nullptr)->end();
                             }) == 0;
    (void)once;
  }
  ~AtExit() { running = nullptr; }
  AtExit(const AtExit&) = delete;
  AtExit& operator=(const AtExit&) = delete;

 private:
  static inline Application* running = nullptr;
};

}  // namespace

int runWindow(const WindowOptions& options) {
  if (!glfwInit()) return noDisplay(lastGlfwError());
  GLFWwindow* window = openWindow();
  if (!window) {
    const int status = noDisplay(lastGlfwError());
    glfwTerminate();
    return status;
  }
  setIcon(window);
  glfwMakeContextCurrent(window);
  glfwSwapInterval(1);
  FrameStats stats;
  {
    const InterruptWatch interrupt;  // must outlive the device
    Shell shell;
    Application app({.language = options.language,
                     .device = options.device,
                     .simulation = options.simulation,
                     .settings_file = settingsFile(),
                     .attempts_folder = attemptsFolder(),
                     .packs_folder = packsFolder(),
                     .cache_folder = cacheFolder(),
                     .picture_folder = pictureFolder()},
                    applicationParts());
    const AtExit at_exit(app);
    Link link{shell, app};
    Cursors cursors;
    TouchScreen touch_screen(window);
    glfwSetWindowUserPointer(window, &link);
    connect(window);
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = window;
    io.SetClipboardTextFn = [](void* w, const char* text) {
      glfwSetClipboardString(static_cast<GLFWwindow*>(w), text);
    };
    io.GetClipboardTextFn = [](void* w) { return glfwGetClipboardString(static_cast<GLFWwindow*>(w)); };

    if (!options.state_text.empty())
      if (const auto problem = app.extensions().state_text.writeTo(options.state_text))
        app.messages.error(problem->text());
    if (options.file.empty())
      app.panels.pages.welcome = true;
    else
      app.open(options.file);
    using Clock = std::chrono::steady_clock;
    Clock::time_point before = Clock::now();
    FullScreen full_screen;
    while (!app.leaving() && !glfwWindowShouldClose(window) && !interrupt.seen()) {
      const bool busy = app.live() || link.settle > 0 || !shell.input().empty();
      if (busy)
        glfwPollEvents();
      else
        touch_screen.waitForEvents(link.pointers.anyFinger() ? kFinger_s : kIdle_s);
      const Clock::time_point now = Clock::now();
      const double now_s = std::chrono::duration<double>(now.time_since_epoch()).count();
      for (const FingerEvent& finger : touch_screen.take()) hear(link, finger, now_s);
      link.pointers.advance(now_s);
      if (link.settle > 0) --link.settle;

      const double dt_s = std::chrono::duration<double>(now - before).count();
      before = now;
      full_screen.show(window, app.panels.window.full_screen);
      int width = 1, height = 1;
      glfwGetFramebufferSize(window, &width, &height);
      float content_x = 1, content_y = 1;
      glfwGetWindowContentScale(window, &content_x, &content_y);
      if (width > 0 && height > 0) {  // a minimized window has no size
        shell.setLook(app.settings.theme, float(double(content_x) * app.settings.scale), float(app.settings.text_size));
        shell.frame(width, height, dt_s, [&] { app.frame(dt_s, {width, height}); });
        cursors.show(window);
        glfwSwapBuffers(window);
      }
      if (busy) stats.add(std::chrono::duration<double, std::milli>(Clock::now() - now).count());
    }
    app.end();  // before anything slow
    glfwSetWindowUserPointer(window, nullptr);
    glfwHideWindow(window);
  }
  if (options.frame_stats) out() << stats.json() << '\n';
  glfwDestroyWindow(window);
  glfwTerminate();
  return 0;
}

}  // namespace moltact
