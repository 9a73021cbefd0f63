#include "app/ui/extensions/task_stager.h"

#include <string>
#include <utility>
#include <vector>

#include "app/ui/application/application.h"

namespace moltact {

void TaskStager::beforeTicks(Application& app) {
  app.panels.arrows_draw = false;
  const LessonSession* session = app.lesson.session();
  const TaskStage wanted = session && app.lesson.onStage() && app.scene.stage() ? session->taskStage() : TaskStage();
  if (wanted == stage_) return;
  if (!session) {
    const bool lacks = !stage_.removed.empty() && app.scene.stage();
    stage_ = wanted;
    if (lacks) app.beginSceneAgain();
    return;
  }
  change(app, stage_.touch, wanted.touch);
  // What was found in the dark is seen where it lies: the light comes on and nothing else changes.
  const bool found = stage_.turned && wanted == TaskStage();
  const bool anew = !found && (wanted.presentation != stage_.presentation || wanted.turned != stage_.turned);
  stage_ = wanted;
  if (!anew) return;
  app.beginSceneAgain(wanted.facing, wanted.turned, wanted.removed);
  app.scene.controls.letGo();
}

void TaskStager::stepChanged(Application& app) {
  const LessonSession* session = app.lesson.session();
  const TaskStage before = std::exchange(stage_, {});
  if (session) change(app, before.touch, {});
}

void TaskStager::change(Application& app, const TouchChange& before, const TouchChange& now) {
  TouchSetup touch = app.scene.touch();
  now.replace(before, app.lesson.session()->scene().touch, touch);
  app.scene.setTouch(touch);
}

void TaskStager::ticks(Application& app, const FeltTicks& felt) {
  LessonSession* session = app.lesson.session();
  const Task* current = session ? session->taskAt(session->currentTask()) : nullptr;
  two_answers_ = current && current->buttons().size() > 1;
  for (const FeltTick& tick : felt.ticks) {
    const std::uint32_t pressed = tick.sample.buttons & ~buttons_;
    buttons_ = tick.sample.buttons;
    const Task* task = session ? session->taskAt(session->currentTask()) : nullptr;
    if (!pressed || !task) continue;
    const std::vector<TaskButton> offered = task->buttons();
    for (std::size_t k = 0; k < offered.size() && k < 32; ++k)
      if (pressed >> k & 1u) {
        session->answerTask({std::string(offered[k].word)});
        break;
      }
  }
}

}  // namespace moltact
