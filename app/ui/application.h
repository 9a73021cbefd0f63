// The program behind the window: the molecule and lesson that are open, the servo loop, the camera, what the person
// prefers. It draws nothing itself: the panels do (app/ui/panels). Window's thread.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/ui/layout.h"
#include "app/ui/lesson_guide.h"
#include "app/ui/loader.h"
#include "app/ui/messages.h"
#include "app/ui/method_watch.h"
#include "app/ui/servo_link.h"
#include "app/ui/settings.h"
#include "app/ui/stage.h"
#include "app/ui/touch_log.h"
#include "app/ui/view_controls.h"
#include "engine/render/view_scene.h"

namespace moltact {

class ViewPicture;

struct ApplicationOptions {
  ServoClock clock = ServoClock::RealThread;
  std::filesystem::path settings_file;  ///< empty: settings are neither read nor kept
  std::filesystem::path picture_folder; ///< where "Save picture" puts pictures (default: the current folder)
};

/// Which panels and pages are open.
struct PanelState {
  bool lesson = true, touch = true;
  bool lesson_first = true;     ///< where only one side panel has room
  bool touch_details = false;   ///< the touch panel's second half
  bool methods = false;         ///< in the touch panel's place, behind a tab
  bool methods_first = false;   ///< which of the two is in front
  bool methods_by_step = false; ///< the lesson's step opened it, so that another step closes it
  bool hints = false;           ///< the current step's hints
  bool open_page = false, controls_page = false, about_page = false;
};

class Application {
 public:
  explicit Application(ApplicationOptions options = {});
  ~Application();

  /// Opens a molecule (a file, or a name of the library) or a lesson, by its name's ending. What cannot be opened is told in a message and changes nothing.
  void open(const std::filesystem::path& file);
  /// What the program opens when nothing is named: its first lesson, else the first molecule of its library.
  void openFirst();

  /// One frame: takes up what the servo loop found, then draws all panels. `content_scale` is the monitor's.
  void frame(double dt_s, glm::vec2 window_px, double content_scale);

  /// Whether the next frame would look different by itself: forces move, something is loading or fading.
  bool live() const;
  /// Waits for a file that is being opened and shows it.
  void finishLoading();

  bool quit = false;              ///< the person wants to leave
  bool take_picture = false;      ///< the view panel is to save the next picture it draws

  Stage stage;
  std::filesystem::path stage_file;
  ServoLink servo;
  ServoSettings touch_settings;   ///< as the panels set them; handed to the servo loop each frame
  std::string method;             ///< name of the method in use
  TouchLog touch;
  MethodWatch watch;
  LessonGuide lesson;
  Camera camera;
  ShapeSet shown = LessonGuide().shapes();
  ViewControls controls;
  Messages messages;
  Settings settings;
  PanelState panels;
  Layout layout;
  std::unique_ptr<ViewPicture> picture;
  const ApplicationOptions options;

  double scale() const { return content_scale_ * settings.scale; }
  bool loading() const { return loader_.busy(); }
  double hintStrength() const;  ///< of the hint of controls: 1 until the person has found out how, then fading to 0
  double dt_s() const { return dt_s_; }
  double now_s() const { return now_s_; }

  /// Another haptic method, keeping a contact that there is. Unknown names change nothing.
  void useMethod(std::string_view name);
  /// Opens the panel that compares methods, or closes it.
  void showMethods(bool on);
  bool methodsInFront() const { return panels.methods && panels.methods_first; }
  /// The camera as it was when the scene was opened.
  void resetView();

 private:
  void show(Stage stage, const std::filesystem::path& file);
  void takeUp(Loaded loaded);
  void enterScene();             // of the lesson's step, where that has changed
  void watchLeftBehind();
  void shortcuts();
  void saveSettingsSoon();

  Loader loader_;
  Settings saved_settings_, changing_settings_;
  double since_change_s_ = 0;
  double content_scale_ = 1.0, dt_s_ = 0, now_s_ = 0;
  double view_aspect_ = 1.0, hint_left_s_ = 2.0;
  bool aspect_guessed_ = true;   // the view's shape is known once the first frame has been laid out
  bool hand_moved_ = false;
  bool step_scene_ = false;      // what is being read belongs to a lesson's step
};

}  // namespace moltact
