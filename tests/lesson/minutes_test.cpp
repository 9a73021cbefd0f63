// The minutes of a lesson, counted here word by word and task by task with the figures of docs/lesson-reference.md.
#include "engine/lesson/minutes.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/tasks/registry.h"
#include "tests/lesson/shipped_lesson.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

std::string repeated(const std::string& word, int times) {
  std::string out;
  for (int k = 0; k < times; ++k) out += word + ' ';
  return out;
}

Lesson lessonOf(const std::string& body, const std::string& minutes = {}) {
  LessonReading read = readLessonText(
      "l.md", "---\ntitle: T\n" + minutes + "goals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n" + body);
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return *std::move(read.lesson);
}

std::vector<Problem> warningsOf(const std::string& minutes, const std::string& body) {
  const LessonCheck check =
      checkLesson("l.md", "---\ntitle: T\n" + minutes + "goals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n" + body,
                  [](const NamedMolecule&) { return std::make_shared<const Molecule>(mixedMolecule()); });
  for (const Problem& p : check.errors) MESSAGE(p.text());
  CHECK(check.errors.empty());
  return check.warnings;
}

const std::string kScene = "```scene\nmolecule: mix\n```\n";

}  // namespace

TEST_CASE("129 words and the heading of a step are one minute; hints, teacher's notes and signs count nothing") {
  const Lesson plain = lessonOf("## A\n" + kScene + repeated("word", 129) + "\n");
  CHECK(minutesOf(plain).core == doctest::Approx(1.0));
  CHECK(minutesOf(plain).all == doctest::Approx(1.0));
  const Lesson more = lessonOf("## A\n" + kScene + repeated("word", 129) + "– – …\n\n> [!TIP]\n> " +
                               repeated("hint", 200) + "\n\n> [!NOTE]\n> Teacher: " + repeated("note", 200) + "\n");
  CHECK(minutesOf(more).core == doctest::Approx(1.0));
}

TEST_CASE("a question of 26 words takes 35 s and 12 s, a free answer 150 s more than its words") {
  const Lesson asked =
      lessonOf("## A\n" + kScene + "### Question: " + repeated("q", 9) + "\n\n- [x] " + repeated("a", 8) + "→ " +
               repeated("yes", 5) + "\n- [ ] " + repeated("b", 3) + "→ " + repeated("no", 50) + "\n");
  // 1 of the heading, 9 + 8 + 5 + 3 of the question: 26 words are 12 s.
  CHECK(minutesOf(asked).core * 60.0 == doctest::Approx(12.0 + 35.0));
  const Lesson free =
      lessonOf("## A\n" + kScene + "### Question: " + repeated("q", 12) + "\n\n```answer\nfree: yes\n```\n");
  CHECK(minutesOf(free).core * 60.0 == doctest::Approx(6.0 + 150.0));
}

TEST_CASE("eight pairs in the dark of 1 s each take 8 x 22 s, a search 150 s, a largest probe 180 s") {
  const auto taskOf = [](const std::string& task) {
    const Lesson lesson = lessonOf("## A\n" + kScene + "```touch\n" + task + "say: S\npraise: P\n```\n");
    return taskTime_s(lesson.steps[0].tasks[0]);
  };
  CHECK(taskOf("same: anywhere\nprobe: 2 Å\ntrials: 8\nfor: 1 s\n") == doctest::Approx(8 * 22.0));
  CHECK(taskOf("find: atom 0\n") == doctest::Approx(150.0));
  CHECK(taskOf("fit: atom 0\n") == doctest::Approx(180.0));
  CHECK(taskOf("cross: atom 0\nto: atom 1\ntimes: 3\n") == doctest::Approx(15.0 + 3 * 15.0));
  CHECK(taskOf("compare: places\nof: atom 0 then atom 1\nfor: 2 s\n") == doctest::Approx(10.0 + 2 * (12.0 + 2.0)));
}

TEST_CASE("every kind of task has its time") {
  for (const TaskKind& kind : taskKinds()) {
    CAPTURE(std::string(kind.name));
    CHECK(kind.time.base_s + kind.time.each_s > 0.0);
    CHECK(kind.time.each.empty() == (kind.time.each_s == 0.0));
  }
}

TEST_CASE("extra steps and asides count to all minutes and not to those of the core") {
  const std::string step = repeated("word", 129) + "\n";
  const Lesson lesson = lessonOf("## A\n" + kScene + step + "## B\n```step\nextra: yes\n```\n" + step +
                                 "## C\n[x](#aside-d) " + repeated("word", 128) + "\n## Aside: D\n" + step);
  CHECK(minutesOf(lesson).core == doctest::Approx(2.0));
  CHECK(minutesOf(lesson).all == doctest::Approx(4.0));
  CHECK(shownMinutes(lesson).core == 2);
  CHECK(shownMinutes(lesson).all == 4);
  // The author's value for the core takes precedence; the rest is added.
  Lesson stated = lesson;
  stated.minutes = 3;
  CHECK(shownMinutes(stated).core == 3);
  CHECK(shownMinutes(stated).all == 5);
}

TEST_CASE("check warns of minutes that are off by more than 20 %, and of a core of more than 20 minutes") {
  const std::string ten = "## A\n" + kScene + repeated("word", 1299) + "\n";
  CHECK(warningsOf("minutes: 10\n", ten).empty());
  CHECK(warningsOf("minutes: 12\n", ten).empty());
  CHECK(warningsOf("minutes: 8\n", ten).empty());
  CHECK(warningsOf("", ten).empty());
  for (const char* off : {"minutes: 7\n", "minutes: 13\n"}) {
    const std::vector<Problem> warnings = warningsOf(off, ten);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].line == 3);
    CHECK(warnings[0].message.find("its core takes about 10") != std::string::npos);
  }
  const std::string long_one = "## A\n" + kScene + repeated("word", 2639) + "\n";
  const std::vector<Problem> warnings = warningsOf("", long_one);
  REQUIRE(warnings.size() == 1);
  CHECK(warnings[0].message.find("more than 20") != std::string::npos);
  CHECK(warnings[0].remedy.find("extra: yes") != std::string::npos);
}
