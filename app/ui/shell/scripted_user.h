// Drives the application by a script: feeds its input queue and reads the texts on the screen. Runs off-screen on EGL
// and on the frames' clock, so that every run is the same. For scripts, README pictures and tests. Owning thread, which
// holds the GL context. Units: pixel; a frame is 1/60 s.
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

  /// Options with the servo loop on the frames' clock and without stored settings.
  static ApplicationOptions framesClock();

  /// Which frames are drawn. Drawing takes most of a frame's time; frames without it do everything else.
  enum class Draws {
    WhenAsked,  ///< frames of which a picture is taken
    LastInRow,  ///< the last of several frames
    All,
  };

  struct Options {
    int width = 1280, height = 800;
    double content_scale = 1.0;
    ApplicationOptions application = framesClock();
    Draws draws = Draws::WhenAsked;
  };

  /// Returns a Problem if off-screen OpenGL is not available.
  static Expected<std::unique_ptr<ScriptedUser>> create(Options options);
  ~ScriptedUser();

  Application& app() { return *app_; }

  /// Runs frames until the input queue is empty, and then `n` more.
  void frames(int n = 1);
  void resize(int width, int height);

  // Each of these runs the frames that it needs. Names are those of the widget map. A name that is not on the screen
  // gives false (or an empty text), and missing() lists it.
  bool click(std::string_view widget, int button = 0);
  bool drag(std::string_view widget, double dx, double dy, int button = 0);
  /// Moves the pointer to a place in the widget: (0, 0) is its upper left corner, (1, 1) the lower right.
  bool point(std::string_view widget, double x = 0.5, double y = 0.5);
  void press(int button = 0);
  void release(int button = 0);
  void wheel(double notches);
  void type(std::string_view utf8);
  /// "Ctrl+O", "F1", "Space", "Up", "a". Returns false for an unknown name.
  bool tap(std::string_view keys);
  bool hold(std::string_view keys);
  bool letGo(std::string_view keys);

  std::string text(std::string_view widget) const;
  bool shows(std::string_view widget) const;
  /// The names that were not found, one per line.
  const std::string& missing() const { return missing_; }

  /// The picture on the screen; runs one more frame if the last one was not drawn.
  Picture picture();
  FrameStats& stats() { return stats_; }

  /// Runs a script, one command per line: see scripted_user_steps.cpp. Returns the first line that failed, or nothing.
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
  bool drawn_ = false;  // whether the last frame was drawn
  std::string missing_;
};

}  // namespace moltact
