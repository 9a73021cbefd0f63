// Applies the changes of the scene that the lesson's current task requires (a dark screen, another probe, a turned
// place) and reverts them when the task is done or left. Passes a device's buttons to the task as answers. Window's
// thread.
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
  // Restores the step's own scene, without the changes of another step's task or of the lesson before it was read
  // again.
  void stepChanged() override;

  /// The molecule must not be visible.
  bool dark() const { return stage_.dark; }
  /// The task asks what is touched, so texts must not name it.
  bool asksWhat() const { return stage_.unnamed; }
  /// Whether the force is displayed in the dark.
  bool showsForce() const { return stage_.force_meter; }
  /// The current task has two answers, and a device's second button gives the second one. It is not a clutch meanwhile.
  bool takesSecondButton() const { return two_answers_; }
  /// The current task has changed the scene's stiffness.
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
