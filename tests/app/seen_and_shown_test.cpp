// Keys that act only on what has been seen, the closing page of a lesson, and a molecule that is shown after it was
// felt policy.
#include <algorithm>
#include <fstream>
#include <sstream>

#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/seen_parts.h"
#include "engine/lesson/selection.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

LessonSession& session(ScriptedUser& d) { return *d.app().lesson.session(); }

std::unique_ptr<ScriptedUser> firstTouchAt(const char* step, bool gliding = false, int height = 800) {
  ScriptedUser::Options options;
  options.height = height;
  auto d = startWith(MOLTACT_SOURCE_DIR "/lessons/first-touch.md", std::move(options));
  d->app().settings.reduced_motion = !gliding;
  REQUIRE(session(*d).goTo(step));
  d->frames(5);
  d->app().finishLoading();
  d->frames(20);
  return d;
}

// The share of pixels that differ in the middle of the view, where no words stand.
double differenceIn(const Rectangle& view, const Picture& a, const Picture& b) {
  const glm::vec2 low = view.low + 0.3f * view.size(), high = view.low + 0.7f * view.size();
  std::size_t differ = 0, all = 0;
  for (auto y = std::size_t(low.y); y < std::size_t(high.y); ++y)
    for (auto x = std::size_t(low.x); x < std::size_t(high.x); ++x) {
      const std::size_t at = 3 * (y * std::size_t(a.width_px) + x);
      differ += !std::equal(&a.rgb[at], &a.rgb[at] + 3, &b.rgb[at]);
      ++all;
    }
  return double(differ) / double(all);
}

// Presses in the middle of the view by keys for this time and returns which of the four groups was there.
std::string feelInTheMiddle(ScriptedUser& d, double time_s) {
  d.hold("Space");
  std::string group;
  for (int k = 0; k < int(time_s * 60.0); ++k) {
    d.frames(1);
    const std::int32_t atom = d.app().scene.log().latest().contact.atoms[0];
    const Molecule& molecule = *d.app().scene.stage().molecule;
    for (const char* name : {"A", "B", "C", "D"}) {
      const auto atoms = parseSelection(std::string("chain ") + name)->select(molecule);
      if (std::find(atoms.begin(), atoms.end(), std::uint32_t(atom)) != atoms.end()) group = name;
    }
  }
  d.letGo("Space");
  d.frames(20);
  return group;
}

}  // namespace

TEST_CASE(
    "a part counts as seen after 0.3 s wholly in view without a break, and as much as the view holds of a tall one") {
  SeenParts seen;
  const SeenParts::Span view{0, 100};
  double now_s = 10.0;
  int frame = 0;
  const auto frames = [&](int n, SeenParts::Span part) {
    for (int k = 0; k < n; ++k) seen.note("a", part, view, ++frame, now_s += 1.0 / 60.0);
  };
  frames(18, {20, 40});
  CHECK_FALSE(seen.now("a", now_s));
  frames(3, {20, 40});
  CHECK(seen.now("a", now_s));
  CHECK(seen.ever("a"));
  frames(1, {90, 110});
  CHECK_FALSE(seen.now("a", now_s));
  CHECK(seen.ever("a"));
  frames(10, {20, 40});
  frame += 5;  // it was not drawn
  frames(10, {20, 40});
  CHECK_FALSE(seen.now("a", now_s));
  seen.clear();
  frames(21, {-50, 250});
  CHECK(seen.now("a", now_s));
  CHECK_FALSE(seen.now("b", now_s));
}

TEST_CASE("four keys in a row put the four groups of First touch in order and do not answer the question below") {
  auto d = firstTouchAt("eyes-closed", false, 600);
  REQUIRE(session(*d).currentTask() == 0);
  std::vector<std::string> groups;
  for (int place = 0; place < 4; ++place) {
    groups.push_back(feelInTheMiddle(*d, 3.0));
    lookAt(*d, "task/0/next");
    d->tap("Enter");
    d->frames(5);
  }
  REQUIRE(d->shows("task/0/place-1"));
  lookAt(*d, "task/0/place-4");
  for (const std::string group : {"A", "B", "C", "D"}) {
    const auto place = std::find(groups.begin(), groups.end(), group) - groups.begin();
    REQUIRE(place < 4);
    d->tap(std::to_string(place + 1));
    d->frames(4);
  }
  CHECK(session(*d).task(0).solved);
  d->frames(30);
  CHECK(session(*d).question(0).attempts == 0);
}

TEST_CASE(
    "a digit for a question 40 lines below brings it into view and does not answer; nor does one 0.05 s later, but one "
    "0.5 s later") {
  const ScratchFolder scratch;
  std::string lines;
  for (int k = 0; k < 40; ++k) lines += "A line of text that takes its room, number " + std::to_string(k) + ".\n\n";
  writeFile(scratch.path / "below.md",
            argonLesson("Below", "  - G\n", lines + "### Question: Which?\n\n1. [ ] This → No.\n2. [x] That → Yes.\n"));
  auto d = startWith((scratch.path / "below.md").string());
  d->frames(60);
  REQUIRE_FALSE(d->shows("question/0/1"));
  d->tap("2");
  d->frames(3);
  CHECK(session(*d).question(0).attempts == 0);
  CHECK(d->shows("question/0/1"));
  d->tap("2");
  d->frames(1);
  CHECK(session(*d).question(0).attempts == 0);
  d->frames(30);
  d->tap("2");
  CHECK(session(*d).question(0).attempts == 1);
}

TEST_CASE(
    "a key that completes something is swallowed for 0.5 s: a second question under it takes the key after that") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "two.md", argonLesson("Two", "  - G\n",
                                                 "### Question: One?\n\n1. [x] This → Yes.\n2. [ ] That → No.\n\n"
                                                 "### Question: Two?\n\n1. [x] This → Yes.\n2. [ ] That → No.\n"));
  auto d = startWith((scratch.path / "two.md").string());
  d->frames(30);
  d->tap("1");
  CHECK(session(*d).question(0).answered_right);
  d->tap("2");
  d->frames(20);
  d->tap("2");
  CHECK(session(*d).question(1).attempts == 0);
  d->frames(20);
  d->tap("2");
  CHECK(session(*d).question(1).attempts == 1);
}

TEST_CASE(
    "at the last step Next leads to a closing page though nothing was done: its 3 steps are left, each card leads to "
    "its "
    "task, and Back returns") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "left.md",
            "---\ntitle: Left\nminutes: 5\ngoals:\n  - First goal\n  - Second goal\nmolecules: argon\nauthor: A\n"
            "licence: L\n---\n## One\n```scene\nmolecule: argon\n```\n### Prediction: What will it be?\n"
            "1. [x] Round → Yes.\n2. [ ] Flat → No.\n```answer\ngoal: 1\n```\n"
            "```touch\nreach: all\nsay: Touch the ball.\ngoal: 1\n```\n"
            "## Two\n### Question: How many?\n1. [x] One → Yes.\n2. [ ] Two → No.\n```answer\ngoal: 2\n```\n"
            "## Three\nText.\n```touch\npress: all\nuntil: 1 N\nsay: Press it.\n```\n");
  auto d = startWith((scratch.path / "left.md").string());
  for (int k = 0; k < 3; ++k) {
    CAPTURE(d->text("lesson/next"));
    REQUIRE(d->click("lesson/next"));
    d->frames(5);
  }
  CHECK(d->app().lesson.closing());
  CHECK(contains(d->text("lesson/end"), "Nothing of this lesson is done yet"));
  CHECK(d->text("lesson/end/left/0") == "What will it be?");
  CHECK(d->text("lesson/end/left/1") == "Touch the ball.");
  CHECK(d->text("lesson/end/left/2") == "How many?");
  CHECK(d->text("lesson/end/left/3") == "Press it.");
  CHECK_FALSE(widgets().find("lesson/end/left/4"));
  CHECK(d->text("lesson/end/goal/0/part") == "0 of 2 done");
  CHECK(d->text("lesson/end/goal/1/part") == "0 of 1 done");
  CHECK(d->click("lesson/back"));
  d->frames(5);
  CHECK_FALSE(d->app().lesson.closing());
  CHECK(d->text("lesson/step") == "Three");
  d->tap("Alt+Right");
  d->frames(5);
  REQUIRE(d->app().lesson.closing());
  REQUIRE(d->click("lesson/end/left/1"));
  d->frames(5);
  CHECK(d->text("lesson/step") == "One");
  CHECK(d->shows("task/0"));
  // A wrong prediction stands beside what was felt, and a goal whose work is done has no more to do.
  REQUIRE(d->click("question/0/1"));
  d->point("view");
  d->press();
  d->frames(60);
  d->release();
  d->frames(10);
  REQUIRE(session(*d).task(0).done);
  for (int k = 0; k < 3; ++k) {
    d->tap("Alt+Right");
    d->frames(5);
  }
  REQUIRE(d->app().lesson.closing());
  CHECK(contains(d->text("lesson/end"), "2 of 4"));
  CHECK(d->text("lesson/end/prediction/0/0/expected") == "You expected: Flat");
  CHECK(d->text("lesson/end/prediction/0/0/felt") == "You felt: Round");
  CHECK_FALSE(widgets().find("lesson/end/goal/0/part"));
  CHECK(widgets().find("lesson/end/goal/1/part"));
  CHECK(d->text("lesson/end/left/0") == "How many?");
}

TEST_CASE(
    "a molecule that is not drawn fades in within 1 s, with the way of the hand on it, once the task and the question "
    "about it are done, and not before") {
  auto d = firstTouchAt("a-molecule-that-you-cannot-see", true);
  const RevealPolicy& policy = d->app().extensions().reveal_policy;
  const Rectangle view = d->app().layout().view;
  REQUIRE(d->app().scene.look.drawsNothing());
  CHECK(policy.all());
  d->point("view", 0.1, 0.1);
  d->frames(60);
  const Picture before = d->picture();
  // The hand moves over it and answers.
  d->point("view", 0.48, 0.5);
  d->press();
  d->frames(60);
  for (int k = 0; k < 40; ++k) d->point("view", 0.48 + 0.001 * k, 0.5);
  d->release();
  d->frames(30);
  const auto forget = [&](bool task, bool question) {
    SessionMemory memory{.step = session(*d).step().id, .steps = {{.step = session(*d).step().id}}};
    if (task) memory.steps[0].tasks_done = {0};
    if (question) {
      QuestionStatus status;
      status.answered_right = status.last_right = true;
      status.attempts = 1;
      status.chosen = {3};
      memory.steps[0].questions = {{session(*d).step().questions[0].id, status}};
    }
    session(*d).restore(memory);
  };
  forget(true, false);
  d->frames(90);
  CHECK(d->app().scene.look.drawsNothing());
  d->point("view", 0.1, 0.1);
  d->frames(60);
  CHECK(differenceIn(view, before, d->picture()) == 0.0);
  session(*d).choose(0, {3});
  REQUIRE(session(*d).question(0).answered_right);
  d->frames(2);
  CHECK_FALSE(d->app().scene.look.drawsNothing());
  CHECK_FALSE(policy.all());
  CHECK(policy.veil() > 0.9);
  REQUIRE(d->app().extensions().touch_paint.trail());
  CHECK(d->app().extensions().touch_paint.trail()->trail.size() >= 1);
  d->frames(30);
  CHECK(policy.veil() > 0.4);
  CHECK(policy.veil() < 0.6);
  d->frames(40);
  CHECK(policy.veil() == 0.0);
  CHECK(differenceIn(view, before, d->picture()) > 0.2);
}

TEST_CASE("with reduced motion the molecule is shown at once; begun again, its task is done unseen again") {
  auto d = firstTouchAt("a-molecule-that-you-cannot-see");
  SessionMemory memory{.step = session(*d).step().id, .steps = {{.step = session(*d).step().id, .tasks_done = {0}}}};
  session(*d).restore(memory);
  session(*d).choose(0, {3});
  d->frames(3);
  CHECK(d->app().extensions().reveal_policy.veil() == 0.0);
  CHECK_FALSE(d->app().scene.look.drawsNothing());
  session(*d).restartTask(0);
  d->frames(3);
  CHECK(d->app().scene.look.drawsNothing());
  CHECK(d->app().extensions().reveal_policy.all());
}

TEST_CASE(
    "while a task in the dark follows on another nothing is shown; after the last the ground of the dark fades for 1 "
    "s, "
    "and the way stands on the molecule") {
  auto d = firstTouchAt("eyes-closed", true);
  const RevealPolicy& policy = d->app().extensions().reveal_policy;
  CHECK(policy.all());
  feelInTheMiddle(*d, 2.5);
  // The first is done, the second is dark as well.
  SessionMemory memory{.step = "eyes-closed", .steps = {{.step = "eyes-closed", .tasks_done = {0}}}};
  session(*d).restore(memory);
  d->frames(20);
  CHECK(policy.all());
  CHECK(policy.veil() == 0.0);
  CHECK(d->shows("view/dark"));
  feelInTheMiddle(*d, 1.5);
  memory.steps[0].tasks_done = {0, 1};
  session(*d).restore(memory);
  d->frames(2);
  CHECK_FALSE(d->shows("view/dark"));
  CHECK(policy.veilIsDark());
  CHECK(policy.veil() > 0.9);
  const Picture first = d->picture();
  d->frames(70);
  CHECK(policy.veil() == 0.0);
  REQUIRE(d->app().extensions().touch_paint.trail());
  CHECK(difference(first, d->picture()) > 0.02);
}

TEST_CASE("in the dark the state text says touching, the force and the direction of its push, and no kind of place") {
  const ScratchFolder scratch;
  auto d = firstTouchAt("eyes-closed");
  const auto file = scratch.path / "state.txt";
  REQUIRE_FALSE(d->app().extensions().state_text.writeTo(file));
  feelInTheMiddle(*d, 3.0);
  d->frames(120);
  std::ifstream in(file);
  std::stringstream all;
  all << in.rdbuf();
  const std::string lines = all.str();
  CAPTURE(lines);
  CHECK(contains(lines, "touching, 0."));
  CHECK(contains(lines, ", pushed toward you\n"));
  for (const char* word : {"pit", "crease", "face", "argon"})
    CHECK_FALSE(contains(lines, std::string("touching a ") + word));
}

}  // namespace moltact
