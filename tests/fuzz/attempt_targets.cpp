// Attempts: arbitrary bytes, and well-formed lines with numbers and texts that the program never writes. Readable ones
// are also reported and played. Attempts as a learning platform keeps them.
#include <cmath>

#include "engine/results/attempt_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"
#include "engine/results/class_summary.h"
#include "engine/results/learning_record.h"
#include "engine/results/progress.h"
#include "engine/results/suspended.h"
#include "engine/results/timeline.h"
#include "tests/fuzz/attempt_maker.h"
#include "tests/fuzz/target.h"
#include "tests/results/sample_attempt.h"

namespace moltact::fuzz {
namespace {

void readAndTell(const std::string& file) {
  auto attempt = readAttempt(file);
  if (!attempt) return mustBe(!attempt.problem().message.empty(), "a message");
  const ClassSummary summary = summarise({*attempt});
  mustBe(!classCsv(summary).empty(), "a table");
  mustBe(!classPage(summary, attempt->problems, "now").empty(), "a page");
  const Timeline timeline(*std::move(attempt));
  mustBe(std::isfinite(timeline.length_s()), "a length that is a number");
  for (int k = 0; k <= 8; ++k)
    if (const auto hand = timeline.hand(timeline.length_s() * k / 8))
      mustBe(finite(hand->hip.A) && finite(hand->force.N), "a hand and a force that are numbers");
}

}  // namespace

void attempt(std::string_view bytes) { readAndTell(fileOf(bytes, "a.jsonl")); }

void attemptLines(std::string_view bytes) {
  Choices choices(bytes);
  readAndTell(fileOf(madeAttempt(choices), "a.jsonl"));
}

void suspended(std::string_view bytes) {
  const LessonOutline lesson = sampleHeader().lesson;
  const Expected<Attempt> attempt = fromSuspended(bytes, lesson);
  if (!attempt) return mustBe(!attempt.problem().message.empty(), "a message");
  const LearningRecord record = learningRecord(*attempt);
  mustBe(std::isfinite(record.at_s) && record.at_s >= 0.0, "a time that is a number");
  mustBe(!record.score || (*record.score >= 0.0 && *record.score <= 1.0), "a score from 0 to 1");
  for (const SessionMemory::StepMemory& step : memoryOf(*attempt).steps)
    mustBe(step.step == "one" || step.step == "two", "a step of the lesson");
  const std::string again = suspendedText(*attempt, kSuspendScorm12);
  mustBe(again.size() <= kSuspendScorm12 && (again.empty() || fromSuspended(again, lesson)), "a text that can be read");
}

}  // namespace moltact::fuzz
