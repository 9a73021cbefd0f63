// The state that a learning platform keeps. Oracle: memoryOf() of the whole attempt, and the limits of the standards.
#include "engine/results/suspended.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <random>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/results/learning_link.h"
#include "engine/results/learning_record.h"
#include "engine/results/progress.h"
#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

Attempt suspendedSample() { return {"a.jsonl", sampleHeader(), sampleEvents(), {}, false}; }

// What LessonSession::restore reads, as text.
std::string shown(const SessionMemory& memory) {
  nlohmann::json out = {memory.step};
  for (const SessionMemory::StepMemory& s : memory.steps) {
    nlohmann::json questions = nlohmann::json::array();
    for (const auto& [id, q] : s.questions)
      questions.push_back({id, q.attempts, q.chosen, q.written, q.answered_right, q.last_right, q.left_since_answer});
    out.push_back({s.step, s.tasks_done, s.tasks_shown, questions});
  }
  return out.dump();
}

// Every step entered, every task solved, every question answered wrongly and then rightly.
Attempt wholeAttempt(const LessonOutline& lesson, const std::string& written) {
  Attempt out;
  out.header = sampleHeader();
  out.header.lesson = lesson;
  double t_s = 0.0;
  for (const StepOutline& step : lesson.steps) {
    out.events.push_back({t_s += 1.5, StepEntered{step.id}});
    for (std::size_t k = 0; k < step.tasks.size(); ++k)
      out.events.push_back({t_s += 10.25, TaskDone{step.id, k, 10.25, InputKind::Mouse, {}, k % 3 != 2}});
    for (const QuestionOutline& q : step.questions) {
      const bool typed = q.choices.empty();
      const std::vector<std::size_t> wrong{q.right.empty() || q.right[0] != 0 ? 0u : q.choices.size() - 1};
      out.events.push_back({t_s += 7.0, Answered{step.id, q.id, 1, typed ? std::vector<std::size_t>() : wrong,
                                                 typed ? written : "", false, InputKind::Mouse}});
      out.events.push_back({t_s += 7.0, Answered{step.id, q.id, 2, typed ? std::vector<std::size_t>() : q.right,
                                                 typed ? written + "2" : "", true, InputKind::Mouse}});
    }
  }
  out.events.push_back({t_s, ProgressMade{lesson.steps.back().id, lesson.parts(), lesson.parts()}});
  return out;
}

std::vector<LessonOutline> shippedLessons() {
  std::vector<LessonOutline> out;
  for (const auto& entry : fs::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    if (entry.path().extension() != ".md" || !looksLikeLesson(entry.path())) continue;
    const LessonReading read = readLesson(entry.path());
    REQUIRE(read.lesson);
    out.push_back(outlineOf(*read.lesson, ""));
  }
  REQUIRE(out.size() > 20);
  return out;
}

}  // namespace

TEST_CASE("the sample attempt comes back with the same place, memory, score and progress, in under 300 characters") {
  const Attempt before = suspendedSample();
  const std::string text = suspendedText(before, kSuspendScorm12);
  CHECK(text.size() < 300);
  const Expected<Attempt> after = fromSuspended(text, before.header.lesson);
  REQUIRE(after);
  CHECK(shown(memoryOf(*after)) == shown(memoryOf(before)));
  CHECK(after->header.began == before.header.began);
  CHECK(after->end_s() == doctest::Approx(9.5));
  CHECK(sittingsOf(*after) == 2);
  const LearningRecord a = learningRecord(before), b = learningRecord(*after);
  CHECK(*b.score == doctest::Approx(*a.score));
  CHECK(b.done == 3);
  CHECK(b.complete());
  CHECK(suspendedText(*after, kSuspendScorm12) == text);
}

TEST_CASE("every shipped lesson, finished with two tries at each question, fits 4096 characters whole and comes back") {
  std::size_t longest = 0;
  for (const LessonOutline& lesson : shippedLessons()) {
    CAPTURE(lesson.file);
    const Attempt before = wholeAttempt(lesson, "2.5 Å");
    const std::string text = suspendedText(before, kSuspendScorm12);
    longest = std::max(longest, text.size());
    REQUIRE(text.size() <= 4096);
    for (const char c : text) REQUIRE((c >= 0x20 && c < 0x7f));
    const Expected<Attempt> after = fromSuspended(text, lesson);
    REQUIRE(after);
    CHECK(shown(memoryOf(*after)) == shown(memoryOf(before)));
    CHECK(*learningRecord(*after).score == doctest::Approx(*learningRecord(before).score));
  }
  MESSAGE("the longest text of a shipped lesson has " << longest << " characters");
  CHECK(longest > 500);
}

TEST_CASE(
    "beyond the limit typed answers go first, then choices, then questions, then old steps; the place and progress "
    "stay to the last") {
  LessonOutline lesson{"long.md", "Long", "", {}};
  for (int s = 0; s < 60; ++s) {
    StepOutline step{"step-" + std::to_string(s), "Step", {{"reach", "T"}, {"reach", "U"}, {"reach", "V"}}, {}};
    for (int q = 0; q < 4; ++q) {
      QuestionOutline question{"q" + std::to_string(q), "Q", {"a", "b", "c"}, {2}};
      if (q == 3) question.choices = {}, question.right = {};
      step.questions.push_back(question);
    }
    lesson.steps.push_back(step);
  }
  const Attempt before = wholeAttempt(lesson, std::string(300, 'w') + "ö");
  const std::string whole = suspendedText(before, kLongestSuspended);
  CHECK(whole.size() > 36'000);  // 120 typed answers of 300 characters
  struct Expectation {
    std::size_t limit;
    bool written, chosen, questions, all_steps;
  };
  for (const Expectation& e : {Expectation{kSuspendScorm2004, true, true, true, true},
                               {16'000, false, true, true, true},
                               {6'600, false, false, true, true},
                               {kSuspendScorm12, false, false, false, true},
                               {400, false, false, false, false}}) {
    CAPTURE(e.limit);
    const std::string text = suspendedText(before, e.limit);
    CHECK(text.size() <= e.limit);
    const Expected<Attempt> after = fromSuspended(text, lesson);
    REQUIRE(after);
    const SessionMemory memory = memoryOf(*after);
    CHECK(memory.step == "step-59");
    CHECK((memory.steps.size() == 60) == e.all_steps);
    CHECK(!memory.steps.empty());
    const auto& [step, done, tries_used_up, questions] = memory.steps.back();
    CHECK(done == std::vector<std::size_t>{0, 1});
    CHECK(tries_used_up == std::vector<std::size_t>{2});
    REQUIRE(questions.size() == (e.questions ? 4 : 0));
    if (e.questions) {
      CHECK(questions[0].second.answered_right);
      CHECK(questions[0].second.attempts == 2);
      CHECK(questions[0].second.chosen.empty() != e.chosen);
      CHECK(questions[3].second.written.empty() != e.written);
    }
    CHECK(learningRecord(*after).done == 420);
  }
  CHECK(suspendedText(before, 200).size() > 40);
  CHECK(suspendedText(before, 10).empty());
}

TEST_CASE("a corrected lesson keeps what it still contains: a step that moved is found, one that is gone is left out") {
  const Attempt before = suspendedSample();
  const std::string text = suspendedText(before, kSuspendScorm12);
  LessonOutline moved = before.header.lesson;
  moved.steps.insert(moved.steps.begin(), StepOutline{"zero", "Zero", {}, {}});
  Expected<Attempt> after = fromSuspended(text, moved);
  REQUIRE(after);
  CHECK(shown(memoryOf(*after)) == shown(memoryOf(before)));
  moved.steps.erase(moved.steps.begin() + 1);
  after = fromSuspended(text, moved);
  REQUIRE(after);
  CHECK(memoryOf(*after).step == "two");
  CHECK(memoryOf(*after).steps.size() == 1);
  moved.steps[1].questions[0].id = "how-long";
  after = fromSuspended(text, moved);
  REQUIRE(after);
  CHECK(memoryOf(*after).steps[0].questions.empty());
}

TEST_CASE(
    "damaged texts are refused with a message: 2000 changed and 200 cut ones give no attempt outside its ranges") {
  const Attempt before = suspendedSample();
  const std::string text = suspendedText(before, kSuspendScorm12);
  for (const char* bad : {"", "x", "{}", "[]", "null", "[\"moltact\",2]", R"(["moltact",1,"b",0,1,"0.0",0,1,[],[]])",
                          R"(["moltact",1,"b",1,-1,"0.0",0,1,[],[]])", R"(["moltact",1,"b",1,1e300,"0.0",0,1,[],[]])",
                          R"(["moltact",1,"b",1,1,"0.0",0,1,[1],[]])", R"(["moltact",1,"b",1,1,"0.0",0,1,[],[1]])",
                          R"(["moltact",1,3,1,1,"0.0",0,1,[],[]])"}) {
    CAPTURE(bad);
    const Expected<Attempt> read = fromSuspended(bad, before.header.lesson);
    REQUIRE_FALSE(read);
    CHECK(read.problem().text() ==
          "what the learning platform kept of this lesson is damaged; begin the lesson again; what the platform has "
          "counted stays counted");
  }
  CHECK_FALSE(fromSuspended("[" + std::string(kLongestSuspended, '1') + "]", before.header.lesson));
  CHECK_FALSE(fromSuspended(std::string(200'000, '['), before.header.lesson));
  for (std::size_t cut = 0; cut < std::min<std::size_t>(200, text.size()); ++cut)
    CHECK_FALSE(fromSuspended(text.substr(0, cut), before.header.lesson));
  std::mt19937 random(29);
  std::size_t read = 0;
  for (int run = 0; run < 2000; ++run) {
    std::string changed = text;
    for (int k = 0; k < 1 + run % 3; ++k) changed[random() % changed.size()] = char(32 + random() % 95);
    const Expected<Attempt> after = fromSuspended(changed, before.header.lesson);
    if (!after) continue;
    ++read;
    CHECK(after->end_s() <= 1e8);
    CHECK(sittingsOf(*after) <= 1000);
    for (const AttemptEvent& event : after->events) {
      if (const auto* done = std::get_if<TaskDone>(&event.what)) CHECK(done->task < 1);
      if (const auto* answer = std::get_if<Answered>(&event.what))
        for (const std::size_t c : answer->chosen) CHECK(c < 3);
    }
  }
  CHECK(read > 20);  // a changed digit is not damage
}

TEST_CASE(
    "on another computer the attempt is written from the text; where it is kept at least as far it goes on itself") {
  const ScratchFolder here, there;
  const Attempt before = suspendedSample();
  const LessonOutline& lesson = before.header.lesson;
  const std::string text = suspendedText(before, kSuspendScorm12);
  writeFile(here.path / "own.jsonl", sampleFile());
  AttemptHeader other = sampleHeader();
  other.began = "2026-11-22T08:00:00Z";
  writeFile(here.path / "other.jsonl", lineOf(other) + lineOf(AttemptEvent{100.0, Heartbeat{}}));
  const Expected<fs::path> own = attemptToResume(here.path, text, lesson);
  REQUIRE(own);
  CHECK(*own == here.path / "own.jsonl");

  const Expected<fs::path> restored = attemptToResume(there.path / "attempts", text, lesson);
  REQUIRE(restored);
  const Expected<Attempt> read = readAttempt(*restored);
  REQUIRE(read);
  CHECK(read->problems.empty());
  CHECK(shown(memoryOf(*read)) == shown(memoryOf(before)));
  CHECK(*attemptToResume(there.path / "attempts", text, lesson) == *restored);  // not once more

  // Here the attempt is older than on the platform, so it is written anew beside the old one.
  Attempt farther = before;
  farther.events.push_back({20.0, Answered{"two", "how-much", 2, {}, "3", false, InputKind::Mouse}});
  const Expected<fs::path> newer = attemptToResume(here.path, suspendedText(farther, kSuspendScorm12), lesson);
  REQUIRE(newer);
  CHECK(*newer != *own);
  CHECK(bytesOf(here.path / "own.jsonl") == sampleFile());
  CHECK(readAttempt(*newer)->end_s() == doctest::Approx(20.0));
  CHECK_FALSE(attemptToResume(here.path, "damaged", lesson));
}

TEST_CASE("a growing file is read on from line to line, in the terms of the lesson's other language") {
  const ScratchFolder scratch;
  LessonOutline german = sampleHeader().lesson;
  german.file = "first-touch.de.md";
  german.title = "Erste Berührung";
  german.hash = "de";
  german.steps[0].id = "eins";
  german.steps[0].questions[0].id = "welches";
  AttemptHeader header = sampleHeader();
  header.lesson = german;
  const fs::path file = scratch.path / "a.jsonl";
  GrowingAttempt growing(sampleHeader().lesson);
  CHECK_FALSE(growing.read({}));
  CHECK_FALSE(growing.read(file));
  CHECK(growing.attempt() == nullptr);
  std::string bytes = lineOf(header) + lineOf(AttemptEvent{0.0, StepEntered{"eins"}});
  writeFile(file, bytes);
  CHECK(growing.read(file));
  CHECK_FALSE(growing.read(file));
  CHECK(learningRecord(*growing.attempt()).step == "one");
  const std::string answer =
      lineOf(AttemptEvent{4.0, Answered{"eins", "welches", 1, {0}, "", false, InputKind::Mouse}});
  writeFile(file, bytes + answer.substr(0, 20));  // a line that is being written
  CHECK_FALSE(growing.read(file));
  writeFile(file, bytes + answer);
  CHECK(growing.read(file));
  const LearningRecord r = learningRecord(*growing.attempt());
  REQUIRE(r.interactions.size() == 1);
  CHECK(r.interactions[0].id == "question_one_which");
  CHECK(r.interactions[0].misconceptions == std::vector<std::string>{"takes this for that"});

  header.lesson.file = "another.md";
  header.lesson.title = "Another";
  writeFile(scratch.path / "b.jsonl", lineOf(header) + answer + answer);
  CHECK_FALSE(growing.read(scratch.path / "b.jsonl"));
  CHECK(learningRecord(*growing.attempt()).interactions.size() == 1);
}

}  // namespace moltact
