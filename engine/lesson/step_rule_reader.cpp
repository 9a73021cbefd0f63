// Reads the order of steps: step blocks, goals, and the targets of rules.
#include <algorithm>
#include <optional>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/suggestion.h"

namespace moltact::reading {
namespace {

// Finds a step by its link, or by its heading with or without "Aside:".
std::optional<std::string> stepNamed(const Lesson& lesson, std::string_view text) {
  if (text.starts_with('#')) text.remove_prefix(1);
  for (const Step& s : lesson.steps)
    if (s.id == text || s.title == text || s.id == slug(text)) return s.id;
  return std::nullopt;
}

void nameSteps(Reading& reading, const Lesson& lesson, const Step& at, StepRule& rule) {
  std::vector<std::string_view> ids;
  for (const Step& s : lesson.steps) ids.push_back(s.id);
  for (std::size_t k = 0; k < rule.steps.size(); ++k) {
    const std::string_view wanted = rule.steps[k];
    std::optional<std::string> id = stepNamed(lesson, wanted);
    if (!id) {
      const std::string_view bare = wanted.starts_with('#') ? wanted.substr(1) : wanted;
      reading.error(rule.step_places[k], trf("there is no step '{0}'", wanted), suggest(slug(bare), ids, tr("steps")));
      continue;
    }
    if (*id == at.id)
      reading.error(rule.step_places[k], tr("this is the step that the student is at"),
                    rule.then == StepRule::Then::GoTo
                        ? tr("name another; a wrong answer can be given again without going anywhere")
                        : tr("name another: what has been answered cannot be passed over"));
    rule.steps[k] = *std::move(id);
  }
}

}  // namespace

std::vector<std::size_t> readGoals(Reading& reading, const Value& value, const Lesson& lesson) {
  std::vector<std::size_t> out;
  for (std::size_t k = 0; k < value.counts.size(); ++k) {
    if (value.counts[k] <= lesson.goals.size()) {
      out.push_back(value.counts[k] - 1);
      continue;
    }
    const std::size_t n = lesson.goals.size();
    reading.error(value.places[k], trf("the lesson has no goal {0}", value.counts[k]),
                  n == 0 ? tr("write the goals in the front matter")
                         : trnf("it has {0} goal, counted from 1", "it has {0} goals, counted from 1", n, n));
  }
  return out;
}

void readStep(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, Step& step) {
  const auto keys = pointersTo(keysOf(KeyBlock::Step));
  std::vector<Problem> problems;
  const KeyValues values =
      readKeyValues(splitKeyLines(block.lines, problems), keys, blockName(KeyBlock::Step), block.place, problems);
  reading.add(std::move(problems));
  step.block_place = block.place;
  if (values.has("required")) step.required = values["required"].text == "yes";
  step.extra = values["extra"].text == "yes";
  for (const std::string& word : values["condition"].words)
    if (const auto condition = conditionNamed(word)) step.conditions.push_back(*condition);
  step.goals = readGoals(reading, values["goal"], lesson);
}

void resolveGoalsAndRules(Reading& reading, Lesson& lesson) {
  for (Step& step : lesson.steps) {
    for (TaskSpec& task : step.tasks)
      if (task.goals.empty()) task.goals = step.goals;
    for (Question& question : step.questions) {
      if (question.goals.empty()) question.goals = step.goals;
      for (StepRule& rule : question.rules) nameSteps(reading, lesson, step, rule);
    }
  }
}

}  // namespace moltact::reading
