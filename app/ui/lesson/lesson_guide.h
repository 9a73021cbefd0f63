// The open lesson with what panels and view need of it: its step, scene, tasks and questions. It receives the samples
// of the hand. Window's thread.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/problem.h"
#include "engine/lesson/session.h"
#include "engine/render/view_scene.h"
#include "engine/servo/servo_step.h"
#include "engine/workspace/scale.h"

namespace moltact {

/// A force curve while it is being drawn (unit: newton; NaN where nothing is drawn), and the position of the pen for
/// the arrow keys.
struct CurveDraft {
  std::vector<double> values;
  std::size_t pen = 0;
};

/// The choices and texts of a step's questions and tasks before they are submitted, by the question's index.
struct AnswerDrafts {
  std::map<std::size_t, std::vector<std::size_t>> ticked;
  std::map<std::size_t, std::string> written;
  std::map<std::size_t, CurveDraft> curves;  ///< by the task's index
};

/// The meaning of a scene's colours.
ColourBy colourBy(const SceneSpec& scene);

/// How a scene draws the atoms of its molecule. `later`: as in ColouringInput.
AtomsLook looksOf(const SceneSpec& scene, const Molecule& molecule, bool later = false);

class LessonGuide {
 public:
  /// Opens a lesson file at its first step. Returns false if it cannot be read as a lesson; the open one then remains.
  bool open(const std::filesystem::path& file);
  /// Replaces the open lesson after it was read again. The student stays at the step and keeps the work done. If the
  /// step's scene is unchanged, the view is too.
  void replace(Lesson lesson);

  /// Null if no lesson is open.
  LessonSession* session() { return session_.get(); }
  const LessonSession* session() const { return session_.get(); }
  const std::filesystem::path& file() const { return file_; }
  /// Incremented each time a lesson is opened; 0 before the first.
  std::size_t openings() const { return openings_; }

  bool canGoOn() const { return session_ && (atLastStep() ? !closing_ : session_->hasNext() && session_->mayGoOn()); }
  bool canGoBack() const { return session_ && (closing() || session_->hasBack()); }
  /// Whether the closing page follows this step.
  bool atLastStep() const { return session_ && !session_->hasNext() && !session_->step().aside; }
  /// Whether the closing page is shown instead of the last step's text; the step's scene remains.
  bool closing() const { return closing_ && atLastStep(); }
  void next();
  void back();
  /// Follows a link to a step ("#step-id"). Returns false if there is none. Does nothing if another step must be
  /// finished first.
  bool follow(const std::string& link);

  /// For the present step; empty when it has just been entered.
  AnswerDrafts& drafts();

  /// The step's scene if it has changed since the last call, else null.
  const SceneSpec* takeNewScene();
  /// Makes takeNewScene() return the scene again, after another molecule was opened.
  void askForScene() { scene_changed_ = true; }
  /// Whether the molecule set last is the step's.
  bool onStage() const { return on_stage_; }
  /// The step's molecule, with its file in the library or beside the lesson. A Problem if it is in neither.
  Expected<MoleculeKey> molecule() const;

  /// Sets the molecule on the stage. The tasks begin once it is the one of the step.
  void setMolecule(std::shared_ptr<const Molecule> molecule, const MoleculeKey& key);
  /// Replaces the step's molecule by one with other positions of the atoms, for which the tasks are made.
  void beginFrom(std::shared_ptr<const Molecule> molecule);
  /// Processes a tick; `method` made its contact, and `exact` is the exact tracker's contact for the same hand.
  void feed(const ServoSample& sample, std::string_view method, const Contact& exact, bool hovering);

  /// The visible parts that the step requests; the usual ones without a lesson.
  ViewPartSet shownParts() const;
  /// Whether the lesson locks this key of a scene ("force") against changes.
  bool locks(std::string_view key) const { return session_ && session_->scene().locks(key); }
  /// How the step draws the atoms; as spheres without a step.
  const AtomsLook& looks() const { return looks_; }
  /// Hides other atoms of it until the next setMolecule().
  void hide(AtomList atoms) { looks_.hidden = std::move(atoms); }
  /// Applies the step's cutting plane, once the camera has its view.
  void cutFor(const Camera& camera, const Molecule& molecule);
  /// The atoms that the step excludes from touch, ascending.
  const std::vector<std::uint32_t>& untouchable() const { return untouchable_; }
  /// The held atoms, ascending.
  const std::vector<std::uint32_t>& held() const { return held_; }
  /// The part of the molecule that the step magnifies.
  const std::optional<Region>& region() const { return region_; }
  /// The region to which the step's view zooms; nothing if it shows the whole.
  const std::optional<Region>& zoomed() const { return zoomed_; }
  /// Rotates a fitted camera to the step's view.
  void face(Camera& camera, const Molecule& molecule) const;
  /// Adds the step's highlights, names and measurements.
  void decorate(ViewScene& scene) const;

 private:
  std::unique_ptr<LessonSession> session_;
  std::filesystem::path file_;
  AnswerDrafts drafts_;
  std::size_t openings_ = 0, drafts_opening_ = 0, drafts_step_ = 0;
  std::size_t scene_seen_ = 0;
  bool scene_changed_ = false, on_stage_ = false, closing_ = false;
  std::vector<std::uint32_t> highlighted_, untouchable_, held_;
  std::optional<Region> region_, zoomed_;
  AtomsLook looks_;
  mutable std::shared_ptr<const Annotations> annotations_;  // of the molecule drawn last
  mutable std::shared_ptr<const Molecule> annotated_;
};

/// Rotates a camera that was fitted to the molecule to a view of the scene.
void faceView(Camera& camera, const Molecule& molecule, const ViewSpec& view, const SceneSpec& scene);
/// The camera's rotation in the words of a scene: "turned 30 10 0", to a tenth of a degree.
std::string viewText(const Camera& camera);
/// The cutting plane of a scene for this camera; nothing if it has none.
std::optional<CutPlane> cutOf(const SceneSpec& scene, const Molecule& molecule, const Camera& camera);
/// A scene's molecule, with its file beside the lesson or in the library. A Problem if it is in neither.
Expected<MoleculeKey> moleculeOf(const SceneSpec& scene, const std::filesystem::path& lesson);

}  // namespace moltact
