// A lesson in which the class waits at a step: Next, links, answers that lead over it, asides, and other lessons.
#include "engine/lesson/class_hold.h"

#include <doctest/doctest.h>

#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"

namespace moltact {
namespace {

// As a page that a class holds; opened again at the end.
struct Held {
  Held(const std::string& lesson, std::size_t step) { classHolds()[lesson] = step; }
  ~Held() { classHolds().clear(); }
};

std::shared_ptr<const Lesson> heldLesson(const std::string& rules = "") {
  LessonReading read =
      readLessonText("/tmp/folder/steps.de.md",
                     "---\ntitle: T\nminutes: 1\ngoals:\n- One\nmolecules: mix\nauthor: A\nlicence: L\n---\n## "
                     "A\n```scene\nmolecule: mix\n```\n"
                     "## B\n### Question: Q?\n- [ ] no → Look [again](#aside-why).\n- [x] yes → So it is.\n" +
                         (rules.empty() ? rules : "```answer\n" + rules + "```\n") +
                         "## C\nText.\n## D\nText.\n## Aside: Why\nText.\n");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

TEST_CASE("where the class waits, Next and links lead no further, back and asides do, and opening lets all go on") {
  LessonSession s(heldLesson());
  {
    const Held held("steps", 1);
    CHECK(s.mayGoOn());
    s.next();
    CHECK(s.step().id == "b");
    CHECK_FALSE(s.mayGoOn());
    s.next();
    CHECK(s.step().id == "b");
    CHECK_FALSE(s.mayGoTo("#c"));
    CHECK_FALSE(s.mayGoTo("#d"));
    CHECK(s.mayGoTo("#a"));
    CHECK(s.mayGoTo("#aside-why"));
    s.goTo("aside-why");
    CHECK(s.mayGoOn());
    s.next();
    CHECK(s.step().id == "b");
    s.back();
    CHECK(s.step().id == "a");
    CHECK_FALSE(s.mayGoTo("#c"));
    s.next();
  }
  CHECK(s.mayGoOn());
  s.next();
  CHECK(s.step().id == "c");
}

TEST_CASE("who is beyond the held step already stays there, and may go back") {
  LessonSession s(heldLesson());
  s.goTo("c");
  const Held held("steps", 0);
  CHECK_FALSE(s.mayGoOn());
  s.back();
  CHECK(s.step().id == "b");
  CHECK_FALSE(s.mayGoOn());
}

TEST_CASE("an answer that leads or skips forward over the held step does not lead there before it is opened") {
  for (const char* rules : {"if right: go to #d\n", "if right: skip #c\n"}) {
    LessonSession s(heldLesson(rules));
    s.next();
    s.choose(0, {1});
    {
      const Held held("steps", 2);
      CHECK_FALSE(s.mayGoOn());
      s.next();
      CHECK(s.step().id == "b");
    }
    CHECK(s.mayGoOn());
    s.next();
    CHECK(s.step().id == "d");
  }
}

TEST_CASE(
    "with a hold at the third step, who has an open task at the first waits for the task, and not for the class") {
  LessonReading read = readLessonText(
      "/tmp/folder/steps.md",
      "---\ntitle: T\nminutes: 1\ngoals:\n- One\nmolecules: mix\nauthor: A\nlicence: L\n---\n## A\n```scene\nmolecule: "
      "mix\n```\n```touch\nreach: all\nsay: Touch.\n```\n## B\nText.\n## C\nText.\n## D\nText.\n");
  for (const Problem& p : read.errors) MESSAGE(p.text());
  REQUIRE(read.lesson);
  read.lesson->steps[0].required = true;
  LessonSession s(std::make_shared<const Lesson>(*std::move(read.lesson)));
  const Held held("steps", 2);
  CHECK_FALSE(s.mayGoOn());
  CHECK_FALSE(s.heldByClass());
  classHolds()["steps"] = 0;
  CHECK(s.heldByClass());
}

TEST_CASE("at the held step the class is what holds, and an answer that leads over it as well") {
  LessonSession s(heldLesson("if right: go to #d\n"));
  s.next();
  CHECK_FALSE(s.heldByClass());
  s.choose(0, {1});
  {
    const Held held("steps", 2);
    CHECK(s.heldByClass());
  }
  const Held held("steps", 1);
  CHECK(s.heldByClass());
}

TEST_CASE("another lesson that is held does not hold this one") {
  LessonSession s(heldLesson());
  const Held held("other", 0);
  CHECK(s.mayGoOn());
  CHECK(s.mayGoTo("#d"));
}

}  // namespace
}  // namespace moltact
