#include "app/ui/extensions/class_turns.h"

#include <algorithm>

#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/attempt_recorder.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"

namespace moltact {

void ClassTurns::begin(std::vector<std::string> names, double turn_s) {
  turns_.begin(std::move(names), turn_s);
  predictions_ = 0;
  if (!on()) return;
  panels_.pages.welcome = panels_.lesson_memory.teacher_notes = false;
  call();
}

void ClassTurns::call() {
  draft.who = 0;
  draft.prediction.clear();
  recorder_.pause(true);
}

void ClassTurns::start() {
  if (turns_.state() != Turns::State::HandOver) return;
  turns_.start();
  scene_.playedHand().show(std::nullopt);
  recorder_.pause(false);
  recorder_.passTo(turns_.current());
}

void ClassTurns::passOn() {
  turns_.passOn();
  if (on()) call();
}

void ClassTurns::skip() {
  turns_.leave(turns_.current());
  if (on())
    call();
  else
    end();
}

void ClassTurns::end() {
  turns_.end();
  scene_.playedHand().show(std::nullopt);
  recorder_.pause(false);
  recorder_.passTo({});
}

std::string ClassTurns::prompt(const LessonGuide& lesson) const {
  const LessonSession* session = lesson.session();
  if (!session) return tr("What will be felt next?");
  for (std::size_t k = 0; k < session->step().tasks.size(); ++k) {
    const TaskStatus task = session->task(k);
    if (task.current && !task.say.empty()) return trf("“{0}” What will be felt?", task.say);
  }
  for (std::size_t k = 0; k < session->step().questions.size(); ++k)
    if (!session->question(k).done()) return plainText(session->step().questions[k].title);
  return tr("What will be felt next?");
}

bool ClassTurns::predict(const std::string& name, const std::string& text) {
  const std::vector<std::string> waiting = turns_.waiting();
  const std::string said(trimmed(text));
  if (said.empty() || std::find(waiting.begin(), waiting.end(), name) == waiting.end()) return false;
  const LessonSession* session = lesson_.session();
  recorder_.keepPrediction({name, session ? session->step().id : std::string(), prompt(lesson_), said});
  ++predictions_;
  return true;
}

void ClassTurns::beforeTicks() {
  if (!on()) return;
  if (turns_.tick(time_.dt_s)) call();
  // No force and no touch during a hand-over.
  if (turns_.state() == Turns::State::HandOver) scene_.playedHand().show(ServoSample());
}

}  // namespace moltact
