// Oracle: the session at the end of the attempt.
#include "engine/results/progress.h"

#include <doctest/doctest.h>

#include "engine/results/class_summary.h"
#include "engine/results/lesson_language.h"
#include "engine/results/session_facts.h"
#include "tests/results/sample_attempt.h"
#include "tests/results/small_lesson.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

TEST_CASE("a session that continues after a shutdown has its step, tasks, answers and attempts as they were") {
  const auto lesson = smallLesson();
  LessonSession before(lesson);
  before.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  SessionFacts facts;
  AttemptHeader header;
  header.began = "2026-11-21T10:58:14Z";
  header.lesson = outlineOf(*lesson, "0");
  std::string file = lineOf(header);
  const auto keep = [&](double t) {
    for (const SessionEvent& e : before.takeEvents()) file += lineOf(facts.factOf(e, t, InputKind::Mouse));
  };
  keep(0);
  touchFor150ms(before, 0, 1.0);
  keep(2);
  before.choose(0, {1});
  keep(3);
  before.choose(0, {0});
  before.next();
  keep(4);
  before.write(0, "9 Å");
  keep(5);

  const ScratchFolder scratch;
  writeFile(scratch.path / "a.jsonl", file);
  const Expected<Attempt> attempt = readAttempt(scratch.path / "a.jsonl", ReadDepth::NoHipSamples);
  REQUIRE(bool(attempt));
  LessonSession after(lesson);
  after.restore(memoryOf(*attempt));
  CHECK(after.stepIndex() == 1);
  CHECK(after.taskDone(0, 0));
  CHECK_FALSE(after.taskDone(0, 1));
  CHECK(after.question(0, 0).answered_right);
  CHECK(after.question(0, 0).attempts == 2);
  CHECK(after.question(0, 0).chosen == std::vector<std::size_t>{0});
  CHECK_FALSE(after.question(0).answered_right);
  CHECK(after.question(0).written == "9 Å");
  CHECK(after.progress() == before.progress());
}

// The small lesson in German: other headings, the same tasks and questions.
std::shared_ptr<const Lesson> smallLessonInGerman() {
  LessonReading read = readLessonText(
      "lessons/small.de.md",
      "---\ntitle: Klein\nminutes: 5\ngoals: G\nmolecules: mix\nauthor: A\nlicence: L\n---\n"
      "## Eins\n```scene\nmolecule: mix\n```\n```touch\nreach: atom 0\nsay: S\npraise: P.\n```\n"
      "```touch\nreach: atom 1\nsay: Dann das.\n```\n"
      "### Question: Welche?\n- [x] ja → Gut\n- [ ] nein → Schlecht\n"
      "## Zwei\n### Question: Wie lang?\n```answer\nnumber: 1.4 Å\ntolerance: 0.1 Å\nwrong: Miss noch einmal.\n```\n"
      "## Drei\nDas Ende.\n");
  REQUIRE(read.lesson);
  return std::make_shared<const Lesson>(*std::move(read.lesson));
}

TEST_CASE(
    "what was done in a lesson in English is done in German too: one entry of two attempts, a task and an answer") {
  const auto english = smallLesson(), german = smallLessonInGerman();
  LessonSession before(english);
  before.setMolecule(std::make_shared<const Molecule>(mixedMolecule()));
  SessionFacts facts;
  AttemptHeader header;
  header.began = "2026-11-21T10:58:14Z";
  header.lesson = outlineOf(*english, "0");
  std::string file = lineOf(header);
  const auto keep = [&](double t) {
    for (const SessionEvent& e : before.takeEvents()) file += lineOf(facts.factOf(e, t, InputKind::Mouse));
  };
  keep(0);
  touchFor150ms(before, 0, 1.0);
  keep(2);
  before.choose(0, {0});
  before.next();
  keep(4);
  file += lineOf(AttemptEvent{4.0, ProgressMade{before.step().id, 2, 4}});
  const ScratchFolder scratch;
  writeFile(scratch.path / "a.jsonl", file);
  AttemptHeader other = header;
  other.lesson = outlineOf(*german, "1");
  writeFile(scratch.path / "b.jsonl", lineOf(other));
  fs::last_write_time(scratch.path / "b.jsonl", fs::last_write_time(scratch.path / "a.jsonl") - std::chrono::hours(1));

  const std::vector<LessonProgress> progress = readProgress(scratch.path);
  REQUIRE(progress.size() == 1);
  CHECK(progress[0].attempts == 2);
  CHECK(progress[0].done == 2);
  CHECK(progress[0].isOf("lessons/small.md", "Small"));
  CHECK(progress[0].isOf("lessons/small.de.md", "Klein"));
  CHECK_FALSE(progress[0].isOf("lessons/other.de.md", "Klein"));
  // Another lesson that happens to have the same file name.
  CHECK_FALSE(progress[0].isOf("lessons/small.md", "Large"));

  const Expected<Attempt> attempt = readAttempt(progress[0].file, ReadDepth::NoHipSamples);
  REQUIRE(bool(attempt));
  LessonSession after(german);
  after.restore(memoryOf(inTermsOf(outlineOf(*german, "1"), *attempt)));
  CHECK(after.step().id == "zwei");
  CHECK(after.taskDone(0, 0));
  CHECK(after.question(0, 0).answered_right);
  // Without the same tasks it is another lesson.
  LessonOutline shorter = outlineOf(*german, "1");
  shorter.steps[0].tasks.pop_back();
  CHECK_FALSE(sameLesson(shorter, header.lesson));

  const ClassSummary summary = summarise({*attempt, *readAttempt(scratch.path / "b.jsonl", ReadDepth::NoHipSamples)});
  CHECK(summary.lessons.size() == 1);
}

TEST_CASE("a memory of another version of the lesson is taken up as far as the lesson still has it") {
  LessonSession session(smallLesson());
  QuestionStatus status;
  status.attempts = 1;
  status.chosen = {0, 17};
  session.restore({"gone", {{"gone", {0}, {}, {}}, {"one", {1, 99}, {}, {{"which", status}, {"what", status}}}}});
  CHECK(session.stepIndex() == 0);
  CHECK(session.taskDone(0, 1));
  CHECK(session.question(0, 0).chosen == std::vector<std::size_t>{0});
}

void writeAttempt(const fs::path& file, const std::string& lesson, const std::string& student, std::size_t done,
                  int age_h, std::size_t hip_lines = 0) {
  AttemptHeader header = sampleHeader();
  header.lesson.file = lesson;
  header.student = student;
  std::string bytes =
      lineOf(header) + lineOf({1, ProgressMade{"one", 0, 3}}) + lineOf({2, ProgressMade{"two", done, 3}});
  for (std::size_t k = 0; k < hip_lines; ++k) bytes += lineOf(sampleEvents()[7]);
  writeFile(file, bytes + "{\"kind\":\"tr");
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(age_h));
}

TEST_CASE(
    "progress of 3 lessons: the last attempt counts, a finished one is remembered, the newest lesson comes first") {
  const ScratchFolder scratch;
  writeAttempt(scratch.path / "a1.jsonl", "a.md", "Ana", 3, 30);
  writeAttempt(scratch.path / "a2.jsonl", "a.md", "Bo", 1, 3, 5000);  // 1.5 MB of HIP samples after the progress
  writeAttempt(scratch.path / "b.jsonl", "b.md", "Ana", 2, 1);
  writeFile(scratch.path / "c.jsonl", lineOf(sampleHeader()));
  fs::last_write_time(scratch.path / "c.jsonl", fs::file_time_type::clock::now() - std::chrono::hours(99));
  writeFile(scratch.path / "broken.jsonl", "nothing\n");
  const std::vector<LessonProgress> all = readProgress(scratch.path);
  REQUIRE(all.size() == 3);
  CHECK(all[0].lesson == "b.md");
  CHECK(all[0].share() == doctest::Approx(2.0 / 3));
  CHECK(all[1].lesson == "a.md");
  CHECK(all[1].student == "Bo");
  CHECK(all[1].attempts == 2);
  CHECK(all[1].finished);
  CHECK(all[1].canResume());
  CHECK(all[1].share() == doctest::Approx(1.0 / 3));
  CHECK(all[1].step_title == "Two");
  CHECK(all[1].file == scratch.path / "a2.jsonl");
  CHECK(all[2].lesson == "first-touch.md");
  CHECK(all[2].share() == 0.0);
  const std::vector<LessonProgress> anas = readProgress(scratch.path, "Ana");
  REQUIRE(anas.size() == 2);
  CHECK(anas[1].share() == 1.0);
  CHECK_FALSE(anas[1].canResume());
  CHECK(readProgress(scratch.path / "none").empty());
  CHECK(readProgress({}).empty());
}

}  // namespace
}  // namespace moltact
