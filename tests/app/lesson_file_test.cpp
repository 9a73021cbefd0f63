// A lesson's file while the lesson is open: it is read again when its author saves it, and its faults are listed.
#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "app/ui/extensions/extensions.h"
#include "engine/results/attempt_file.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/lesson/small_picture.h"

using namespace moltact;

namespace {

namespace fs = std::filesystem;

struct AuthorFolder {
  fs::path folder = fs::temp_directory_path() / ("moltact-lesson-file-" + std::to_string(::getpid()));
  AuthorFolder() { fs::create_directories(folder); }
  ~AuthorFolder() { fs::remove_all(folder); }
  fs::path operator/(const std::string& name) const { return folder / name; }
};

// A file system may keep times by the second: each save is a second later than the one before.
void save(const fs::path& file, const std::string& text) {
  static int saves = 0;
  std::ofstream(file, std::ios::binary) << text;
  fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::seconds(++saves));
}

const std::string kLessonFileHead =
    "---\ntitle: Mine\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\n---\n";
const std::string kOne = "## One\n```scene\nmolecule: argon\n```\nText.\n";
const std::string kTwo = "## Two\nHere.\n### Question: How many?\n- [x] One → Yes.\n- [ ] Two → No.\n";

// Long enough for the file to be looked at, found at rest, checked and taken up.
constexpr int kSeen_frames = 60;

}  // namespace

TEST_CASE("a lesson that is saved again is shown at once, on the same step and with what was answered") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md";
  save(file, kLessonFileHead + kOne + kTwo);
  auto d = startWith(file.string());
  d->click("lesson/next");
  d->frames(3);
  d->app().lesson.session()->choose(0, {0});
  const auto camera = d->app().scene.camera.orientation;
  const auto discontinuities = d->app().scene.servo_settings.discontinuities;
  save(file, kLessonFileHead + kOne + "## Between\nNew.\n" + kTwo + "More text.\n");
  d->frames(kSeen_frames);
  CHECK(d->text("lesson/step") == "Two");
  CHECK(d->text("lesson/place") == "Step 3 of 3");
  CHECK(d->app().lesson.session()->question(0).answered_right);
  CHECK(contains(d->text("message/0"), "Read again: mine.md"));
  // The force starts from zero, and the view is unchanged.
  CHECK(d->app().scene.servo_settings.discontinuities == discontinuities + 1);
  CHECK(d->app().scene.camera.orientation == camera);
  // A mere touch of the file changes nothing.
  save(file, kLessonFileHead + kOne + "## Between\nNew.\n" + kTwo + "More text.\n");
  d->frames(kSeen_frames);
  CHECK(d->app().scene.servo_settings.discontinuities == discontinuities + 1);
}

TEST_CASE("a step that gets another probe is set up again when the lesson is read again") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md";
  save(file, kLessonFileHead + kOne);
  auto d = startWith(file.string());
  save(file, kLessonFileHead + "## One\n```scene\nmolecule: argon\nprobe: 2 Å\n```\nText.\n");
  d->frames(kSeen_frames);
  CHECK(d->app().scene.servo_settings.probe_A == 2.0);
}

TEST_CASE("what is done before and after a lesson is read again stands in one attempt") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md", attempts = scratch / "attempts";
  save(file, kLessonFileHead + kOne + kTwo);
  ScriptedUser::Options options;
  options.application.attempts_folder = attempts;
  {
    auto d = startWith(file.string(), options);
    d->click("lesson/next");
    d->frames(3);
    d->app().lesson.session()->choose(0, {1});
    d->frames(3);
    save(file, kLessonFileHead + kOne + kTwo + "More text.\n");
    d->frames(kSeen_frames);
    REQUIRE(contains(d->text("message/0"), "Read again"));
    d->app().lesson.session()->choose(0, {0});
    d->frames(3);
  }
  const auto files = attemptFiles(attempts);
  REQUIRE(files->size() == 1);
  const Expected<Attempt> attempt = readAttempt(files->front());
  REQUIRE(bool(attempt));
  std::vector<int> tries;
  int reread = 0;
  for (const AttemptEvent& e : attempt->events) {
    if (const auto* a = std::get_if<Answered>(&e.what)) tries.push_back(a->attempt);
    reread += std::holds_alternative<LessonReread>(e.what);
  }
  CHECK(tries == std::vector<int>{1, 2});
  CHECK(reread == 1);
}

TEST_CASE(
    "a probe that a task asked for is the scene's again when the lesson is read again in the middle of the task") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md";
  const std::string task = "```touch\nsame: anywhere\nprobe: 3 Å\ntrials: 2\nfor: 0.2 s\nsay: S\n```\n";
  save(file, kLessonFileHead + kOne + task);
  auto d = startWith(file.string());
  // Whichever of a pair is felt with the other probe.
  for (int k = 0; k < 2 && d->app().scene.servo_settings.probe_A != 3.0; ++k) {
    d->hold("Space");
    d->frames(120);
    d->letGo("Space");
    d->tap("Enter");
    d->frames(5);
    if (d->app().scene.servo_settings.probe_A == 3.0) break;
    d->hold("Space");
    d->frames(120);
    d->letGo("Space");
    d->tap("S");
    d->frames(5);
  }
  REQUIRE(d->app().scene.servo_settings.probe_A == 3.0);
  // The task has been deleted.
  save(file, kLessonFileHead + kOne);
  d->frames(kSeen_frames);
  CHECK(d->app().scene.servo_settings.probe_A == 1.4);
}

TEST_CASE("with errors the last good lesson stays and they are listed with line and remedy, until they are mended") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md";
  save(file, kLessonFileHead + kOne + kTwo);
  auto d = startWith(file.string());
  CHECK_FALSE(d->shows("lesson-problems"));
  save(file, kLessonFileHead + kOne + "```touch\nreech: all\n```\n[x](#nowhere)\n");
  d->frames(kSeen_frames);
  CHECK(d->text("lesson-problems") == "mine.md: 2 problems. You see the last good version");
  CHECK(d->text("lesson/place") == "Step 1 of 2");
  CHECK_FALSE(d->shows("lesson-problem/0"));
  REQUIRE(d->click("lesson-problems/show"));
  d->frames(2);
  CHECK(d->text("lesson-problem/0") == "Line 15: touch has no key 'reech'; did you mean 'reach'?");
  CHECK(d->text("lesson-problem/1") == "Line 17: the link '#nowhere' leads to no step; steps: one");
  save(file, kLessonFileHead + kOne + "```touch\nreach: all\nsay: S\n```\n");
  d->frames(kSeen_frames);
  CHECK_FALSE(d->shows("lesson-problems"));
  CHECK(d->text("lesson/place") == "Step 1 of 1");
}

TEST_CASE(
    "a file that is gone or empty for a second, as while an editor saves, raises nothing; one that "
    "stays gone for 4 s is reported") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md";
  save(file, kLessonFileHead + kOne);
  auto d = startWith(file.string());
  fs::rename(file, scratch / "mine.md~");
  d->frames(60);
  CHECK_FALSE(d->shows("lesson-problems"));
  save(file, "");
  d->frames(60);
  CHECK_FALSE(d->shows("lesson-problems"));
  save(file, kLessonFileHead + kOne + kTwo);
  d->frames(kSeen_frames);
  CHECK_FALSE(d->shows("lesson-problems"));
  CHECK(d->text("lesson/place") == "Step 1 of 2");
  fs::remove(file);
  d->frames(4 * 60);
  CHECK(contains(d->text("lesson-problems"), "mine.md: 1 problem"));
  CHECK(d->text("lesson/place") == "Step 1 of 2");
  save(file, kLessonFileHead + kOne);
  d->frames(kSeen_frames);
  CHECK_FALSE(d->shows("lesson-problems"));
}

TEST_CASE("a lesson that cannot be opened leaves the one that is open, lists why, and opens as soon as it is mended") {
  AuthorFolder scratch;
  const fs::path good = scratch / "good.md", bad = scratch / "bad.md";
  save(good, kLessonFileHead + kOne);
  save(bad, kLessonFileHead + "## Broken\n```scene\nmolecule: argon\n```\nText. [x](#y)\n");
  auto d = startWith(good.string());
  d->run("drop " + bad.string(), "script");
  d->frames(kSeen_frames);
  CHECK(d->text("lesson/step") == "One");
  CHECK(d->text("lesson-problems") == "bad.md cannot be opened: 1 problem");
  save(bad, kLessonFileHead + "## Mended\n```scene\nmolecule: argon\n```\nText.\n");
  d->frames(kSeen_frames);
  CHECK(d->text("lesson/step") == "Mended");
  CHECK_FALSE(d->shows("lesson-problems"));
  d->app().open(scratch / "gone.md");
  d->frames(2);
  CHECK(d->text("lesson-problems") == "gone.md cannot be opened: 1 problem");
  d->app().open(good);
  d->frames(kSeen_frames);
  CHECK_FALSE(d->shows("lesson-problems"));
}

TEST_CASE(
    "a lesson with an empty selection opens and says so; a picture that is put beside it mends it without a save") {
  AuthorFolder scratch;
  const fs::path file = scratch / "mine.md";
  save(file, kLessonFileHead + kOne + "![A ring](ring.png)\n\n```touch\nreach: protein\nsay: S\n```\n");
  auto d = startWith(file.string());
  d->frames(kSeen_frames);
  CHECK(d->text("lesson/step") == "One");
  CHECK(d->text("lesson-problems") == "mine.md: 2 problems");
  save(scratch / "ring.png", kRedPng);
  d->frames(3 * 60);
  CHECK(d->text("lesson-problems") == "mine.md: 1 problem");
  CHECK(d->text("lesson/1") == "Picture: A ring");
}

TEST_CASE("files dropped on the window are opened, molecules too") {
  auto d = startWith("");
  d->app().drop({MOLTACT_SOURCE_DIR "/molecules/benzene.pdb", "other.pdb"});
  d->app().finishLoading();
  d->frames(3);
  CHECK(d->app().scene.molecule().file.filename() == "benzene.pdb");
  CHECK(contains(d->text("message/0"), "Of 2 files the first was opened"));
}

TEST_CASE("what a lesson locks stays as it is set, whatever changes it") {
  AuthorFolder scratch;
  const fs::path file = scratch / "study.md";
  save(file,
       "---\ntitle: Study\nminutes: 1\ngoals: G\nmolecules: argon\nauthor: A\nlicence: L\nlocked: method\n---\n"
       "## One\n```scene\nmolecule: argon\nprobe: 2 Å\nforce: off\npanels: none\nlocked: force, probe, stiffness, "
       "show, panels\n```\nText.\n"
       "## Two\n```scene\nmolecule: argon\n```\nText.\n");
  auto d = startWith(file.string());
  Application& app = d->app();
  CHECK(app.layout().touch.empty());
  app.scene.servo_settings.force_on = true;
  app.scene.servo_settings.probe_A = 1.0;
  app.scene.servo_settings.stiffness_N_per_mm = 1.0;
  useMethod(app.scene, "penalty");
  app.scene.look.shown.set(ViewPart::Cones, true);
  app.panels.tabs.open("methods");
  app.panels.lesson = false;
  d->frames(2);
  CHECK_FALSE(app.scene.servo_settings.force_on);
  CHECK(app.scene.servo_settings.probe_A == 2.0);
  CHECK(app.scene.servo_settings.stiffness_N_per_mm == 0.5);
  CHECK(app.scene.touch().method == "exact");
  CHECK_FALSE(app.scene.look.shown.has(ViewPart::Cones));
  CHECK(app.layout().touch.empty());
  CHECK_FALSE(app.layout().lesson.empty());
  app.lesson.next();
  d->frames(3);
  // The front matter's lock continues; the scene's has ended, and the student's panel is back.
  useMethod(app.scene, "penalty");
  app.scene.servo_settings.probe_A = 1.0;
  d->frames(2);
  CHECK(app.scene.touch().method == "exact");
  CHECK(app.scene.servo_settings.probe_A == 1.0);
  CHECK_FALSE(app.layout().touch.empty());
}

TEST_CASE("an aside has no place in the row of steps, and its only button leads back to the step that linked to it") {
  AuthorFolder scratch;
  const fs::path file = scratch / "aside.md";
  save(file,
       kLessonFileHead +
           "## One\n```scene\nmolecule: argon\n```\nSee [more](#aside-more).\n## Aside: More\nText.\n## Two\nText.\n");
  auto d = startWith(file.string());
  CHECK(d->text("lesson/place") == "Step 1 of 2");
  REQUIRE(d->app().lesson.follow("#aside-more"));
  d->frames(2);
  CHECK(d->text("lesson/place") == "Aside");
  CHECK(d->text("lesson/step") == "More");
  CHECK(d->text("lesson/next") == "Back to the lesson");
  CHECK_FALSE(d->shows("lesson/back"));
  d->click("lesson/next");
  d->frames(2);
  CHECK(d->text("lesson/place") == "Step 1 of 2");
  d->click("lesson/next");
  d->frames(2);
  CHECK(d->text("lesson/place") == "Step 2 of 2");
}

TEST_CASE("two steps with the same molecule, one with its waters, are two scenes: 602 atoms, then 660, then 602") {
  AuthorFolder scratch;
  const fs::path file = scratch / "wet.md";
  save(file,
       "---\ntitle: Wet\nminutes: 1\ngoals: G\nmolecules: 1ubq\nauthor: A\nlicence: L\n---\n"
       "## Dry\n```scene\nmolecule: 1ubq\n```\nText.\n## Wet\n```scene\nwaters: yes\n```\n"
       "```touch\nreach: water\nsay: S\n```\n");
  auto d = startWith(file.string());
  const auto atoms = [&] {
    d->app().finishLoading();
    d->frames(3);
    return d->app().scene.stage().molecule->atoms.size();
  };
  CHECK(atoms() == 602);
  d->click("lesson/next");
  CHECK(atoms() == 660);
  CHECK(d->app().lesson.onStage());
  CHECK(d->app().scene.molecule().reading.waters);
  d->click("lesson/back");
  CHECK(atoms() == 602);
  CHECK(d->app().lesson.onStage());
}
