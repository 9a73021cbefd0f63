// The program behind the window: the scene, the open lesson, the settings, and the order of a frame. It draws nothing
// itself; the panels do (app/ui/panels). Everything else is an extension (extension.h). It depends on neither: it
// receives both as its parts (app/ui/shell/application_parts.h). Window's thread.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/ui/application/application_options.h"
#include "app/ui/application/extension.h"
#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/files/file_browser.h"
#include "app/ui/files/file_dialog.h"
#include "app/ui/files/settings.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/scene/haptic_session.h"
#include "app/ui/scene/loader.h"
#include "app/ui/widgets/layout.h"
#include "app/ui/widgets/messages.h"

namespace moltact {

class Application;
struct Extensions;
class ViewPicture;

/// The parts above the application: panels and extensions.
struct ApplicationParts {
  /// Constructs the extensions for this application; called once, by its constructor.
  std::unique_ptr<ExtensionSet> (*extensions)(Application&);
  void (*keys)(Application&);    ///< called once per frame, before the layout: processes the keys
  void (*panels)(Application&);  ///< called once per frame: draws all panels
};

class Application final : public Opener {
 public:
  Application(ApplicationOptions options, ApplicationParts parts);
  ~Application();

  /// Ends the program: ends the force, then saves everything. Acts once; the destructor also calls it.
  void end();

  void open(const std::filesystem::path& file) override;
  /// Opens a molecule's file with these reading options, otherwise like open().
  void openMolecule(const MoleculeKey& key);
  /// Opens the first of the files dropped on the window.
  void drop(const std::vector<std::filesystem::path>& dropped);
  void showMolecule(const MoleculeKey& key) override;
  bool hasWork() const override { return scene.stage() || lesson.session(); }

  /// Processes one frame: takes the samples of the servo loop, then draws all panels.
  void frame(double dt_s, glm::vec2 window_px);

  /// Whether the next frame differs without further input: atoms or hand move, something is loading or fading.
  bool live() const;
  /// Waits for a file that is being opened and shows it.
  void finishLoading();
  bool loading() const override { return loader_.busy(); }
  /// How long the present file has been loading (unit: second); 0 if none is.
  double loadingFor_s() const { return loading_s_; }

  HapticSession scene;
  LessonGuide lesson;
  Messages messages;
  Settings settings;
  PanelState panels;
  FileBrowser files;       ///< of the page that opens files
  FileDialog file_dialog;  ///< asks where to write a file, or for a folder

  /// The extensions by name. Include app/ui/extensions/extensions.h, a room above this one, which defines it.
  Extensions& extensions();
  const Extensions& extensions() const;
  ViewPicture& picture() { return *picture_; }
  const Layout& layout() const { return layout_; }
  const ApplicationOptions& options() const { return options_; }

  void resetView() override;
  void comeCloseTo(PointA place) override;
  void beginSceneAgain(std::optional<PointA> before = {}, const std::optional<Quat>& turned = {},
                       const std::vector<std::uint32_t>& removed = {},
                       const std::vector<std::uint32_t>& in_hand = {}) override;
  /// Like resetView(), by the user: it can be undone.
  void resetViewByHand();
  /// Shows a view that the user chose; it can be undone.
  void showView(const ViewSpec& view);
  /// Rotates these atoms to the front and zooms to them, by the user; it can be undone.
  void zoomTo(std::span<const std::uint32_t> atoms);
  /// Requests that the view panel saves its next picture; with an empty `file`, in the folder of the options.
  void askForPicture(std::filesystem::path file = {}) { picture_asked_ = std::move(file); }
  std::optional<std::filesystem::path> takePictureRequest() { return std::exchange(picture_asked_, std::nullopt); }
  /// Asks where to save a picture, then requests it.
  void askForPictureAs();
  /// Requests the end of the program.
  void leave() { leaving_ = true; }
  bool leaving() const { return leaving_; }

  const FrameTime& time() const { return time_; }
  double dt_s() const { return time_.dt_s; }
  double now_s() const { return time_.now_s; }

 private:
  Facing facing() const;
  void onLoaded(Loaded loaded);
  void openLesson(const std::filesystem::path& file);
  void cutOpen();     // applies the cutting plane of the lesson's step
  void enterScene();  // enters the scene of the lesson's step if it has changed
  void notifyStepChanged();
  void warnWithoutBody();
  void useLanguageAndUnits();  // applies language, units and decimal sign of the settings
  Layout layoutNow() const;    // for the panels that are open now
  void measureView();
  void layPanelsOut(glm::vec2 window_px);

  const ApplicationOptions options_;
  std::unique_ptr<ViewPicture> picture_;
  Layout layout_;
  FrameTime time_;
  std::unique_ptr<ExtensionSet> extensions_;
  void (*keys_)(Application&);
  void (*panels_)(Application&);
  Loader loader_;
  glm::vec2 window_px_{0.0f};
  double loading_s_ = 0;
  std::size_t shown_opening_ = 0, shown_step_ = 0;
  bool aspect_guessed_ = true;  // the view's aspect ratio is not known before the first layout
  bool step_scene_ = false;     // the file that is being read belongs to a lesson's step
  bool leaving_ = false, ended_ = false;
  std::optional<std::string> spoken_;  // the setting from which the language in use was taken
  std::optional<std::filesystem::path> picture_asked_;
};

}  // namespace moltact
