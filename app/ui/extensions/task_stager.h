// Sets the scene as the lesson's current task asks for it (a dark screen, another probe, a place turned to the front)
// and back again when the task is done or left; lets a device's buttons give a task's answers. Window's thread.
#pragma once

#include <cstdint>

#include "app/ui/application/extension.h"
#include "engine/lesson/tasks/task.h"

namespace moltact {

class LessonGuide;
class Opener;
struct PanelState;

class TaskStager final : public Extension {
 public:
  TaskStager(Opener& opener, HapticSession& scene, LessonGuide& lesson, PanelState& panels)
      : opener_(opener), scene_(scene), lesson_(lesson), panels_(panels) {}

  void beforeTicks() override;
  void ticks(const FeltTicks& felt) override;
  // The step's own scene, without what a task of another step, or of the lesson as it was before, asked for.
  void stepChanged() override;

  /// The molecule is not to be seen.
  bool dark() const { return stage_.dark; }
  /// The task asks what is touched.
  bool asksWhat() const { return stage_.unnamed; }
  /// In the dark, whether the force is shown.
  bool showsForce() const { return stage_.force_meter; }
  /// The current task has two answers, and a device's second button gives the second: it is no clutch meanwhile.
  bool takesSecondButton() const { return two_answers_; }
  /// A task has made the surface softer or harder than the lesson's scene.
  bool changesStiffness() const { return stage_.touch.has(&TouchSetup::stiffness_N_per_mm); }

 private:
  Opener& opener_;
  HapticSession& scene_;
  LessonGuide& lesson_;
  PanelState& panels_;
  void comeClose(const std::optional<PointA>& place);
  void change(const TouchChange& before, const TouchChange& now);

  TaskStage stage_;
  std::optional<PointA> came_close_;
  std::uint32_t buttons_ = 0;
  bool two_answers_ = false;
};

}  // namespace moltact
