#include "app/ui/extensions/task_stager.h"

#include <string>
#include <utility>
#include <vector>

#include "app/ui/application/opener.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/lesson/lesson_guide.h"

namespace moltact {

void TaskStager::beforeTicks() {
  panels_.arrows_draw = false;
  const LessonSession* session = lesson_.session();
  TaskStage wanted = session && lesson_.onStage() && scene_.stage() ? session->taskStage() : TaskStage();
  scene_.lead(session && lesson_.onStage() && scene_.stage() ? session->taskGuide() : std::nullopt);
  comeClose(std::exchange(wanted.close_to, std::nullopt));
  if (wanted == stage_) return;
  scene_.controls.startTurned(wanted.body_turned);
  scene_.controls.startAt(wanted.body_begins);
  if (!session) {
    const bool lacks = !(stage_.removed.empty() && stage_.in_hand.empty()) && scene_.stage();
    stage_ = wanted;
    if (lacks) opener_.beginSceneAgain();
    return;
  }
  change(stage_.touch, wanted.touch);
  // A place found in the dark stays where it is: the molecule becomes visible and nothing else changes.
  const bool found = (stage_.turned || stage_.body_turned) && wanted == TaskStage() && wanted.in_hand == stage_.in_hand;
  const bool anew = !found && (wanted.presentation != stage_.presentation || wanted.turned != stage_.turned ||
                               wanted.body_turned != stage_.body_turned);
  stage_ = wanted;
  if (!anew) return;
  opener_.beginSceneAgain(wanted.facing, wanted.turned, wanted.removed, wanted.in_hand);
  scene_.controls.letGo();
  // A device's hand finds no place in the dark: what it holds comes to it.
  if (!wanted.in_hand.empty() && wanted.body_begins && scene_.servo().deviceLeads())
    scene_.view().holdAt({*wanted.body_begins, wanted.body_turned.value_or(kNoRotation)});
}

// Not while the hand presses, because the place would move away from it.
void TaskStager::comeClose(const std::optional<PointA>& place) {
  if (place == came_close_ || (place && scene_.controls.pressing())) return;
  came_close_ = place;
  if (place) opener_.comeCloseTo(*place);
}

void TaskStager::stepChanged() {
  const LessonSession* session = lesson_.session();
  const TaskStage before = std::exchange(stage_, {});
  scene_.controls.startTurned({});
  scene_.controls.startAt({});
  if (session) change(before.touch, {});
}

void TaskStager::change(const TouchChange& before, const TouchChange& now) {
  TouchSetup touch = scene_.touch();
  now.replace(before, lesson_.session()->scene().touch, touch);
  scene_.setTouch(touch);
}

void TaskStager::ticks(const FeltTicks& felt) {
  LessonSession* session = lesson_.session();
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
