// A class at one device, controlled by a teacher's menus and buttons. Oracle: the students called, and the attempts'
// files.
#include <algorithm>

#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

void touch(ScriptedUser& driver) {
  driver.point("view", 0.5, 0.5);
  driver.press();
  driver.frames(40);
  driver.release();
  driver.frames(10);
}

TEST_CASE(
    "2 students take turns of 30 s: each is called, what each does is kept under the name, those who wait predict") {
  const ScratchFolder scratch;
  ScriptedUser::Options options;
  options.application.attempts_folder = scratch.path;
  const auto driver = startWith(MOLTACT_SOURCE_DIR "/lessons/first-touch.md", options);
  Application& app = driver->app();
  ClassTurns& turns = app.extensions().turns;
  CHECK_FALSE(driver->shows("turns/current"));
  app.panels.pages.turns = true;
  driver->frames(3);
  CHECK(driver->click("turns/names"));
  driver->type("K1");
  driver->tap("Enter");
  driver->type("K2");
  turns.draft.minutes = 0.5;
  driver->frames(2);
  CHECK(driver->click("turns/begin"));
  driver->frames(5);
  CHECK(driver->text("turn/name") == "K1");
  // While the device changes hands nothing is felt.
  CHECK(app.scene.playedHand().on());
  CHECK(driver->click("turn/begin"));
  driver->frames(10);
  CHECK_FALSE(app.scene.playedHand().on());
  CHECK(driver->text("turns/current") == "K1");
  CHECK(contains(driver->text("turns/next"), "K2"));
  touch(*driver);
  CHECK(app.lesson.session()->taskDone(0, 0));

  CHECK(contains(driver->text("turns/prompt"), "What will be felt"));
  CHECK(driver->click("turns/prediction"));
  driver->type("a round wall");
  CHECK(driver->click("turns/keep"));
  CHECK(turns.predictionsKept() == 1);

  // The time runs out.
  driver->frames(31 * 60);
  CHECK(driver->text("turn/name") == "K2");
  CHECK(driver->click("turn/begin"));
  driver->frames(10);
  CHECK_FALSE(app.lesson.session()->taskDone(0, 0));
  touch(*driver);
  CHECK(driver->click("turns/pass"));
  driver->frames(5);
  CHECK(driver->text("turn/name") == "K1");
  CHECK(driver->click("turn/absent"));
  driver->frames(3);
  CHECK(driver->text("turn/name") == "K2");
  CHECK(driver->click("turn/end"));
  driver->frames(5);
  CHECK_FALSE(turns.on());
  CHECK_FALSE(app.scene.playedHand().on());
  CHECK_FALSE(driver->shows("turns/current"));
  REQUIRE(app.extensions().recorder.flush());

  const auto files = attemptFiles(scratch.path);
  REQUIRE(bool(files));
  REQUIRE(files->size() == 2);
  std::size_t predictions = 0;
  std::vector<std::string> students;
  for (const std::filesystem::path& file : *files) {
    const Expected<Attempt> attempt = readAttempt(file);
    REQUIRE(bool(attempt));
    students.push_back(attempt->header.student);
    CHECK(attempt->end_s() < 33.0);
    for (const AttemptEvent& e : attempt->events)
      if (const auto* p = std::get_if<Predicted>(&e.what)) {
        ++predictions;
        CHECK(p->student == "K2");
        CHECK(p->text == "a round wall");
        CHECK(attempt->header.student == "K1");
      }
  }
  std::sort(students.begin(), students.end());
  CHECK(students == std::vector<std::string>{"K1", "K2"});
  CHECK(predictions == 1);
}

}  // namespace
}  // namespace moltact
