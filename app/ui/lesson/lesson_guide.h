// The lesson that is open, as the panels and the view need it: its step, scene, tasks and questions, fed with what the
// hand felt. Window's thread.
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

/// A force curve that is being drawn (unit: newton), NaN where nothing is; and where the pen stands that the arrows
/// lead.
struct CurveDraft {
  std::vector<double> values;
  std::size_t pen = 0;
};

/// The student's ticks and texts at the questions and tasks of a step before they are handed in, by the question's
/// index.
struct AnswerDrafts {
  std::map<std::size_t, std::vector<std::size_t>> ticked;
  std::map<std::size_t, std::string> written;
  std::map<std::size_t, CurveDraft> curves;  ///< by the task's index
};

/// The meaning of a scene's colours.
ColourBy colourBy(const SceneSpec& scene);

/// How a scene draws the atoms of its molecule.
AtomsLook looksOf(const SceneSpec& scene, const Molecule& molecule);

class LessonGuide {
 public:
  /// Opens a lesson file at its first step. False where it cannot be read as a lesson: the one that was open stays.
  bool open(const std::filesystem::path& file);
  /// The open lesson as it was read again: the student stays on the step and keeps what was done. Where the step's
  /// scene is as before, the view stays too.
  void replace(Lesson lesson);

  /// Null while no lesson is open.
  LessonSession* session() { return session_.get(); }
  const LessonSession* session() const { return session_.get(); }
  const std::filesystem::path& file() const { return file_; }
  /// Grows each time a lesson is opened; 0 before the first.
  std::size_t openings() const { return openings_; }

  bool canGoOn() const { return session_ && (atLastStep() ? !closing_ : session_->hasNext() && session_->mayGoOn()); }
  bool canGoBack() const { return session_ && (closing() || session_->hasBack()); }
  /// The step after which the lesson's closing page comes.
  bool atLastStep() const { return session_ && !session_->hasNext() && !session_->step().aside; }
  /// The closing page stands in the place of the last step's text; the step's scene stays.
  bool closing() const { return closing_ && atLastStep(); }
  void next();
  void back();
  /// Follows a link to a step ("#step-id"); false where there is no such step. Stays where another step must be
  /// finished first.
  bool follow(const std::string& link);

  /// For the step that is shown; empty when it has just been entered.
  AnswerDrafts& drafts();

  /// The scene of the step when it has changed since the last call, else null.
  const SceneSpec* takeNewScene();
  /// Makes takeNewScene() give the scene again, after another molecule was opened.
  void askForScene() { scene_changed_ = true; }
  /// Whether the step's molecule is the one that was met last.
  bool onStage() const { return on_stage_; }
  /// The step's molecule, its file in the library or beside the lesson. A problem where it is in neither.
  Expected<MoleculeKey> molecule() const;

  /// A molecule has come on the stage. The tasks wait for the one that the step asks for.
  void meet(std::shared_ptr<const Molecule> molecule, const MoleculeKey& key);
  /// The atoms of the step's molecule begin elsewhere: its tasks are made for where they are.
  void beginFrom(std::shared_ptr<const Molecule> molecule);
  /// A tick; `method` made its contact, `exact` is the exact tracker's for the same hand.
  void feed(const ServoSample& sample, std::string_view method, const Contact& exact);

  /// The parts of the picture that the step asks for; the usual ones without a lesson.
  ViewPartSet shownParts() const;
  /// Whether the lesson keeps the student from changing a scene's key ("force").
  bool locks(std::string_view key) const { return session_ && session_->scene().locks(key); }
  /// How the step draws the atoms; as spheres without one.
  const AtomsLook& looks() const { return looks_; }
  /// Hides others of its atoms until the molecule is met again.
  void hide(AtomList atoms) { looks_.hidden = std::move(atoms); }
  /// Cuts them open as the step asks for, once the camera looks at them as it does.
  void cutFor(const Camera& camera, const Molecule& molecule);
  /// The atoms that the step takes from the hand, ascending.
  const std::vector<std::uint32_t>& untouchable() const { return untouchable_; }
  /// Those that the hand holds, ascending.
  const std::vector<std::uint32_t>& held() const { return held_; }
  /// The part of the molecule that the step magnifies.
  const std::optional<Region>& region() const { return region_; }
  /// What the step's view comes close to; nothing where it shows the whole.
  const std::optional<Region>& zoomed() const { return zoomed_; }
  /// Turns a fitted camera the way the step asks for.
  void face(Camera& camera, const Molecule& molecule) const;
  /// Marks what the step highlights, and writes what it names and measures.
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
  mutable std::shared_ptr<const Annotations> annotations_;  // of the molecule that was drawn last
  mutable std::shared_ptr<const Molecule> annotated_;
};

/// Turns a camera that has been fitted to the molecule the way a view of the scene asks for.
void faceView(Camera& camera, const Molecule& molecule, const ViewSpec& view, const SceneSpec& scene);
/// How a scene says the camera's turn: "turned 30 10 0", to a tenth of a degree.
std::string viewText(const Camera& camera);
/// The plane by which a scene cuts its molecule open for this camera; nothing where it does not.
std::optional<CutPlane> cutOf(const SceneSpec& scene, const Molecule& molecule, const Camera& camera);
/// A scene's molecule, its file beside the lesson or in the library. A problem where it is in neither.
Expected<MoleculeKey> moleculeOf(const SceneSpec& scene, const std::filesystem::path& lesson);

}  // namespace moltact
