// A scripted user: drives the application through its input queue and reads what the screen says, off-screen on
// EGL and on the frames' clock, so that every run is the same. For scripts, README pictures and tests.
// Owning thread, which holds the GL context. Units: pixel; a frame is 1/60 s.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "app/ui/application/application.h"
#include "app/ui/shell/frame_stats.h"
#include "app/ui/shell/shell.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/platform/offscreen_gl.h"
#include "engine/render/picture.h"

namespace moltact {

class ScriptedUser {
 public:
  static constexpr double kFrame_s = 1.0 / 60.0;

  /// The servo loop on the frames' clock, no settings kept.
  static ApplicationOptions framesClock();

  /// Which frames are drawn; drawing is most of a frame's time, and the others do all else.
  enum class Draws {
    WhenAsked,  ///< those of which a picture is taken
    LastInRow,  ///< the last of several
    All,
  };

  struct Options {
    int width = 1280, height = 800;
    double content_scale = 1.0;
    ApplicationOptions application = framesClock();
    Draws draws = Draws::WhenAsked;
  };

  /// Fails where off-screen OpenGL is missing.
  static Expected<std::unique_ptr<ScriptedUser>> create(Options options);
  ~ScriptedUser();

  Application& app() { return *app_; }

  /// Draws frames until the input is used up, and `n` more.
  void frames(int n = 1);
  void resize(int width, int height);

  // Each of these draws the frames it needs. Names are those of the widget map; a name that is not on the screen gives
  // false (or an empty text) and is named by missing().
  bool click(std::string_view widget, int button = 0);
  bool drag(std::string_view widget, double dx, double dy, int button = 0);
  /// Moves the pointer to a place in the widget: (0, 0) is its upper left corner, (1, 1) its lower right.
  bool point(std::string_view widget, double x = 0.5, double y = 0.5);
  void press(int button = 0);
  void release(int button = 0);
  void wheel(double notches);
  void type(std::string_view utf8);
  /// "Ctrl+O", "F1", "Space", "Up", "a". False for a name that is not known.
  bool tap(std::string_view keys);
  bool hold(std::string_view keys);
  bool letGo(std::string_view keys);

  std::string text(std::string_view widget) const;
  bool shows(std::string_view widget) const;
  /// The names that click and others did not find, one a line.
  const std::string& missing() const { return missing_; }

  /// What is on the screen; takes a frame more where the last one was not drawn.
  Picture picture();
  FrameStats& stats() { return stats_; }

  /// Runs a script, one act a line: see scripted_user_steps.cpp. Returns the first line that failed, or nothing.
  std::optional<Problem> run(const std::string& script, const std::string& file);

 private:
  ScriptedUser() = default;
  void frame(bool drawn);
  const WidgetRecord* seen(std::string_view widget);

  Options options_;
  std::unique_ptr<OffscreenGl> gl_;
  struct Target;
  std::unique_ptr<Target> target_;
  std::unique_ptr<Shell> shell_;
  std::unique_ptr<Application> app_;
  FrameStats stats_;
  bool drawn_ = false;  // the last frame was
  std::string missing_;
};

}  // namespace moltact
