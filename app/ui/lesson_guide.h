// The lesson that is open, as the panels and the view need it: its step, scene, tasks and questions, fed with what the
// hand felt. Window's thread.
#pragma once

#include <filesystem>
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

namespace moltact {

class LessonGuide {
 public:
  /// Opens a lesson file at its first step. Errors leave the lesson that was open; every one of them is in the text.
  std::optional<std::string> open(const std::filesystem::path& file);

  /// Null while no lesson is open.
  LessonSession* session() { return session_.get(); }
  const LessonSession* session() const { return session_.get(); }
  const std::filesystem::path& file() const { return file_; }

  bool canGoOn() const { return session_ && session_->hasNext(); }
  bool canGoBack() const { return session_ && session_->hasBack(); }
  void next();
  void back();
  /// Follows a link to a step ("#step-id"); false where there is no such step.
  bool follow(const std::string& link);

  /// The scene of the step when it has changed since the last call, else null.
  const SceneSpec* takeNewScene();
  /// Makes takeNewScene() give the scene again, after another molecule was opened.
  void askForScene() { scene_changed_ = true; }
  /// Whether the step's molecule is the one that was met last.
  bool onStage() const { return on_stage_; }
  /// The file of the step's molecule: in the library, or beside the lesson. A problem where it is in neither.
  Expected<std::filesystem::path> moleculeFile() const;

  /// A molecule has come on the stage. The tasks wait for the one that the step asks for.
  void meet(std::shared_ptr<const Molecule> molecule, const std::filesystem::path& file);
  /// A tick; `method` made its contact, `exact` is the exact tracker's for the same hand.
  void feed(const ServoSample& sample, std::string_view method, const Contact& exact);

  /// The parts of the picture that the step asks for; the usual ones without a lesson.
  ShapeSet shapes() const;
  /// Whether the step asks for a panel.
  bool wantsPanel(std::string_view name) const;
  /// Turns a fitted camera the way the step asks for.
  void face(Camera& camera, const Molecule& molecule) const;
  /// Marks what the step highlights.
  void decorate(ViewScene& scene) const;

 private:
  std::unique_ptr<LessonSession> session_;
  std::filesystem::path file_;
  std::size_t scene_seen_ = 0;
  bool scene_changed_ = false, on_stage_ = false;
  std::vector<std::uint32_t> highlighted_;
};

/// Whether a file is a lesson, by its name.
bool looksLikeLesson(const std::filesystem::path& file);

}  // namespace moltact
