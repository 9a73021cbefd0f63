// The ends of a lesson and its navigation: goals, hints one by one, the sign for content below, the closing page, and
// Escape.
#include <filesystem>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/widget_map.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

std::string lessonText() {
  std::string body = R"(> [!TIP]
> The first hint.

> [!TIP]
> The second hint.

```touch
reach: all
say: Touch it.
```

)";
  for (int k = 0; k < 40; ++k)
    body += "A line of text that takes its room on the page, number " + std::to_string(k) + ".\n\n";
  return argonLesson("Two ends", "  - Tell a beginning\n  - Tell an end\n",
                     body + "### Question: Which?\n\n1. [x] This → Yes.\n2. [ ] That → No.\n");
}

struct Opened {
  ScratchFolder scratch;
  std::unique_ptr<ScriptedUser> driver;
  Opened() {
    writeFile(scratch.path / "ends.md", lessonText());
    driver = startWith((scratch.path / "ends.md").string());
  }
  LessonSession& session() { return *driver->app().lesson.session(); }
};

}  // namespace

TEST_CASE("two goals stand at the start, and at the end with what was done: 1 task, 1 of 1 answers, 1 of 1 steps") {
  Opened o;
  CHECK(o.driver->text("lesson/goal/1") == "Tell an end");
  CHECK(o.driver->click("lesson/goals"));
  o.driver->frames(3);
  CHECK_FALSE(o.driver->shows("lesson/goal/1"));
  CHECK_FALSE(o.driver->shows("lesson/end"));
  o.driver->point("view");
  o.driver->press();
  o.driver->frames(150);
  o.driver->release();
  o.driver->frames(10);
  REQUIRE(o.session().task(0).done);
  o.session().choose(0, {0});
  CHECK(o.driver->text("lesson/next") == "To the end");
  CHECK(o.driver->click("lesson/next"));
  o.driver->frames(3);
  CHECK(o.driver->text("lesson/end") == "You have finished Two ends.");
  CHECK(o.driver->text("lesson/end/goal/0") == "Tell a beginning");
  CHECK(o.driver->text("lesson/end/tasks") == "1 touch task done.");
  CHECK(o.driver->text("lesson/end/questions") == "1 of 1 answers right at the first try.");
  CHECK(o.driver->text("lesson/end/way") == "1 of 1 steps seen.");
  CHECK(o.driver->click("lesson/end/more"));
  o.driver->frames(3);
  CHECK(o.driver->app().panels.pages.welcome);
}

TEST_CASE(
    "goals stand open at a lesson's start where the first task keeps in sight; nine of them in a window of 560 pixels "
    "are closed and open by a click, and in a lesson that is gone on with they stay closed") {
  const ScratchFolder scratch;
  const auto open = [&](std::size_t goals, int height) {
    std::string lines;
    for (std::size_t k = 0; k < goals; ++k) lines += "  - Tell the thing of number " + std::to_string(k) + "\n";
    writeFile(scratch.path / "goals.md",
              argonLesson("Goals", lines, "Text.\n\n```touch\nreach: all\nsay: Touch it.\n```\n"));
    ScriptedUser::Options options;
    options.height = height;
    return startWith((scratch.path / "goals.md").string(), std::move(options));
  };
  auto d = open(3, 800);
  CHECK(d->shows("lesson/goal/2"));
  CHECK(d->shows("task/0"));
  // What a student has chosen stays so.
  CHECK(d->click("lesson/goals"));
  d->frames(5);
  CHECK_FALSE(d->shows("lesson/goal/2"));
  d.reset();  // one window at a time
  d = open(9, 560);
  CHECK_FALSE(d->shows("lesson/goal/0"));
  CHECK(d->shows("task/0"));
  CHECK(d->click("lesson/goals"));
  d->frames(5);
  CHECK(d->shows("lesson/goal/0"));
  d.reset();
  d = open(3, 800);
  REQUIRE(d->shows("lesson/goal/2"));
  SessionMemory memory{.step = "one-step",
                       .steps = {{.step = "one-step", .tasks_done = {0}, .tasks_shown = {}, .questions = {}}}};
  d->app().lesson.session()->restore(memory);
  d->app().panels.lesson_memory.goals.reset();
  d->frames(5);
  CHECK_FALSE(d->shows("lesson/goal/2"));
}

TEST_CASE(
    "the closing card lists the steps in the order of the visits, with the aside, and skipped ones "
    "at their regular position") {
  const ScratchFolder scratch;
  writeFile(
      scratch.path / "way.md",
      "---\ntitle: A way\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n"
      "## First\n```scene\nmolecule: argon\n```\nSee [why](#aside-why).\n### Question: Which?\n1. [x] This → Yes.\n"
      "2. [ ] That → No.\n```answer\nif right: skip #easier\n```\n"
      "## Easier\nText.\n## Last\nText.\n## Aside: Why\nText.\n");
  auto d = startWith((scratch.path / "way.md").string());
  LessonSession& session = *d->app().lesson.session();
  d->app().lesson.follow("#aside-why");
  d->frames(3);
  d->app().lesson.next();
  session.choose(0, {0});
  d->app().lesson.next();
  d->frames(5);
  d->tap("Alt+Right");
  d->frames(5);
  CHECK(session.visitedSteps() == std::vector<std::size_t>{0, 3, 2});
  CHECK(d->text("lesson/end/order") == "First → side path: Why → (passed over: Easier) → Last");
  CHECK(d->text("lesson/end/skipped") == "1 step passed over, by your answers.");
}

TEST_CASE("H opens the first hint, then the second, then closes both") {
  Opened o;
  for (const std::size_t open : {1u, 2u, 0u}) {
    o.driver->tap("H");
    o.driver->frames(2);
    CHECK(o.driver->app().lesson.session()->hintsOpen() == open);
  }
}

TEST_CASE(
    "a question below the edge is announced by a sign, which leads there; at the end of the text the "
    "sign is gone") {
  Opened o;
  CHECK(o.driver->text("lesson/more") == "A question stands below");
  for (int k = 0; k < 20 && o.driver->shows("lesson/more"); ++k) {
    CHECK(o.driver->click("lesson/more"));
    o.driver->frames(3);
  }
  CHECK_FALSE(o.driver->shows("lesson/more"));
  CHECK(o.driver->shows("question/0/0"));
}

TEST_CASE("Escape does not leave a lesson") {
  Opened o;
  o.driver->tap("Escape");
  o.driver->frames(3);
  CHECK_FALSE(o.driver->app().panels.pages.welcome);
  CHECK(o.driver->app().panels.lesson);
}

}  // namespace moltact
