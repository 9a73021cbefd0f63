// Attempts: as bytes, and as lines of the right form with numbers and texts that no program of ours wrote. What can be
// read of them is then reported and played back.
#include <cmath>

#include "engine/results/attempt_file.h"
#include "engine/results/class_csv.h"
#include "engine/results/class_page.h"
#include "engine/results/class_summary.h"
#include "engine/results/timeline.h"
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
  static const std::vector<AttemptEvent> events = sampleEvents();
  Choices choices(bytes);
  std::string text = lineOf(sampleHeader());
  for (std::size_t n = 1 + choices.pick(24); n > 0; --n) {
    std::string line = lineOf(events[choices.pick(events.size())]);
    for (std::size_t changes = choices.pick(4); changes > 0; --changes) {
      // A number, or what stands between two quotes, becomes another.
      const std::size_t from = choices.pick(line.size()), at = line.find_first_of(":[,", from);
      if (at == std::string::npos || at + 1 >= line.size()) continue;
      const std::size_t end = line.find_first_of(",]}\n", at + 1);
      if (line[at + 1] == '{' || line[at + 1] == '[')
        line.insert(at + 1, line[at + 1] == '[' && choices.pick(2) ? "[" : "");
      else
        line.replace(at + 1, end - at - 1, oddNumber(choices));
    }
    text += line;
  }
  readAndTell(fileOf(text, "a.jsonl"));
}

}  // namespace moltact::fuzz
