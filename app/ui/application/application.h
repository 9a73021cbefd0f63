// The program behind the window: what is touched, the lesson that is open, what the person prefers, and the order of a
// frame. It draws nothing itself: the panels do (app/ui/panels). Everything beyond that is an extension (extension.h).
// It knows neither: both are given to it as its parts (app/ui/shell/application_parts.h). Window's thread.
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

/// The parts above the application: what it draws and what extends it.
struct ApplicationParts {
  /// Makes them for this application, whose parts they hold; called once, by its constructor.
  std::unique_ptr<ExtensionSet> (*extensions)(Application&);
  void (*keys)(Application&);    ///< once a frame, before the layout: what the keys of the frame do
  void (*panels)(Application&);  ///< once a frame: draws all panels
};

class Application final : public Opener {
 public:
  Application(ApplicationOptions options, ApplicationParts parts);
  ~Application();

  /// The program's end, whatever it comes by: lets the force go, then has everything saved that is to be. Once; the
  /// destructor does it too.
  void end();

  void open(const std::filesystem::path& file) override;
  /// Opens a molecule's file as it is to be read, as open() does.
  void openMolecule(const MoleculeKey& key);
  /// Files were dropped on the window: the first is opened.
  void drop(const std::vector<std::filesystem::path>& dropped);
  void showMolecule(const MoleculeKey& key) override;
  bool hasWork() const override { return scene.stage() || lesson.session(); }

  /// One frame: takes up what the servo loop found, then draws all panels.
  void frame(double dt_s, glm::vec2 window_px);

  /// Whether the next frame would look different by itself: forces move, something is loading or fading.
  bool live() const;
  /// Waits for a file that is being opened and shows it.
  void finishLoading();
  bool loading() const override { return loader_.busy(); }
  /// How long a file has been read (unit: second); 0 while none is.
  double loadingFor_s() const { return loading_s_; }

  HapticSession scene;
  LessonGuide lesson;
  Messages messages;
  Settings settings;
  PanelState panels;
  FileBrowser files;       ///< of the page that opens files
  FileDialog file_dialog;  ///< asks for a file to be written, or for a folder

  /// Each by its name, for who includes app/ui/extensions/extensions.h; defined there, in the room above this one.
  Extensions& extensions();
  const Extensions& extensions() const;
  ViewPicture& picture() { return *picture_; }
  const Layout& layout() const { return layout_; }
  const ApplicationOptions& options() const { return options_; }

  void resetView() override;
  void comeCloseTo(PointA place) override;
  void beginSceneAgain(std::optional<PointA> before = {}, const std::optional<Quat>& turned = {},
                       const std::vector<std::uint32_t>& removed = {}) override;
  /// The same as resetView because a person asked for it: it can be undone.
  void resetViewByHand();
  /// Goes to a view that a person asked for; it can be undone.
  void showView(const ViewSpec& view);
  /// Turns these atoms to the front and comes close to them, for a person who asked for it; it can be undone.
  void zoomTo(std::span<const std::uint32_t> atoms);
  /// The view panel is to save the next picture it draws; where the file is empty, in the folder of the options.
  void askForPicture(std::filesystem::path file = {}) { picture_asked_ = std::move(file); }
  std::optional<std::filesystem::path> takePictureRequest() { return std::exchange(picture_asked_, std::nullopt); }
  /// Asks where a picture is to go, then for the picture.
  void askForPictureAs();
  /// The person wants to leave.
  void leave() { leaving_ = true; }
  bool leaving() const { return leaving_; }

  const FrameTime& time() const { return time_; }
  double dt_s() const { return time_.dt_s; }
  double now_s() const { return time_.now_s; }

 private:
  Facing facing() const;
  void onLoaded(Loaded loaded);
  void openLesson(const std::filesystem::path& file);
  void cutOpen();     // as the lesson's step asks for
  void enterScene();  // of the lesson's step, where that has changed
  void notifyStepChanged();
  void warnBodyTooLarge();
  void useLanguageAndUnits();  // those of the settings, and their decimal sign
  Layout layoutNow() const;    // with the panels that are open now
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
  std::size_t told_opening_ = 0, told_step_ = 0;
  bool aspect_guessed_ = true;  // the view's shape is known once the first frame has been laid out
  bool step_scene_ = false;     // what is being read belongs to a lesson's step
  bool leaving_ = false, ended_ = false;
  std::optional<std::string> spoken_;  // the setting that the language in use comes from
  std::optional<std::filesystem::path> picture_asked_;
};

}  // namespace moltact
