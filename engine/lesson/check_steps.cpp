// Checks that every step can be reached and has content.
#include <algorithm>
#include <span>
#include <unordered_map>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/lesson_texts.h"
#include "engine/lesson/source_text.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact::checks {
namespace {

/// The reachable steps: those of the core by Next, extra steps by their offers, other asides by a link from a reachable
/// step.
std::vector<char> reached(const Lesson& lesson) {
  std::vector<char> out(lesson.steps.size(), 0);
  std::vector<std::size_t> todo;
  std::unordered_map<std::string_view, std::size_t> step_of;
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) step_of.emplace(lesson.steps[i].id, i);
  const auto reach = [&](std::size_t i) {
    if (!out[i]) todo.push_back(i);
    out[i] = 1;
  };
  const auto follow = [&](const RichText& text) {
    for (const TextRun& run : text)
      if (run.link.starts_with('#'))
        if (const auto step = step_of.find(std::string_view(run.link).substr(1)); step != step_of.end())
          reach(step->second);
  };
  for (std::size_t i = 0; i < lesson.steps.size(); ++i)
    if (!lesson.steps[i].aside || lesson.steps[i].extra) reach(i);
  const auto followRules = [&](const Step& step) {
    for (const Question& q : step.questions)
      for (const StepRule& rule : q.rules)
        for (const std::string& id : rule.steps)
          if (const auto to = step_of.find(id); rule.then == StepRule::Then::GoTo && to != step_of.end())
            reach(to->second);
  };
  forEachText(lesson.introduction, follow);
  while (!todo.empty()) {
    const std::size_t i = todo.back();
    todo.pop_back();
    forEachText(lesson.steps[i], follow);
    followRules(lesson.steps[i]);
  }
  return out;
}

bool saysSomething(const Step& step) {
  if (!step.tasks.empty()) return true;
  bool any = false;
  forEachText(step, [&](const RichText& text) { any = any || !stripped(plainText(text)).empty(); });
  return any;
}

/// The kinds of tasks that can judge a held body: "reach, hold".
std::string kindsOfBody() {
  std::string out;
  for (const TaskKind& kind : taskKinds())
    if (!kind.of_body.empty()) out += (out.empty() ? "" : ", ") + std::string(kind.name);
  return out;
}

/// Checks a task's own requirements of its scene.
void tasksInScene(const Step& step, Findings& findings) {
  for (const TaskSpec& task : step.tasks) {
    const TaskKind* kind = findTaskKind(task.kind);
    std::vector<Problem> problems;
    if (kind && kind->check_scene) kind->check_scene(task, step.scene, problems);
    if (kind && step.scene.in_hand.given() && !kind->judgesBody(task))
      findings.error(
          task.place,
          kind->of_body.empty() ? trf("'{0}' judges a probe, and here the hand holds a body", kind->name)
                                : trf("'{0}' in this form judges a probe, and here the hand holds a body", kind->name),
          trf("write 'in-hand: none' in this step's scene, or a task that judges a body: {0}", kindsOfBody()));
    for (Problem& p : problems) findings.error({p.line, p.column}, std::move(p.message), std::move(p.remedy));
  }
}

/// Predictions are resolved by touch, so the step needs a task.
void predictsWithoutTouch(const Step& step, Findings& findings) {
  if (!step.tasks.empty()) return;
  for (const Question& q : step.questions)
    if (q.prediction)
      findings.warning(q.place, tr("a prediction in a step without a touch task gets its feedback at once"),
                       tr("add the touch that shows what is right, or write '### Question: …'"));
}

/// A key's value is one line of plain text; Markdown in it would be shown literally.
void markdownInKeys(const Step& step, Findings& findings) {
  const auto look = [&](const std::string& text, Place place) {
    if (!place.line) return;
    for (const std::string_view sign : {"](", "**", "`", "^"})
      if (const std::size_t at = text.find(sign); at != std::string::npos) {
        findings.warning({place.line, place.column + characterCount(std::string_view(text).substr(0, at))},
                         trf("'{0}' is shown unchanged: this key contains plain text, and its links do not work", sign),
                         tr("write it in the step's text, or take the signs out"));
        return;
      }
  };
  for (const TaskSpec& task : step.tasks) {
    const auto lookAt = [&](std::span<const KeySpec> keys) {
      for (const KeySpec& key : keys)
        if (key.type == ValueType::Text && task.values.has(key.name))
          look(task.values[key.name].text, task.values[key.name].place);
    };
    lookAt(keysOf(KeyBlock::Touch));
    if (const TaskKind* kind = findTaskKind(task.kind)) lookAt(kind->keys);
  }
}

/// "[the cleft](#zoom:residue 35)" is not a link, because a blank ends its target.
void brokenLinks(const Step& step, Findings& findings) {
  forEachText(step, [&](const RichText& text) {
    for (const TextRun& run : text) {
      const std::size_t at = run.code ? std::string::npos : run.text.find("](#");
      if (at != std::string::npos)
        findings.error({run.place.line, run.place.column},
                       tr("this is not a link, because its target contains a blank"),
                       tr("write the target in angle brackets: [the ligand](<#zoom:ligand>)"));
    }
  });
}

/// The step for the card's picture must exist and have a scene.
void cardPicture(const Lesson& lesson, Findings& findings) {
  if (!lesson.card_place.line) return;
  const auto count = std::count_if(lesson.steps.begin(), lesson.steps.end(), [](const Step& s) { return !s.aside; });
  const auto step = lesson.cardStep();
  if (!step)
    findings.error(lesson.card_place,
                   trnf("there is no step {0} for the card: the lesson has {1} step, without its asides",
                        "there is no step {0} for the card: the lesson has {1} steps, without its asides",
                        std::size_t(count), lesson.card, count),
                   tr("write the number of a step, counted from 1, or take the line out"));
  else if (lesson.steps[*step].scene.molecule.name.empty())
    findings.error(lesson.card_place, trf("step {0} has no scene that the card could show", lesson.card),
                   tr("write the number of a step with a scene"));
}

}  // namespace

void steps(const Lesson& lesson, Findings& findings) {
  cardPicture(lesson, findings);
  const std::vector<char> can_reach = reached(lesson);
  for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
    const Step& step = lesson.steps[i];
    if (!can_reach[i])
      findings.error(step.place, tr("no link leads to this aside, so no student can come to it"),
                     trf("link to it from another step: [{0}](#{1})", step.title, step.id));
    predictsWithoutTouch(step, findings);
    markdownInKeys(step, findings);
    brokenLinks(step, findings);
    tasksInScene(step, findings);
    if (!saysSomething(step))
      findings.error(step.place, tr("this step says nothing to the student"), tr("write a sentence below its heading"));
  }
}

}  // namespace moltact::checks
