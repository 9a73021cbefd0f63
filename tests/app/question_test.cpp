// Questions on the page: predictions are resolved only after the touch, the order of choices belongs to the attempt,
// typed text is not lost. Oracle: the attempt's file.
#include <algorithm>
#include <filesystem>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/key_focus.h"
#include "engine/results/progress.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

const std::string kLesson = argonLesson("Questions of every kind", "  - See them\n", R"(### Prediction: Where?

- [ ] One → No.
- [ ] Two → Not so.
- [x] Three → So it is.
- [ ] Four → Nor this.

```touch
reach: all
say: Touch it.
```

### Question: How far?

```answer
number: 3.76 Å
tolerance: 0.02 Å
```

### Question: Why?

```answer
free: yes
model: Because.
```
)");

struct QuestionOpened {
  ScratchFolder scratch;
  std::unique_ptr<ScriptedUser> driver;
  QuestionOpened() {
    writeFile(scratch.path / "q.md", kLesson);
    start();
  }
  void start() {
    ScriptedUser::Options options;
    options.application.attempts_folder = scratch.path / "attempts";
    driver = startWith((scratch.path / "q.md").string(), std::move(options));
  }
  LessonSession& session() { return *driver->app().lesson.session(); }
  void touch() {
    driver->point("view");
    driver->press();
    driver->frames(40);
    driver->release();
    driver->frames(10);
  }
};

// The choices of the first question, from top to bottom.
std::vector<std::size_t> shownOrder(std::size_t choices) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < choices; ++k) out.push_back(k);
  const auto top = [&](std::size_t k) { return widgets().find("question/0/" + std::to_string(k))->low.y; };
  std::sort(out.begin(), out.end(), [&](std::size_t a, std::size_t b) { return top(a) < top(b); });
  return out;
}

TEST_CASE(
    "the order of choices is the attempt's and stays when it continues; a number key takes the choice at its place") {
  QuestionOpened o;
  AttemptRecorder& recorder = o.driver->app().extensions().recorder;
  const auto order = shownOrder(4);
  CHECK(order == o.session().choiceOrder(0));
  readQuestion(*o.driver, 0);
  o.driver->tap("2");
  CHECK(o.session().question(0).chosen == std::vector<std::size_t>{order[1]});
  REQUIRE(recorder.flush());
  const auto files = attemptFiles(o.scratch.path / "attempts");
  REQUIRE(files->size() == 1);
  const Expected<Attempt> attempt = readAttempt(files->front());
  REQUIRE(bool(attempt));
  LessonSession fresh(std::make_shared<const Lesson>(o.session().lesson()));
  fresh.setOrderSeed(orderSeed(attempt->header));
  CHECK(fresh.choiceOrder(0) == order);

  recorder.resume(o.scratch.path / "q.md", files->front());
  o.driver->frames(20);
  CHECK(shownOrder(4) == order);
  CHECK(o.session().question(0).chosen == std::vector<std::size_t>{order[1]});
}

TEST_CASE(
    "a prediction is resolved after the touch: until then another can be chosen, and no choice looks "
    "right or wrong") {
  QuestionOpened o;
  o.driver->click("question/0/0");
  CHECK(contains(o.driver->text("question/0/feedback/0"), "Kept"));
  o.driver->click("question/0/1");
  CHECK(contains(o.driver->text("question/0/feedback/0"), "Kept"));
  CHECK(o.session().question(0).chosen == std::vector<std::size_t>{1});
  o.touch();
  REQUIRE(o.session().task(0).done);
  CHECK(o.driver->text("question/0/feedback/0") == "Not so.");
  o.driver->click("question/0/2");
  CHECK(o.session().question(0).chosen == std::vector<std::size_t>{1});
}

TEST_CASE(
    "an answer that is not a number is asked again and not counted; Escape ends the writing and takes nothing back") {
  QuestionOpened o;
  o.driver->click("question/1/field");
  o.driver->type("about four");
  o.driver->tap("Escape");
  o.driver->frames(3);
  CHECK(o.driver->text("question/1/field") == "about four");
  CHECK(o.driver->app().lesson.session());
  o.driver->click("question/1/check");
  CHECK(o.session().question(1).attempts == 0);
  CHECK(contains(o.driver->text("question/1/feedback/0"), "no number in Å"));
}

TEST_CASE("a free answer breaks its lines at the field's width, and is kept as it was typed") {
  QuestionOpened o;
  const std::string typed =
      "It is where three balls meet and the probe, which is as large as a molecule of water, cannot come any deeper.";
  o.driver->click("question/2/field");
  o.driver->type(typed);
  const std::string shown = o.driver->text("question/2/field");
  CHECK(std::count(shown.begin(), shown.end(), '\n') >= 2);
  CHECK(unbrokenLines(shown) == typed);
  // In the middle, too, what is typed stands where the cursor is.
  for (int k = 0; k < 7; ++k) o.driver->tap("Left");
  o.driver->type("X");
  CHECK(unbrokenLines(o.driver->text("question/2/field")) ==
        typed.substr(0, typed.size() - 7) + "X" + typed.substr(typed.size() - 7));
  o.driver->tap("Escape");
  o.driver->frames(3);
  o.driver->click("question/2/check");
  CHECK(o.session().question(2).written == typed.substr(0, typed.size() - 7) + "X" + typed.substr(typed.size() - 7));
  CHECK(contains(o.driver->text("question/2/feedback/0"), "Kept"));
  CHECK(o.driver->text("question/2/feedback/1") == "Because.");
}

}  // namespace
}  // namespace moltact
