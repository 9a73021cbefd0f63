#include "app/ui/extensions/lesson_locks.h"

#include "app/ui/application/application.h"

namespace moltact {

void LessonLocks::afterPanels(Application& app) {
  if (!app.lesson.session()) return;
  const SceneSpec& spec = app.lesson.session()->scene();
  // A task may change the scene while it is under way.
  const TaskStage stage = app.lesson.session()->taskStage();
  const TouchSetup set = stage.touch.over(spec.touch);
  TouchSetup touch = app.scene.touch();
  for (const TouchProperty& property : touchProperties())
    if (spec.locks(property.key)) setTouchValue(touch, property, touchValue(set, property));
  app.scene.setTouch(touch);
  if (spec.locks("show")) {
    app.scene.shown = app.lesson.shownParts();
    app.scene.look = app.lesson.looks();
    app.scene.colour_by = colourBy(spec);
  }
  if (spec.locks("panels")) app.panels.enforceLessonPanels(spec.panels);
}

}  // namespace moltact
