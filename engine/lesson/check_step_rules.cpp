// Checks the effects of answers on the order of steps, and required steps: rules that never apply or lead to
// unreachable steps. No rules can trap a student (step_rules.h), so this needs no check.
#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"

namespace moltact::checks {
namespace {

void ruleOf(const Lesson& lesson, std::size_t at, const Question& question, const StepRule& rule, Findings& findings) {
  if (rule.when == StepRule::When::Wrong && question.attempts > 0 && rule.wrong > question.attempts)
    findings.error(rule.place, trf("this never happens: after {0} tries the answer is shown", question.attempts),
                   tr("write a smaller number of wrong answers, or more 'attempts'"));
  for (std::size_t k = 0; k < rule.steps.size(); ++k) {
    const auto to = lesson.find(rule.steps[k]);
    if (!to || rule.then != StepRule::Then::Skip) continue;
    if (lesson.steps[*to].aside)
      findings.error(rule.step_places[k], tr("an aside is not on the way, so it cannot be skipped"),
                     tr("name a step that Next leads to"));
    else if (*to < at)
      findings.warning(rule.step_places[k], tr("this step stands before the question, so students have passed it"),
                       tr("name a later step"));
  }
}

}  // namespace

void ways(const Lesson& lesson, Findings& findings) {
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const Step& step = lesson.steps[i];
    for (const Question& question : step.questions)
      for (const StepRule& rule : question.rules) ruleOf(lesson, i, question, rule, findings);
    if (!step.block_place.line || !step.required) continue;
    if (step.aside)
      findings.error(step.block_place, tr("an aside cannot be required: from it students go back when they like"),
                     tr("take 'required' out, or make it a step of the way: '## …'"));
    else if (step.tasks.empty() && step.questions.empty())
      findings.warning(step.block_place, tr("nothing in this step can be finished, so 'required' does nothing"),
                       tr("add a task or a question, or take it out"));
  }
}

}  // namespace moltact::checks
