// The ends of a lesson and what leads through it: goals, hints one after the other, the sign of what stands below, the
// card that closes it, and Escape.
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
  CHECK_FALSE(o.driver->shows("lesson/goal/1"));
  CHECK(o.driver->click("lesson/goals"));
  o.driver->frames(3);
  CHECK(o.driver->text("lesson/goal/1") == "Tell an end");
  CHECK(o.driver->click("lesson/goals"));
  CHECK_FALSE(o.driver->shows("lesson/end"));
  o.driver->point("view");
  o.driver->press();
  o.driver->frames(150);
  o.driver->release();
  o.driver->frames(10);
  REQUIRE(o.session().task(0).done);
  o.session().choose(0, {0});
  for (int k = 0; k < 20 && !o.driver->shows("lesson/end/more"); ++k) o.driver->tap("Ctrl+PageDown");
  o.driver->frames(3);
  CHECK(o.driver->text("lesson/end") == "You have finished Two ends.");
  CHECK(o.driver->text("lesson/end/goal/0") == "Tell a beginning");
  CHECK(o.driver->text("lesson/end/tasks") == "1 touch task done.");
  CHECK(o.driver->text("lesson/end/questions") == "1 of 1 answers right at the first try.");
  CHECK(o.driver->text("lesson/end/way") == "1 of 1 steps seen.");
  CHECK(o.driver->click("lesson/end/more"));
  o.driver->frames(3);
  CHECK(o.driver->app().panels.welcome);
}

TEST_CASE("H opens the first hint, then the second, then closes both") {
  Opened o;
  for (const std::size_t open : {1u, 2u, 0u}) {
    o.driver->tap("H");
    o.driver->frames(2);
    CHECK(o.driver->app().panels.hints == open);
  }
}

TEST_CASE("a question below the edge is told by a sign, which leads there; at the end of the text the sign is gone") {
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
  CHECK_FALSE(o.driver->app().panels.welcome);
  CHECK(o.driver->app().panels.lesson);
}

}  // namespace moltact
