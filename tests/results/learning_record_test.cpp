// What a learning platform is told. Oracles: values counted by hand from the sample attempt, and the times of its lines.
#include "engine/results/learning_record.h"

#include <doctest/doctest.h>

#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/results/sample_attempt.h"

namespace moltact {
namespace {

Attempt learningRecordSample() { return {"a.jsonl", sampleHeader(), sampleEvents(), {}, false}; }

using RecordKind = LearningInteraction::Kind;

}  // namespace

TEST_CASE("of 3 scored parts with one first answer wrong the score is 2/3; the goals score 1/1 and 1/2") {
  const LearningRecord r = learningRecord(learningRecordSample());
  CHECK(r.began == "2026-11-21T10:58:14Z");
  CHECK(r.at_s == doctest::Approx(9.5));
  CHECK(r.step == "two");
  CHECK(r.place == "two");
  CHECK(r.done == 3);
  CHECK(r.of == 3);
  CHECK(r.complete());
  REQUIRE(r.score);
  CHECK(*r.score == doctest::Approx(2.0 / 3.0));
  REQUIRE(r.objectives.size() == 2);
  CHECK(r.objectives[0].id == "goal_1");
  CHECK(r.objectives[0].text == "Feel it");
  CHECK(r.objectives[0].of == 1);
  CHECK(*r.objectives[0].score == doctest::Approx(1.0));
  CHECK(r.objectives[1].of == 2);
  CHECK(r.objectives[1].done == 2);
  CHECK(*r.objectives[1].score == doctest::Approx(0.5));
}

TEST_CASE("4 interactions in order of time, with latency, UTC and the misconception of the wrong choice") {
  const LearningRecord r = learningRecord(learningRecordSample());
  REQUIRE(r.interactions.size() == 4);
  const auto& [task, wrong, right, typed] =
      std::tie(r.interactions[0], r.interactions[1], r.interactions[2], r.interactions[3]);
  CHECK(task.id == "task_one_1");
  CHECK(task.kind == RecordKind::Task);
  CHECK(task.text == "Touch it.");
  CHECK(task.right);
  CHECK(task.latency_s == doctest::Approx(3.2));
  CHECK(task.at_utc == "2026-11-21T10:58:17Z");
  CHECK(task.goals == std::vector<std::size_t>{0, 1});
  CHECK(wrong.id == "question_one_which");
  CHECK(wrong.kind == RecordKind::Choice);
  CHECK_FALSE(wrong.right);
  CHECK(wrong.chosen == std::vector<std::size_t>{0});
  CHECK(wrong.right_choices == std::vector<std::size_t>{1});
  CHECK(wrong.misconceptions == std::vector<std::string>{"takes this for that"});
  CHECK(wrong.latency_s == doctest::Approx(4.0));
  CHECK(right.id == wrong.id);
  CHECK(right.right);
  CHECK(right.attempt == 2);
  CHECK(right.misconceptions.empty());
  CHECK(right.latency_s == doctest::Approx(1.0));
  CHECK(typed.kind == RecordKind::Typed);
  CHECK(typed.written == "2.5 Å");
  CHECK(typed.latency_s == doctest::Approx(1.0));
  CHECK(typed.at_utc == "2026-11-21T10:58:23Z");
}

TEST_CASE("after an attempt was continued its times count from the new sitting: 11:05:00 plus 2.5 s gives 11:05:02") {
  Attempt attempt = learningRecordSample();  // continued at 9.5 s
  attempt.events.push_back({12.0, Answered{"two", "how-much", 2, {}, "3", false, InputKind::Keyboard}});
  const LearningInteraction last = learningRecord(attempt).interactions.back();
  CHECK(last.at_utc == "2026-11-21T11:05:02Z");
  CHECK(last.latency_s == doctest::Approx(2.5));  // not the 4 s of use since the answer before
}

TEST_CASE("predictions and free answers have no score, and a skipped step counts only if it was entered") {
  Attempt attempt = learningRecordSample();
  StepOutline& two = attempt.header.lesson.steps[1];
  two.questions[0].kind = AnswerKind::Free;
  CHECK(*learningRecord(attempt).score == doctest::Approx(0.5));
  two.questions[0].kind = AnswerKind::Prediction;
  CHECK(*learningRecord(attempt).score == doctest::Approx(0.5));
  attempt.header.lesson.steps.push_back({"three", "Three", {{"reach", "Once more."}}, {}});
  CHECK(*learningRecord(attempt).score == doctest::Approx(1.0 / 3.0));
  attempt.events.push_back({10.0, OrderChanged{"two", "how-much", "after right", true, {"three"}}});
  CHECK(*learningRecord(attempt).score == doctest::Approx(0.5));
  attempt.events.push_back({11.0, StepEntered{"three"}});
  CHECK(*learningRecord(attempt).score == doctest::Approx(1.0 / 3.0));
  attempt.header.lesson.steps[2].aside = true;
  CHECK(*learningRecord(attempt).score == doctest::Approx(0.5));
}

TEST_CASE("an attempt that has just begun is at the first step, with 0 of 3 parts and a score of 0") {
  Attempt attempt{"a.jsonl", sampleHeader(), {{0.0, StepEntered{"one"}}, {0.0, TaskBegun{"one", 0}}}, {}, false};
  const LearningRecord r = learningRecord(attempt);
  CHECK(r.place == "one/task 1");
  CHECK(r.done == 0);
  CHECK(r.of == 3);
  CHECK_FALSE(r.complete());
  CHECK(*r.score == 0.0);
  CHECK(r.interactions.empty());
}

TEST_CASE("ids are ASCII without blanks, differ where the parts differ, and stay within 250 characters") {
  CHECK(interactionId("für-alle", std::size_t{0}) == "task_f.c3.bcr-alle_1");
  CHECK(interactionId("a_b", "c") == "question_a.5fb_c");
  CHECK(interactionId("a", "b_c") != interactionId("a_b", "c"));
  const std::string words(400, 'x');
  const std::string one = interactionId(words + "1", "q"), other = interactionId(words + "2", "q");
  CHECK(one.size() == kMaxInteractionId);
  CHECK(one != other);
  std::set<std::string> all;
  for (const char* step : {"", "a", "a-b", "ä", "a.b", "task", "1"})
    for (const char* question : {"", "b", "1", "ß"}) {
      all.insert(interactionId(step, question));
      for (const char c : interactionId(step, question)) CHECK((std::isalnum(c) || c == '.' || c == '-' || c == '_'));
    }
  CHECK(all.size() == 28);
}

TEST_CASE("the JSON for the page is ASCII, has all 4 interactions, or those from the second on") {
  Attempt attempt = learningRecordSample();
  attempt.header.lesson.goals[0] = "Fühle \"es\"\n</script>";
  const LearningRecord r = learningRecord(attempt);
  const std::string text = learningRecordJson(r, "[\"ü\"]");
  for (const char c : text) CHECK((c >= 0x20 && c < 0x7f));
  const auto all = nlohmann::json::parse(text);
  CHECK(all["objectives"][0]["text"] == "Fühle \"es\"\n</script>");
  CHECK(all["suspended"] == "[\"ü\"]");
  CHECK(all["interactions"].size() == 4);
  CHECK(all["complete"] == true);
  const auto some = nlohmann::json::parse(learningRecordJson(r, "", 2));
  CHECK(some["interaction_count"] == 4);
  CHECK(some["interactions"].size() == 2);
  CHECK(some["interactions"][0]["attempt"] == 2);
  CHECK(nlohmann::json::parse(learningRecordJson(r, "", 99))["interactions"].empty());
}

}  // namespace moltact
