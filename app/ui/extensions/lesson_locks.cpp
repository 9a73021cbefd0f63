#include "app/ui/extensions/lesson_locks.h"

#include "app/ui/application/panel_state.h"
#include "app/ui/lesson/lesson_guide.h"

namespace moltact {

void LessonLocks::afterPanels() {
  if (!lesson_.session()) return;
  const SceneSpec& spec = lesson_.session()->scene();
  // The current task may change the scene.
  const TaskStage stage = lesson_.session()->taskStage();
  const TouchSetup set = stage.touch.over(spec.touch);
  TouchSetup touch = scene_.touch();
  for (const TouchProperty& property : touchProperties())
    if (spec.locks(property.key)) setTouchValue(touch, property, touchValue(set, property));
  scene_.setTouch(touch);
  if (spec.locks("show")) {
    scene_.look.shown = lesson_.shownParts();
    scene_.look.atoms = lesson_.looks();
    scene_.look.colour_by = colourBy(spec);
  }
  if (spec.locks("panels")) {
    panels_.lesson = true;
    panels_.tabs.enforceLesson(spec.panels);
  }
}

}  // namespace moltact
