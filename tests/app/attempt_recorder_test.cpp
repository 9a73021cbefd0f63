// The attempt's file contains what a student does in the window. Oracle: the commands of the script.
#include <algorithm>
#include <filesystem>

#include "app/ui/extensions/extensions.h"
#include "engine/results/class_summary.h"
#include "engine/results/progress.h"
#include "tests/app/scripted_user_fixture.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

ScriptedUser::Options keeping(const fs::path& folder) {
  ScriptedUser::Options options;
  options.width = 900;
  options.height = 560;
  options.application.attempts_folder = folder;
  return options;
}

const std::string kLesson = MOLTACT_SOURCE_DIR "/lessons/first-touch.md";

template <class Fact>
std::vector<const Fact*> all(const Attempt& attempt) {
  std::vector<const Fact*> out;
  for (const AttemptEvent& e : attempt.events)
    if (const auto* fact = std::get_if<Fact>(&e.what)) out.push_back(fact);
  return out;
}

Attempt only(const fs::path& folder) {
  const auto files = attemptFiles(folder);
  REQUIRE(files->size() == 1);
  Expected<Attempt> attempt = readAttempt(files->front());
  REQUIRE(bool(attempt));
  CHECK(attempt->problems.empty());
  CHECK_FALSE(attempt->torn);
  return *std::move(attempt);
}

void push(ScriptedUser& driver, int frames = 40) {
  driver.point("view", 0.5, 0.5);
  driver.press();
  driver.frames(frames);
  driver.release();
  driver.frames(15);
}

TEST_CASE(
    "a lesson that is only viewed leaves no file; a touch, a hint or a step creates one with all "
    "earlier events") {
  const ScratchFolder scratch;
  const auto driver = startWith(kLesson, keeping(scratch.path / "attempts"));
  driver->frames(30);
  driver->app().extensions().recorder.flush();
  CHECK_FALSE(fs::exists(scratch.path / "attempts"));

  push(*driver);
  driver->app().lesson.next();
  driver->frames(10);
  REQUIRE(driver->app().extensions().recorder.flush());
  const Attempt attempt = only(scratch.path / "attempts");
  CHECK(attempt.header.lesson.file == "first-touch.md");
  CHECK(attempt.header.lesson.hash.size() == 16);
  CHECK(attempt.header.gives_force == false);
  CHECK(attempt.file.filename().string().starts_with("first-touch-20"));
  const auto steps = all<StepEntered>(attempt);
  REQUIRE(steps.size() == 2);
  CHECK(steps[0]->step == "five-rings-felt-by-a-tip");
  const auto done = all<TaskDone>(attempt);
  REQUIRE(done.size() >= 1);
  CHECK(done[0]->step == "five-rings-felt-by-a-tip");
  CHECK(done[0]->by == InputKind::Mouse);
  const auto touches = all<TouchEnded>(attempt);
  REQUIRE(touches.size() >= 1);
  // The middle of the middle ring, which six carbons make.
  CHECK(touches[0]->atoms.size() >= 2);
  for (const std::int32_t a : touches[0]->atoms) CHECK((a >= 8 && a <= 13));
  CHECK(touches[0]->peak_N > 0.05);
  CHECK(touches[0]->peak_N < 3.31);
  CHECK(all<StageChanged>(attempt).front()->atoms == 36);
  // The trace is the way that was felt: outside the inflated atoms always, for the SCP.
  std::size_t held = 0;
  for (const HipChunk* chunk : all<HipChunk>(attempt))
    for (const HipSample& s : chunk->samples) held += s.feature != Feature::Free;
  CHECK(held > 10);
}

TEST_CASE("a program that ends in the middle continues where it was: same file, same step, same answers") {
  const ScratchFolder scratch;
  {
    const auto driver = startWith(kLesson, keeping(scratch.path));
    push(*driver);
    driver->app().lesson.next();
    driver->frames(10);
  }
  const Attempt before = only(scratch.path);
  CHECK(std::holds_alternative<SessionClosed>(before.events.back().what));
  const std::vector<LessonProgress> progress = readProgress(scratch.path);
  REQUIRE(progress.size() == 1);
  CHECK(progress[0].canResume());
  CHECK(progress[0].done >= 1);

  const auto driver = startWith("", keeping(scratch.path));
  driver->app().extensions().recorder.resume(kLesson, progress[0].file);
  driver->app().finishLoading();
  driver->frames(10);
  const LessonSession& session = *driver->app().lesson.session();
  CHECK(session.stepIndex() == 1);
  CHECK(session.taskDone(0, 0));
  push(*driver);
  REQUIRE(driver->app().extensions().recorder.flush());
  const Attempt after = only(scratch.path);
  CHECK(after.events.size() > before.events.size());
  CHECK(all<Resumed>(after).size() == 1);
  CHECK(after.end_s() > before.end_s());
  for (std::size_t k = 0; k < before.events.size(); ++k) REQUIRE(lineOf(after.events[k]) == lineOf(before.events[k]));
}

TEST_CASE("a window killed while it presses, and while it is read in, leaves a report right to 1 s") {
  const ScratchFolder scratch;
  const auto driver = startWith(kLesson, keeping(scratch.path));
  AttemptRecorder& recorder = driver->app().extensions().recorder;
  driver->point("view", 0.5, 0.5);
  driver->press();
  driver->frames(40);
  REQUIRE(driver->app().scene.log().touching());
  const double begin_s = driver->app().now_s();
  const auto figures = [&] {
    REQUIRE(recorder.flush());
    fs::copy_file(recorder.file(), scratch.path / "killed", fs::copy_options::overwrite_existing);
    const ClassSummary summary = summarise({*readAttempt(scratch.path / "killed", ReadDepth::NoHipSamples)});
    return summary.lessons.at(0).people.at(0);
  };
  const PersonScore first = figures();
  for (int second = 1; second <= 4; ++second) {
    driver->frames(60);
    const double pressed_s = driver->app().now_s() - begin_s;
    const PersonScore now = figures();
    CHECK(now.touch_s >= pressed_s - 1.0);
    CHECK(now.touch_s <= pressed_s + 1.0);
    CHECK(now.peak_N > 0.1);
  }
  driver->release();
  driver->frames(30);
  const double at_s = driver->app().now_s();
  const PersonScore touched = figures();
  driver->frames(4 * 60);
  const PersonScore after = figures();
  CHECK(after.touches == touched.touches);
  CHECK(after.touch_s == touched.touch_s);
  CHECK(after.time_s - touched.time_s >= driver->app().now_s() - at_s - 1.0);
  CHECK(after.time_s - touched.time_s <= driver->app().now_s() - at_s + 1.0);
  CHECK(first.time_s < after.time_s);
}

TEST_CASE("a full disk is reported once with a remedy, and the lesson continues") {
  const ScratchFolder scratch;
  writeFile(scratch.path / "file", "");
  const auto driver = startWith(kLesson, keeping(scratch.path / "file" / "attempts"));
  push(*driver);
  driver->app().extensions().recorder.flush();
  driver->frames(5);
  const std::vector<Message>& messages = driver->app().messages.all();
  const auto reported = std::count_if(messages.begin(), messages.end(),
                                      [](const Message& m) { return contains(m.text, "not being kept"); });
  CHECK(reported == 1);
  CHECK(driver->app().lesson.session()->taskDone(0, 0));
  driver->app().messages = {};
  push(*driver);
  driver->app().extensions().recorder.flush();
  driver->frames(5);
  CHECK(driver->app().messages.all().empty());
}

TEST_CASE("two students who take turns have an attempt each, and each resumes his own") {
  const ScratchFolder scratch;
  const auto driver = startWith(kLesson, keeping(scratch.path));
  AttemptRecorder& recorder = driver->app().extensions().recorder;
  recorder.passTo("Ana");
  driver->frames(10);
  push(*driver);
  CHECK(driver->app().lesson.session()->taskDone(0, 0));
  recorder.passTo("Bo");
  driver->frames(10);
  CHECK_FALSE(driver->app().lesson.session()->taskDone(0, 0));
  push(*driver);
  driver->app().lesson.next();
  driver->frames(5);
  recorder.passTo("Ana");
  driver->frames(10);
  CHECK(driver->app().lesson.session()->taskDone(0, 0));
  CHECK(driver->app().lesson.session()->stepIndex() == 1);
  push(*driver);
  REQUIRE(recorder.flush());
  const auto files = attemptFiles(scratch.path);
  REQUIRE(files->size() == 2);
  std::vector<std::string> students;
  for (const fs::path& f : *files) students.push_back(readAttempt(f)->header.student);
  std::sort(students.begin(), students.end());
  CHECK(students == std::vector<std::string>{"Ana", "Bo"});
}

}  // namespace
}  // namespace moltact
