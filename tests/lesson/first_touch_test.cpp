// The shipped lesson: it reads without a problem, and its steps are what a newcomer is promised.
#include <doctest/doctest.h>

#include <set>

#include "engine/lesson/reader.h"

using namespace moltact;

TEST_CASE("first-touch.md reads without errors or warnings into 5 steps, from argon to ubiquitin, each with a task") {
  const LessonReading read = readLesson(MOLTACT_SOURCE_DIR "/lessons/first-touch.md");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  for (const Problem& p : read.warnings) MESSAGE(p.text());
  REQUIRE(read.lesson);
  CHECK(read.warnings.empty());
  const Lesson& lesson = *read.lesson;
  CHECK(lesson.title == "First touch");
  CHECK(lesson.minutes == 8);
  CHECK(lesson.goals.size() == 3);
  REQUIRE(lesson.steps.size() == 5);
  const char* expected[] = {"argon", "dinitrogen", "benzene", "helix", "1ubq"};
  std::set<std::string> used;
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(lesson.steps[i].scene.molecule == expected[i]);
    CHECK(lesson.steps[i].tasks.size() >= 2);
    used.insert(lesson.steps[i].scene.molecule);
  }
  CHECK(used.size() == lesson.molecules.size());
  std::size_t questions = 0, notes = 0, tips = 0;
  for (const Step& s : lesson.steps) {
    questions += s.questions.size();
    for (const Block& b : s.blocks) {
      notes += std::holds_alternative<TeacherNote>(b);
      tips += std::holds_alternative<Tip>(b);
    }
  }
  CHECK(questions == 3);
  CHECK(notes == 1);
  CHECK(tips >= 6);
}
