#include "app/ui/extensions/lesson_locks.h"

#include "app/ui/application/application.h"

namespace moltact {

void LessonLocks::afterPanels(Application& app) {
  if (!app.lesson.session()) return;
  const SceneSpec& spec = app.lesson.session()->scene();
  // A task may change the scene while it is under way.
  const TaskStage stage = app.lesson.session()->taskStage();
  const std::string& method = stage.method.empty() ? spec.method : stage.method;
  if (spec.locks("probe")) app.scene.servo_settings.probe_A = stage.probe_A.value_or(spec.probe_A);
  if (spec.locks("stiffness"))
    app.scene.servo_settings.stiffness_N_per_mm = stage.stiffness_N_per_mm.value_or(spec.stiffness_N_per_mm);
  if (spec.locks("force")) app.scene.servo_settings.force_on = spec.force;
  if (spec.locks("method") && findMethod(method) && app.scene.method() != method) app.scene.useMethod(method);
  if (spec.locks("show")) {
    app.scene.shown = app.lesson.shownParts();
    app.scene.colour_by = colourBy(spec);
  }
  if (spec.locks("panels")) app.panels.enforceLessonPanels(spec.panels);
}

}  // namespace moltact
