// Checks the task that a lesson asks before and after its explanation: there must be two, and they must ask the same.
#include <algorithm>
#include <iterator>

#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"

namespace moltact::checks {
namespace {

/// Whether two tasks ask the same, apart from their texts.
bool asksTheSame(const TaskSpec& a, const TaskSpec& b) {
  if (a.kind != b.kind) return false;
  constexpr std::string_view kMayDiffer[] = {"asked", "say", "praise", "called", "goal", "right", "attempts", "tell"};
  for (const auto& [key, value] : a.values)
    if (std::find(std::begin(kMayDiffer), std::end(kMayDiffer), key) == std::end(kMayDiffer) &&
        value.text != b.values[key].text)
      return false;
  return true;
}

/// Whether the hand feels the same in both scenes.
bool feelsTheSame(const SceneSpec& a, const SceneSpec& b) {
  return a.molecule == b.molecule && a.touch == b.touch && a.untouchable == b.untouchable && a.remove == b.remove;
}

}  // namespace

void askedTwice(const Lesson& lesson, Findings& findings) {
  struct Found {
    const TaskSpec* task;
    const Step* step;
  };
  std::vector<Found> before, after;
  for (const Step& step : lesson.steps)
    for (const TaskSpec& task : step.tasks) {
      const std::string& asked = task.values["asked"].text;
      if (asked.empty()) continue;
      const Place place = task.values["asked"].place;
      if (step.aside)
        findings.error(place, tr("a task that is asked before and after is outside the core"),
                       tr("put it into a step that every student sees"));
      std::vector<Found>& list = asked == "before" ? before : after;
      if (!list.empty())
        findings.error(place, trf("two tasks are asked '{0}'", asked), tr("one task of a lesson is asked twice"));
      if (asked == "after" && before.empty())
        findings.error(place, tr("no earlier task of the lesson is asked 'before'"),
                       tr("write 'asked: before' in the same task of an earlier step"));
      list.push_back({&task, &step});
    }
  if (before.empty()) return;
  const Place place = before.front().task->values["asked"].place;
  if (after.empty()) {
    findings.error(place, tr("no later task of the lesson is asked 'after'"),
                   tr("write 'asked: after' in the same task of a later step"));
    return;
  }
  if (!asksTheSame(*before.front().task, *after.front().task) ||
      !feelsTheSame(before.front().step->scene, after.front().step->scene))
    findings.error(after.front().task->values["asked"].place,
                   tr("what is asked before and after differs, so the gain would mean nothing"),
                   trf("give both tasks the same keys and the same scene; the first is on line {0}",
                       before.front().task->place.line));
}

}  // namespace moltact::checks
