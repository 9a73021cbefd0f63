// Reads a question's answer block: the right answer, and the effects of answers on the order of steps.
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/suggestion.h"

namespace moltact::reading {
namespace {

constexpr std::string_view kAfter = "after ", kWrong = " wrong";

// The remedy for another way to write a condition.
std::string conditionMeant(std::string_view key) {
  if (!key.starts_with("if ") && !key.starts_with("after ")) return {};
  return tr("write 'if right: …', 'if right at first: …' or 'after 2 wrong: …'");
}

void readRules(Reading& reading, const KeyValues& values, Question& question) {
  for (const auto& [key, value] : values) {
    StepRule rule;
    if (key == "if right") {
      rule.when = StepRule::When::Right;
    } else if (key == "if right at first") {
      rule.when = StepRule::When::RightAtFirst;
    } else if (key.starts_with(kAfter) && key.ends_with(kWrong)) {
      const std::string_view count =
          stripped(std::string_view(key).substr(kAfter.size(), key.size() - kAfter.size() - kWrong.size()));
      const auto number = parseNumber(count);
      if (!number || *number < 1.0 || *number > 20.0 || *number != std::floor(*number)) {
        reading.error({value.place.line, 1}, trf("'{0}' is no number of wrong answers", count),
                      tr("write a whole number from 1 to 20, as in 'after 2 wrong: go to …'"));
        continue;
      }
      rule.when = StepRule::When::Wrong;
      rule.wrong = static_cast<int>(*number);
    } else {
      continue;
    }
    rule.then = value.skips ? StepRule::Then::Skip : StepRule::Then::GoTo;
    rule.steps = value.words;
    rule.step_places = value.places;
    rule.place = value.place;
    question.rules.push_back(std::move(rule));
  }
  std::sort(question.rules.begin(), question.rules.end(),
            [](const StepRule& a, const StepRule& b) { return a.place.line < b.place.line; });
}

void readWhatIsRight(Reading& reading, const KeyValues& values, const MarkdownBlock& block, Question& question) {
  const int given = values.has("number") + values.has("text") + values.has("free");
  if (values.has("tolerance") && !values.has("number"))
    reading.error(values["tolerance"].place, tr("'tolerance' goes with 'number'"), tr("take it out"));
  if (values.has("model") && !values.has("free"))
    reading.error(values["model"].place, tr("'model' goes with 'free'"),
                  tr("take it out, or say it in 'right' and 'wrong'"));
  if (given > 1) {
    reading.error(block.place, tr("the answer block asks for more than one thing"),
                  tr("give one of 'number: …', 'text: …' and 'free: yes'"));
    question.answer.emplace();  // suppresses further messages about it
    return;
  }
  for (const char* key : {"right", "wrong"})
    if (given == 0 && values[key].place.line)
      reading.error(values[key].place, trf("'{0}' goes with 'number' or 'text'", key),
                    tr("say it behind the choice, after '→'"));
  // Choices contain their right answers. Whether there are choices is known only at the question's end.
  if (given == 0) return;
  AnswerSpec& answer = question.answer.emplace();
  answer.right = AuthorsText(values["right"]);
  answer.wrong = AuthorsText(values["wrong"]);
  answer.model = values["model"].text;
  if (values.has("number")) {
    answer.kind = AnswerSpec::Kind::Number;
    const Value &number = values["number"], &tolerance = values["tolerance"];
    answer.number = number.number;
    answer.tolerance = tolerance.number;
    if (!number.words.empty()) answer.unit = number.words[0];
    if (values.has("tolerance") && number.words != tolerance.words)
      reading.error(tolerance.place, tr("the tolerance and the number have different units"),
                    answer.unit.empty() ? tr("write the tolerance without a unit")
                                        : trf("write the tolerance in {0}", answer.unit));
    else if (answer.tolerance < 0.0)
      reading.error(tolerance.place, tr("the tolerance is below zero"), tr("write it without the minus sign"));
    else if (!values.has("tolerance") && answer.number != std::round(answer.number))
      reading.warning(number.place, tr("a number with decimals and no tolerance is met by hardly anybody"),
                      tr("add a line 'tolerance: …' in the same unit"));
  } else if (values.has("text")) {
    answer.kind = AnswerSpec::Kind::Text;
    answer.texts = values["text"].words;
    if (answer.texts.empty())
      reading.error(values["text"].place, tr("this question has no right answer"),
                    tr("write the words that count as right"));
  }
}

}  // namespace

void readAnswer(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, Question& question) {
  std::vector<Problem> problems;
  const std::vector<KeyLine> lines = splitKeyLines(block.lines, problems);
  const auto keys = pointersTo(keysOf(KeyBlock::Answer));
  const KeyValues values =
      readKeyValues(lines, keys, blockName(KeyBlock::Answer), block.place, problems, &conditionMeant);
  reading.add(std::move(problems));
  question.block_place = block.place;
  readWhatIsRight(reading, values, block, question);
  question.attempts = static_cast<int>(values["attempts"].number);
  question.goals = readGoals(reading, values["goal"], lesson);
  readRules(reading, values, question);
  const auto notJudged = [&](std::string_view key, Place place) {
    reading.error(place, trf("'{0}' needs an answer that is judged, and this one is not", key),
                  question.prediction ? tr("take it out, or write '### Question: …'") : tr("take it out"));
  };
  if (!question.prediction && !question.free()) return;
  if (values.has("attempts")) notJudged("attempts", values["attempts"].place);
  for (const StepRule& rule : question.rules) notJudged(rule.key(), rule.place);
}

}  // namespace moltact::reading
