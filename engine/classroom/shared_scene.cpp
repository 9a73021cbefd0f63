#include "engine/classroom/shared_scene.h"

#include <algorithm>
#include <utility>

#include "engine/classroom/class_view.h"
#include "engine/results/lesson_language.h"

namespace moltact {
namespace {

const LiveAttempt* presentAttempt(const LiveStudent& student) {
  if (student.current >= student.attempts.size()) return nullptr;
  const LiveAttempt& attempt = student.attempts[student.current];
  return attempt.lines == 0 ? nullptr : &attempt;
}

const ClassLesson* lessonOf(const ClassRoom& room, const LiveAttempt& attempt) {
  const auto found = std::find_if(room.lessons().begin(), room.lessons().end(),
                                  [&](const ClassLesson& one) { return sameLesson(one.outline, attempt.lesson); });
  return found == room.lessons().end() ? nullptr : &*found;
}

const ClassLesson* lessonNamed(const ClassRoom& room, const std::string& id) {
  const auto found =
      std::find_if(room.lessons().begin(), room.lessons().end(), [&](const ClassLesson& one) { return one.id == id; });
  return found == room.lessons().end() ? nullptr : &*found;
}

bool isHere(const LiveStudent& student, double now_s) { return now_s - student.seen_s <= kAwayAfter_s; }

bool taskOpen(const LiveAttempt* attempt, std::size_t step, std::size_t task) {
  if (!attempt || step >= attempt->steps.size()) return true;
  const std::vector<char>& done = attempt->steps[step].tasks_done;
  return task >= done.size() || !done[task];
}

bool darkTaskOpen(const ClassLesson& lesson, const LiveAttempt* attempt, std::size_t step) {
  if (step >= lesson.steps.size()) return false;
  const std::vector<char>& unseen = lesson.steps[step].unseen_tasks;
  for (std::size_t task = 0; task < unseen.size(); ++task)
    if (unseen[task] && taskOpen(attempt, step, task)) return true;
  return false;
}

bool questionOpen(const ClassLesson& lesson, const LiveAttempt* attempt, std::size_t step) {
  if (step >= lesson.outline.steps.size()) return false;
  const std::vector<QuestionOutline>& questions = lesson.outline.steps[step].questions;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (questions[q].kind == AnswerKind::Free) continue;
    if (!attempt) return true;
    const auto answer = attempt->answers.find({step, q});
    if (answer == attempt->answers.end()) return true;
    if (questions[q].kind == AnswerKind::Prediction || answer->second.right) continue;
    // After so many wrong answers the page has shown the right one.
    const int tries =
        step < lesson.steps.size() && q < lesson.steps[step].tries.size() ? lesson.steps[step].tries[q] : 0;
    if (tries == 0 || answer->second.attempt < tries) return true;
  }
  return false;
}

}  // namespace

std::optional<ScenePlace> placeOf(const ClassRoom& room, std::size_t student) {
  const LiveAttempt* attempt = presentAttempt(room.students()[student]);
  if (!attempt || !attempt->step) return std::nullopt;
  const ClassLesson* lesson = lessonOf(room, *attempt);
  if (!lesson || lesson->outline.test || *attempt->step >= lesson->outline.steps.size()) return std::nullopt;
  return ScenePlace{lesson->id, *attempt->step};
}

SceneHidden sceneAnswers(const ClassRoom& room, const ScenePlace& place, double now_s, std::size_t& waiting) {
  std::size_t dark = 0, asked = 0;
  const ClassLesson* lesson = lessonNamed(room, place.lesson);
  if (lesson)
    for (const LiveStudent& student : room.students()) {
      if (!isHere(student, now_s)) continue;
      const LiveAttempt* attempt = presentAttempt(student);
      if (attempt && lessonOf(room, *attempt) != lesson) continue;
      const std::size_t step = attempt && attempt->step ? *attempt->step : 0;
      if (darkTaskOpen(*lesson, attempt, step))
        ++dark;
      else if (step == place.step && questionOpen(*lesson, attempt, step))
        ++asked;
    }
  waiting = dark > 0 ? dark : asked;
  return dark > 0 ? SceneHidden::Dark : asked > 0 ? SceneHidden::Question : SceneHidden::No;
}

bool SharedScene::declined(const ClassRoom& room, std::size_t student) const {
  const auto said = declined_.find(student);
  return said != declined_.end() && placeOf(room, student) == said->second;
}

bool SharedScene::mayAsk(const ClassRoom& room, std::size_t student, double now_s) const {
  return state_ == State::None && !room.ended() && student < room.students().size() &&
         isHere(room.students()[student], now_s) && placeOf(room, student) && !declined(room, student);
}

bool SharedScene::ask(const ClassRoom& room, std::size_t student, double now_s) {
  if (!mayAsk(room, student, now_s)) return false;
  state_ = State::Asked;
  student_ = student;
  ++number_;
  asked_s_ = now_s;
  place_ = *placeOf(room, student);
  return true;
}

bool SharedScene::answer(std::size_t student, std::uint64_t number, bool yes, bool named, const ScenePlace& at) {
  if (state_ != State::Asked || student != student_ || number != number_) return false;
  if (!yes) {
    declined_[student] = place_;
    end();
    return true;
  }
  state_ = State::Agreed;
  named_ = named;
  place_ = at;
  known_ = false;
  return true;
}

bool SharedScene::withdraw(std::size_t student, std::uint64_t number) {
  if (state_ == State::None || student != student_ || number != number_) return false;
  declined_[student] = place_;
  end();
  return true;
}

bool SharedScene::takeOff() {
  if (state_ == State::None) return false;
  end();
  return true;
}

SharedScene::Taken SharedScene::take(std::size_t student, std::uint64_t number, const ScenePlace& at,
                                     std::string picture, double now_s) {
  if (state_ != State::Agreed || student != student_ || number != number_) return Taken::Over;
  if (at != place_) {
    end();
    return Taken::Over;
  }
  if (!rate_.take(kPictures, now_s)) return Taken::TooOften;
  picture_ = std::move(picture);
  picture_s_ = now_s;
  ++pictures_;
  return Taken::Yes;
}

void SharedScene::follow(const ClassRoom& room, double now_s) {
  if (state_ == State::None) return;
  const auto place = placeOf(room, student_);
  if (state_ == State::Agreed && place == place_) known_ = true;
  // Until the first lines of the step arrive, the lines give an earlier place.
  const bool left = state_ == State::Agreed ? known_ && place != place_ : place != place_;
  if (room.ended() || left || !isHere(room.students()[student_], now_s) ||
      (state_ == State::Asked && now_s - asked_s_ > kAskFor_s))
    end();
}

SceneHidden SharedScene::hidden(const ClassRoom& room, double now_s, std::size_t& waiting) const {
  waiting = 0;
  const SceneHidden answers = sceneAnswers(room, place_, now_s, waiting);
  if (answers != SceneHidden::No) return answers;
  return known_ && !picture_.empty() && now_s - picture_s_ <= kFreshFor_s ? SceneHidden::No : SceneHidden::NoPicture;
}

void SharedScene::end() {
  state_ = State::None;
  named_ = known_ = false;
  picture_.clear();
  picture_s_ = kNotSeen_s;
}

}  // namespace moltact
