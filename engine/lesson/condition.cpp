// The conditions of a study: what of a lesson a student gets (docs/study.md).
#include <algorithm>
#include <array>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/reading.h"

namespace moltact {
namespace {

constexpr std::array<std::pair<Condition, std::string_view>, 3> kNames{
    {{Condition::Touch, "touch"}, {Condition::Look, "look"}, {Condition::Blind, "blind"}}};

Selection allAtoms() { return *parseSelection("all"); }

void lock(SceneSpec& scene, std::initializer_list<const char*> keys) {
  for (const char* key : keys)
    if (!scene.locks(key)) scene.locked.push_back(key);
}

// The probe passes through the molecule, and what the hand would hold lies in its place.
void takeTouchOut(SceneSpec& scene) {
  scene.untouchable = allAtoms();
  scene.in_hand = {};
  scene.pull = PullBy::None;
  scene.pulled = {};
  scene.touch.force_on = false;
  scene.touch.forces = "none";
  scene.show.erase(std::remove_if(scene.show.begin(), scene.show.end(),
                                  [](const std::string& part) { return part != "atoms" && part != "target"; }),
                   scene.show.end());
  if (scene.show.empty()) scene.show = {"atoms", "target"};
  std::erase_if(scene.panels, [](const std::string& panel) { return panel == "touch" || panel == "methods"; });
  if (scene.panels.empty()) scene.panels = {"none"};
  lock(scene, {"force", "forces", "panels", "show"});
}

void takeTouchOut(Step& step) {
  takeTouchOut(step.scene);
  step.tasks.clear();
  std::erase_if(step.blocks, [](const Block& block) { return std::holds_alternative<TaskHere>(block); });
}

// Nothing shows where an atom is; a mouse shows the force.
void takePictureOut(SceneSpec& scene) {
  scene.hide = allAtoms();
  scene.show = {"force"};
  scene.labels.clear();
  scene.arrows.clear();
  scene.marks.clear();
  scene.measures.clear();
  scene.hydrogen_bonds = {};
  scene.highlight = {};
  scene.paint_touched = false;
  lock(scene, {"show"});
}

void takePictureOut(Step& step) {
  takePictureOut(step.scene);
  for (TaskSpec& task : step.tasks)
    if (task.values.has("looks")) {
      Value none = task.values["looks"];
      none.number = 0.0;
      none.text = "0";
      task.values.set("looks", std::move(none));
    }
}

// What would tell a student of a test how an answer was.
void checkTest(reading::Reading& reading, const Lesson& lesson) {
  for (const Step& step : lesson.steps) {
    for (const Question& question : step.questions) {
      if (question.attempts > 0)
        reading.error(question.block_place, tr("a test gives no second try, so 'attempts' has no effect"),
                      tr("take it out"));
      for (const StepRule& rule : question.rules)
        reading.error(rule.place, tr("where an answer leads would tell the student of a test whether it was right"),
                      tr("take it out"));
      if (question.prediction)
        reading.error(question.place, tr("a prediction in a test"), tr("write '### Question: …'"));
    }
  }
}

}  // namespace

std::string_view nameOf(Condition condition) { return kNames[std::size_t(condition)].second; }

std::optional<Condition> conditionNamed(std::string_view name) {
  for (const auto& [condition, its_name] : kNames)
    if (its_name == name) return condition;
  return std::nullopt;
}

namespace reading {

void applyCondition(Reading& reading, Lesson& lesson) {
  if (lesson.test) checkTest(reading, lesson);
  const Place first = lesson.steps.empty() ? Place{1, 1} : lesson.steps.front().place;
  const bool any = !lesson.steps.empty();
  std::erase_if(lesson.steps, [&](const Step& step) {
    return !step.conditions.empty() &&
           std::find(step.conditions.begin(), step.conditions.end(), lesson.condition) == step.conditions.end();
  });
  if (any && lesson.steps.empty())
    reading.error(first, trf("no step is left in the condition '{0}'", nameOf(lesson.condition)),
                  tr("take 'condition' out of a block step"));
  for (Step& step : lesson.steps) {
    if (lesson.condition == Condition::Look) takeTouchOut(step);
    if (lesson.condition == Condition::Blind) takePictureOut(step);
  }
}

}  // namespace reading
}  // namespace moltact
