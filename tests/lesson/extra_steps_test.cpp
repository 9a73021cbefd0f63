// Extra steps: outside the core like asides, and offered by the program.
#include <doctest/doctest.h>

#include "engine/lesson/check.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/session.h"
#include "tests/lesson/small_molecules.h"

using namespace moltact;

namespace {

const std::string kExtraStepsHead = "---\ntitle: T\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n";
const std::string kBody =
    "## A\n```scene\nmolecule: mix\n```\nText.\n### Question: Q?\n- [x] a\n- [ ] b\n"
    "## B\n```step\nextra: yes\n```\n```scene\nprobe: 2 Å\n```\nText.\n### Question: R?\n- [x] a\n- [ ] b\n"
    "## C\n```step\nextra: yes\n```\nText.\n"
    "## D\nText.\n### Question: S?\n- [x] a\n- [ ] b\n";

std::vector<Problem> errorsOf(const std::string& body) {
  LessonCheck check = checkLesson("l.md", kExtraStepsHead + body, [](const NamedMolecule&) {
    return std::make_shared<const Molecule>(mixedMolecule());
  });
  return check.errors;
}

}  // namespace

TEST_CASE("Next passes 2 extra steps over, the step before offers them, and neither progress nor the end counts them") {
  CHECK(errorsOf(kBody).empty());
  LessonReading read = readLessonText("l.md", kExtraStepsHead + kBody);
  REQUIRE(read.lesson);
  LessonSession s(std::make_shared<const Lesson>(*read.lesson));
  CHECK(s.lesson().extrasOf(0) == std::vector<std::size_t>{1, 2});
  CHECK(s.lesson().extrasOf(3).empty());
  CHECK(s.parts().of == 2);
  s.choose(0, {0});
  s.next();
  CHECK(s.step().id == "d");
  s.choose(0, {0});
  CHECK(s.finished());
  CHECK_FALSE(s.hasNext());
  s.back();
  CHECK(s.step().id == "a");
  // From an extra step back to where the student came from.
  REQUIRE(s.goTo("#b"));
  s.choose(0, {0});
  CHECK(s.parts().done == 2);
  s.next();
  CHECK(s.step().id == "a");
}

TEST_CASE("what an extra step puts on the stage continues in the extra step after it and is gone in the core") {
  LessonReading read = readLessonText("l.md", kExtraStepsHead + kBody);
  REQUIRE(read.lesson);
  CHECK(read.lesson->steps[1].scene.touch.probe_A == 2.0);
  CHECK(read.lesson->steps[2].scene.touch.probe_A == 2.0);
  CHECK(read.lesson->steps[3].scene.touch.probe_A == 1.4);
}

TEST_CASE("the first step is no extra step, and a step block stands above the scene of an extra step") {
  const std::string scene = "```scene\nmolecule: mix\n```\n", extra = "```step\nextra: yes\n```\n";
  const std::vector<Problem> first = errorsOf("## A\n" + extra + scene + "Text.\n## B\nText.\n");
  REQUIRE(first.size() >= 1);
  CHECK(first[0].message == "the first step cannot be an extra step");
  const std::vector<Problem> below =
      errorsOf("## A\n" + scene + "Text.\n## B\n```scene\nprobe: 2 Å\n```\n" + extra + "Text.\n");
  REQUIRE(below.size() == 1);
  CHECK(below[0].message == "an extra step has its step block below its scene");
}

TEST_CASE("of a task that is asked before, the same task is asked after, in the core and with the same keys") {
  const std::string scene = "```scene\nmolecule: mix\n```\n";
  const auto task = [](const std::string& asked, const std::string& probe) {
    return "```touch\nsame: anywhere\nprobe: " + probe + "\nasked: " + asked + "\nsay: S\npraise: P\n```\n";
  };
  CHECK(errorsOf("## A\n" + scene + task("before", "2 Å") + "## B\n" + task("after", "2 Å")).empty());
  const auto only = [&](const std::string& body) {
    const std::vector<Problem> errors = errorsOf(body);
    REQUIRE(errors.size() == 1);
    return errors[0].message;
  };
  CHECK(only("## A\n" + scene + task("before", "2 Å")) == "no later task of the lesson is asked 'after'");
  CHECK(only("## A\n" + scene + task("after", "2 Å")) == "no earlier task of the lesson is asked 'before'");
  const std::string differs = "what is asked before and after differs, so the gain would mean nothing";
  CHECK(only("## A\n" + scene + task("before", "2 Å") + "## B\n" + task("after", "3 Å")) == differs);
  CHECK(only("## A\n" + scene + task("before", "2 Å") + "## B\n```scene\nprobe: 1 Å\n```\n" + task("after", "2 Å")) ==
        differs);
  CHECK(only("## A\n" + scene + task("before", "2 Å") + "## B\n```step\nextra: yes\n```\n" + task("after", "2 Å")) ==
        "a task that is asked before and after is outside the core");
}
