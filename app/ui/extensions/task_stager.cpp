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
    stage_ = wanted;
    return;
  }
  const SceneSpec& spec = session->scene();
  ServoSettings& settings = app.scene.servo_settings;
  if (wanted.probe_A != stage_.probe_A) settings.probe_A = wanted.probe_A.value_or(spec.probe_A);
  if (wanted.stiffness_N_per_mm != stage_.stiffness_N_per_mm)
    settings.stiffness_N_per_mm = wanted.stiffness_N_per_mm.value_or(spec.stiffness_N_per_mm);
  if (wanted.method != stage_.method) app.scene.useMethod(wanted.method.empty() ? spec.method : wanted.method);
  const bool anew = wanted.presentation != stage_.presentation;
  stage_ = wanted;
  if (!anew) return;
  app.beginSceneAgain(wanted.facing);
  app.scene.controls.letGo();
}

void TaskStager::stepChanged(Application& app) {
  const LessonSession* session = app.lesson.session();
  const TaskStage before = std::exchange(stage_, {});
  if (!session) return;
  const SceneSpec& spec = session->scene();
  if (before.probe_A) app.scene.servo_settings.probe_A = spec.probe_A;
  if (before.stiffness_N_per_mm) app.scene.servo_settings.stiffness_N_per_mm = spec.stiffness_N_per_mm;
  if (!before.method.empty()) app.scene.useMethod(spec.method);
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
