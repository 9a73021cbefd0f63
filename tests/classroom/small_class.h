// A class of one small lesson, and the lines that a student's page sends of it.
#pragma once

#include <string>
#include <vector>

#include "engine/classroom/class_room.h"
#include "engine/core/random.h"
#include "engine/results/attempt_lines.h"

namespace moltact::test {

inline LessonOutline smallOutline() {
  LessonOutline lesson;
  lesson.file = "bumps.md";
  lesson.title = "Bumps & <holes>";
  lesson.hash = "0123456789abcdef";
  StepOutline one{"one", "Feel <b>it</b>", {{"predict", "Draw the force"}, {"reach", "Touch it"}}, {}};
  one.questions.push_back({"expect", "What will you feel?", {"a bump", "a hole"}, {}, AnswerKind::Prediction, {}, {}});
  StepOutline two{"two", "Count", {}, {}};
  two.questions.push_back(
      {"which", "Which?", {"this", "that"}, {1}, AnswerKind::Marked, {"takes <this> for that", ""}, {}});
  StepOutline three{"three", "End", {}, {}};
  lesson.steps = {one, two, three};
  return lesson;
}

inline std::vector<ClassLesson> smallLessons() { return {{"bumps", smallOutline()}}; }

inline std::string withoutEnd(std::string line) {
  line.pop_back();
  return line;
}

inline std::string headerLine(const std::string& student = "whoever", LessonOutline lesson = smallOutline()) {
  AttemptHeader header;
  header.program = "0.1.0";
  header.began = "2026-11-21T10:58:14Z";
  header.student = student;
  header.device = "Mouse";
  header.lesson = std::move(lesson);
  return withoutEnd(lineOf(header));
}

inline std::string eventLine(double t_s, AttemptFact fact) {
  return withoutEnd(lineOf(AttemptEvent{t_s, std::move(fact)}));
}

/// A student's page that sends one line after the other.
struct SmallStudent {
  ClassRoom& room;
  std::size_t number;
  std::string key = "bumps-1";
  std::size_t sent = 0;

  SmallStudent(ClassRoom& of, const std::string& name, double now_s = 0.0) : room(of) {
    number = room.join(name, "token-" + std::to_string(room.students().size()), now_s)->student;
    send(headerLine(), now_s);
  }
  ClassRoom::Taken send(const std::string& line, double now_s) {
    const ClassRoom::Taken taken = room.take(number, key, sent, {line}, now_s);
    sent = taken.have;
    return taken;
  }
  void at(double t_s, AttemptFact fact) { send(eventLine(t_s, std::move(fact)), t_s); }
};

}  // namespace moltact::test
