// Every kind of task in the window, on the frames' clock: with the keyboard only, with the mouse only, in the dark.
#include <cmath>

#include "app/ui/extensions/extensions.h"
#include "tests/app/scripted_user_fixture.h"

namespace moltact {
namespace {

constexpr const char* kTasksLesson = MOLTACT_SOURCE_DIR "/tests/app/keyboard_lesson.md";

LessonSession& session(ScriptedUser& d) { return *d.app().lesson.session(); }

/// Holds keys until something is so, at most 6 s of the frames' clock. True when it came to be.
template <class Until>
bool holdUntil(ScriptedUser& d, const char* keys, Until until) {
  d.hold(keys);
  int frames = 0;
  while (!until() && ++frames < 360) d.frames(1);
  d.letGo(keys);
  return until();
}
template <class Until>
bool waitUntil(ScriptedUser& d, Until until) {
  int frames = 0;
  while (!until() && ++frames < 360) d.frames(1);
  return until();
}

auto taskDone(ScriptedUser& d, std::size_t task) {
  return [&d, task] { return session(d).task(task).done; };
}

/// Leaves the surface and enters the next step.
void advanceTo(ScriptedUser& d, const char* id) {
  REQUIRE_MESSAGE(session(d).stepDone(), session(d).step().id);
  d.tap("Alt+Right");
  d.frames(10);
  REQUIRE(session(d).step().id == id);
}

/// Presses the task's button with this key.
void tell(ScriptedUser& d, const char* key) {
  d.frames(36);  // it has been in view for a moment, and nothing was done just before
  d.tap(key);
  d.frames(2);
}

}  // namespace

TEST_CASE("a lesson with every kind of task and question is finished with the keyboard alone") {
  auto d = startWith(kTasksLesson);
  REQUIRE(d->app().lesson.onStage());
  // Reach and press.
  CHECK_FALSE(d->app().lesson.session()->hintsOpen());
  d->tap("H");
  CHECK(d->app().lesson.session()->hintsOpen());
  CHECK(holdUntil(*d, "Space", taskDone(*d, 0)));
  d->hold("Space");
  d->frames(20);
  d->tap("plus");
  d->tap("plus");
  CHECK(waitUntil(*d, taskDone(*d, 1)));
  d->letGo("Space");
  readQuestion(*d, 0);
  d->tap("1");
  CHECK(session(*d).question(0).attempts == 1);
  CHECK_FALSE(session(*d).question(0).answered_right);
  readQuestion(*d, 0);
  d->tap("2");
  CHECK(session(*d).question(0).answered_right);
  readQuestion(*d, 1);
  d->tap("1");
  d->tap("2");
  lookAt(*d, "question/1/check");
  d->tap("Enter");
  CHECK(session(*d).question(1).answered_right);
  lookAt(*d, "question/2");
  lookAt(*d, "question/2/field");
  d->tap("A");
  d->frames(3);
  d->type("3.8");
  d->tap("Enter");
  CHECK(session(*d).question(2).written == "3.8");
  CHECK(session(*d).question(2).answered_right);

  // Hold the crease, which lies under the hand; slide to one atom and over to the other; feel both kinds of place.
  advanceTo(*d, "hold-and-cross");
  CHECK(holdUntil(*d, "Space", taskDone(*d, 0)));
  d->frames(10);
  const auto cross = [&](const char* first, const char* second) {
    d->hold(first);
    d->frames(50);
    d->letGo(first);
    d->hold("Space");
    d->frames(40);
    const bool done = holdUntil(*d, second, taskDone(*d, 1));
    d->letGo("Space");
    return done;
  };
  CHECK(cross("Left", "Right"));
  CHECK(holdUntil(*d, "Space", [&] { return session(*d).task(2).progress > 0.4; }));
  if (!session(*d).task(2).done) {
    d->hold("Left");
    d->frames(40);
    d->letGo("Left");
    holdUntil(*d, "Space", [&] { return session(*d).task(2).done || d->app().scene.log().force_N() > 1.5; });
  }
  if (!session(*d).task(2).done) {
    d->tap("Home");
    holdUntil(*d, "Space", taskDone(*d, 2));
  }
  CHECK(session(*d).task(2).done);

  // Off the left atom; then one atom after the other.
  advanceTo(*d, "avoid-and-compare");
  d->hold("Right");
  d->frames(40);
  d->letGo("Right");
  CHECK(holdUntil(*d, "Space", taskDone(*d, 0)));
  CHECK(holdUntil(*d, "Space", [&] { return session(*d).task(1).progress > 0.49; }));
  d->frames(5);
  d->hold("Left");
  d->frames(90);
  d->letGo("Left");
  CHECK(holdUntil(*d, "Space", taskDone(*d, 1)));

  // Along the crease: pressing on while the molecule is turned under the hand.
  advanceTo(*d, "trace");
  d->hold("Space");
  d->frames(60);
  REQUIRE(d->app().scene.log().latest().contact.feature == Feature::Circle);
  CHECK(holdUntil(*d, "Ctrl+Up", [&] { return session(*d).task(0).done; }));
  CHECK(d->app().scene.controls.pressing());
  d->letGo("Space");

  // In the dark.
  advanceTo(*d, "find");
  CHECK(d->app().extensions().task_stager.dark());
  CHECK(d->shows("view/dark"));
  CHECK(d->text("view/state") == "not touching");
  d->frames(36);
  d->tap("L");
  d->frames(3);
  CHECK_FALSE(d->shows("view/dark"));
  d->frames(36);
  d->tap("L");
  d->frames(3);
  CHECK(d->shows("view/dark"));
  d->hold("Left");
  d->frames(60);
  d->letGo("Left");
  d->hold("Space");
  d->frames(60);
  CHECK(contains(d->text("view/state"), "touching"));
  CHECK_FALSE(contains(d->text("view/state"), "argon"));
  // A hand led to the left of the pair is pushed that way, and toward the person.
  CHECK(contains(d->text("view/push"), "pushed"));
  CHECK_FALSE(contains(d->text("view/push"), "right"));
  tell(*d, "Enter");
  CHECK(session(*d).task(0).done);
  d->letGo("Space");
  d->frames(3);
  CHECK_FALSE(d->shows("view/dark"));
  // Once visible, the probe's path is shown, before and after the look, up to its end.
  const auto& trail = d->app().extensions().touch_paint.trail();
  REQUIRE(trail);
  double length_A = 0.0;
  for (const std::vector<PointA>& piece : trail->trail)
    for (std::size_t k = 1; k < piece.size(); ++k) length_A += glm::distance(piece[k].A, piece[k - 1].A);
  CHECK(length_A > 2.0);

  // A curve by the arrows, which then lead the probe again.
  advanceTo(*d, "predict");
  CHECK_FALSE(d->app().extensions().touch_paint.trail());
  const PointA hand = d->app().scene.controls.lead();
  for (int k = 0; k < 10; ++k) d->tap("Up");
  d->hold("Right");
  d->frames(90);
  d->letGo("Right");
  CHECK(glm::distance(d->app().scene.controls.lead().A, hand.A) < 1e-6);
  CHECK(d->text("task/0/curve") == "drawing");
  tell(*d, "Enter");
  const Task* predict = session(*d).taskAt(0);
  REQUIRE_FALSE(predict->curves()->drawing);
  CHECK(predict->curves()->drawn.front() == doctest::Approx(10 * 0.025 * 3.3));
  // A held press rests at 0.6 N; plus leads it deeper, notch by notch.
  d->hold("Space");
  d->frames(60);
  CHECK_FALSE(session(*d).task(0).done);
  for (int k = 0; k < 20 && !session(*d).task(0).done; ++k) {
    d->tap("plus");
    d->frames(6);
  }
  d->letGo("Space");
  CHECK(session(*d).task(0).done);
  CHECK(contains(d->text("task/0/curve"), "\u00a0%"));

  // Same or different: distinguished by the meter, 0.1 N/mm against 0.5 N/mm.
  advanceTo(*d, "same-or-different");
  for (int pair = 0; pair < 2 && !session(*d).task(0).done; ++pair) {
    bool soft[2] = {};
    for (int k = 0; k < 2; ++k) {
      CHECK(d->shows("view/dark"));
      d->hold("Space");
      CHECK(waitUntil(*d, [&] { return !session(*d).taskAt(0)->buttons().empty(); }));
      d->frames(60);
      // The hand presses equally deep on both, and the meter shows a fifth of the force.
      soft[k] = d->app().scene.log().force_N() < 0.3;
      // Two answers are offered once both are felt. A stylus's second button then gives one of them and is no clutch.
      CHECK(d->app().extensions().task_stager.takesSecondButton() == (k == 1));
      if (k == 0) tell(*d, "Enter");
      d->letGo("Space");
      d->frames(2);
    }
    tell(*d, soft[0] == soft[1] ? "S" : "D");
  }
  CHECK(session(*d).task(0).done);
  CHECK(contains(session(*d).task(0).sentence, "2 of 2 right"));
  d->frames(3);
  CHECK(d->app().scene.servo_settings.stiffness_N_per_mm == 0.5);

  // Other methods, and a free answer.
  advanceTo(*d, "methods");
  CHECK(d->app().scene.touch().method == "mesh80");
  d->hold("Right");
  d->frames(50);
  d->letGo("Right");
  d->hold("Space");
  d->frames(60);
  for (int k = 0; k < 5; ++k) d->tap("plus");
  CHECK(holdUntil(*d, "Right", [&] { return session(*d).task(0).done || !d->app().scene.log().touching(); }));
  if (!session(*d).task(0).done) holdUntil(*d, "Left", taskDone(*d, 0));
  CHECK(session(*d).task(0).done);
  d->letGo("Space");
  d->tap("Home");
  d->hold("Space");
  for (int k = 0; k < 20 && !session(*d).task(1).done; ++k) {
    d->tap("M");
    if (d->app().scene.touch().method == "exact" || d->app().scene.touch().method == "paper") d->frames(60);
  }
  d->letGo("Space");
  CHECK(session(*d).task(1).done);
  d->tap("A");
  d->frames(3);
  d->type("jerks");
  d->tap("Ctrl+Enter");
  CHECK(session(*d).question(0).written == "jerks");
  CHECK(session(*d).finished());
  CHECK(d->missing().empty());
}

TEST_CASE("a curve is drawn with the mouse, holes and ends are filled, and wiping begins again") {
  auto d = startWith(kTasksLesson);
  REQUIRE(session(*d).goTo("predict"));
  d->frames(10);
  CHECK(d->text("task/0/curve") == "empty");
  d->drag("task/0/curve", 60, -30);
  CHECK(d->text("task/0/curve") == "drawing");
  d->click("task/0/wipe");
  CHECK(d->text("task/0/curve") == "empty");
  d->drag("task/0/curve", 60, 0);
  d->click("task/0/hand in");
  const TaskCurves& curves = *session(*d).taskAt(0)->curves();
  REQUIRE_FALSE(curves.drawing);
  // Begun in the middle of the area: half of the force axis, everywhere.
  for (const double force_N : curves.drawn) CHECK(force_N == doctest::Approx(0.5 * curves.max_N).epsilon(0.02));
}

TEST_CASE("with the mouse alone a place is found in the dark and a pair is judged") {
  auto d = startWith(kTasksLesson);
  REQUIRE(session(*d).goTo("find"));
  d->frames(10);
  CHECK(d->shows("hidden in the dark"));
  CHECK_FALSE(d->shows("probe"));
  CHECK_FALSE(d->shows("task/0/here"));
  d->point("view", 0.38, 0.5);
  d->press();
  d->frames(60);
  REQUIRE(d->app().scene.log().touching());
  d->release();
  // The place touched last counts, because the mouse has to let go before clicking.
  CHECK(d->click("task/0/here"));
  CHECK(session(*d).task(0).done);

  REQUIRE(session(*d).goTo("same-or-different"));
  d->frames(10);
  for (const char* button : {"task/0/next", "task/0/different"}) {
    // The device page does not reveal which of the two it is.
    d->tap("Ctrl+D");
    d->frames(3);
    CHECK(contains(d->text("device/scale"), "\u00a0Å there."));
    CHECK_FALSE(contains(d->text("device/scale"), "pN"));
    CHECK_FALSE(d->shows("device/scale reason"));
    d->tap("Escape");
    d->frames(3);
    d->point("view");
    d->press();
    CHECK(waitUntil(*d, [&] { return !session(*d).taskAt(0)->buttons().empty(); }));
    d->release();
    CHECK(d->click(button));
  }
  CHECK(session(*d).task(0).progress == doctest::Approx(0.5));
}

TEST_CASE("atoms that one of two things is without are not felt there, and are again when the task is left half done") {
  Scratch scratch;
  const std::string front = argonLesson("Gone", "  - Feel it\n", "");
  std::string text = front.substr(0, front.find("## One step")) +
                     "## Before\n\n```scene\nmolecule: argon-pair\n```\n\nThere.\n\n## Dark\n\n"
                     "```touch\nsame: anywhere\nremove: atom 1\ntrials: 20\nfor: 0.2 s\nsay: Feel.\n```\n";
  text.replace(text.find("  - argon\n"), 10, "  - argon-pair\n");
  auto d = startWith(scratch.file("gone.md", text).string());
  REQUIRE(session(*d).goTo("dark"));
  d->frames(10);
  const auto unfelt = [&] { return d->app().scene.stage().spheres->untouchable(); };
  int with = 0, without = 0;
  for (int k = 0; k < 40 && (with < 3 || without < 3); ++k) {
    const std::vector<std::uint32_t> removed = session(*d).taskStage().removed;
    CHECK(unfelt() == removed);
    (removed.empty() ? with : without) += 1;
    d->hold("Space");
    REQUIRE(waitUntil(*d, [&] { return !session(*d).taskAt(0)->buttons().empty(); }));
    d->letGo("Space");
    tell(*d, k % 2 == 0 ? "Enter" : "S");
  }
  CHECK(with >= 3);
  CHECK(without >= 3);
  for (int k = 0; k < 40 && unfelt().empty(); ++k) {
    d->hold("Space");
    waitUntil(*d, [&] { return !session(*d).taskAt(0)->buttons().empty(); });
    d->letGo("Space");
    tell(*d, session(*d).taskAt(0)->buttons().size() == 1 ? "Enter" : "S");
  }
  CHECK(unfelt() == std::vector<std::uint32_t>{1});
  REQUIRE(session(*d).goTo("before"));
  d->frames(10);
  CHECK(unfelt().empty());
}

TEST_CASE("the scene is the lesson's again when a task that changed it is left half done") {
  auto d = startWith(kTasksLesson);
  REQUIRE(session(*d).goTo("same-or-different"));
  d->frames(10);
  CHECK(d->shows("view/dark"));
  for (int k = 0; k < 2; ++k) {
    d->hold("Space");
    waitUntil(*d, [&] { return !session(*d).taskAt(0)->buttons().empty(); });
    d->letGo("Space");
    tell(*d, k == 0 ? "Enter" : "S");
  }
  d->tap("Alt+Left");
  d->frames(10);
  CHECK_FALSE(d->shows("view/dark"));
  CHECK(d->app().scene.servo_settings.stiffness_N_per_mm == 0.5);
}

}  // namespace moltact
