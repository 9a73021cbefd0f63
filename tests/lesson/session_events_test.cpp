// The events of a session. Oracle: the acts of the student, in order.
#include <doctest/doctest.h>

#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"
#include "tests/lesson/small_molecules.h"

namespace moltact {
namespace {

std::shared_ptr<const Lesson> lessonOfThreeSteps() {
  LessonReading read = readLessonText(
      "l.md",
      "---\ntitle: T\nminutes: 1\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n"
      "## One\n```scene\nmolecule: mix\n```\n```touch\nreach: atom 0\nsay: S\n```\n```touch\nreach: atom 0\nsay: "
      "Again.\n```\n"
      "### Question: Which?\n- [x] yes → Good.\n- [ ] no → Bad.\n```answer\nattempts: 2\nif right at first: skip "
      "#two\n```\n"
      "## Two\nText.\n## Three\n### Question: Why?\n```answer\nfree: yes\n```\n");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

// One word for each event: "shown one".
std::string words(const std::vector<SessionEvent>& events) {
  std::string out;
  for (const SessionEvent& event : events) {
    const std::string word = std::visit(
        []<typename T>(const T& e) -> std::string {
          if constexpr (std::is_same_v<T, StepShown>) return "shown " + e.step;
          if constexpr (std::is_same_v<T, TaskStarted>) return "task " + std::to_string(e.task);
          if constexpr (std::is_same_v<T, TaskFinished>) return "finished " + std::to_string(e.task);
          if constexpr (std::is_same_v<T, AnswerJudged>)
            return std::string(e.right ? "right" : "wrong") + (e.completes ? ", completes" : "");
          if constexpr (std::is_same_v<T, RuleApplied>) return e.rule + ": " + e.steps.at(0);
          if constexpr (std::is_same_v<T, HintOpen>) return "hint " + std::to_string(e.number);
          return "curve";
        },
        event);
    out += (out.empty() ? "" : "; ") + word;
  }
  return out;
}

void touch(LessonSession& session, double from_s, double for_s) {
  for (double t_s = 0.0; t_s <= for_s; t_s += 0.001) {
    TouchSample s;
    s.time_s = from_s + t_s;
    s.contact.feature = Feature::Sphere;
    s.contact.atoms[0] = 0;
    session.feed(s);
  }
}

struct Student {
  LessonSession session{lessonOfThreeSteps()};
  Student() { session.setMolecule(std::make_shared<const Molecule>(mixedMolecule())); }
  std::string events() { return words(session.takeEvents()); }
};

}  // namespace

TEST_CASE("each of 9 acts is an event once, in the order in which they happened") {
  Student s;
  CHECK(s.events() == "shown one; task 0");
  CHECK(s.events().empty());
  touch(s.session, 0.0, 0.11);
  CHECK(s.events() == "finished 0; task 1");
  s.session.openHints(2);
  s.session.choose(0, {1});
  s.session.choose(0, {1});
  s.session.choose(0, {0});  // no try is left
  CHECK(s.events() == "hint 1; hint 2; wrong; wrong, completes");
  s.session.restartTask(0);
  CHECK(s.events() == "task 0");
  s.session.openHints(0);
  s.session.openHints(1);
  CHECK(s.events() == "hint 1");
  s.session.next();
  s.session.next();
  CHECK(s.session.hintsOpen() == 0);
  CHECK(s.events() == "shown three");
  s.session.write(0, "So.");
  s.session.write(0, "Or so.");
  CHECK(s.events() == "right, completes; right");
}

TEST_CASE("a rule that an answer makes true is reported once, after the answer") {
  Student s;
  s.events();
  s.session.choose(0, {0});
  CHECK(s.events() == "right, completes; if right at first: two");
}

TEST_CASE("a task that is done, or a step that is left, before the events are taken is not reported as begun") {
  Student s;
  touch(s.session, 0.0, 0.5);
  CHECK(s.events() == "shown one; finished 0; finished 1");
  Student quick;
  quick.session.goTo("#three");
  CHECK(quick.events() == "shown three");
}

TEST_CASE("work that is restored gives no event but the step and the task at which the student is") {
  Student s;
  s.events();
  QuestionStatus status;
  status.attempts = 1;
  s.session.restore({"one", {{"one", {0}, {}, {{"which", status}}}}});
  s.session.restartEvents();
  CHECK(s.events() == "shown one; task 1");
}

TEST_CASE("a lesson that is read again reports the step and task again and keeps its open hints") {
  Student s;
  s.session.openHints(1);
  s.events();
  s.session.replaceLesson(lessonOfThreeSteps());
  CHECK(s.events() == "shown one; task 0");
  CHECK(s.session.hintsOpen() == 1);
}

}  // namespace moltact
