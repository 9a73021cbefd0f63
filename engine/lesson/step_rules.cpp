#include "engine/lesson/step_rules.h"

namespace moltact {

std::string StepRule::key() const {
  switch (when) {
    case When::Right:
      return "if right";
    case When::RightAtFirst:
      return "if right at first";
    case When::Wrong:
      break;
  }
  return "after " + std::to_string(wrong) + " wrong";
}

std::string_view wordOf(StepRule::Then then) { return then == StepRule::Then::GoTo ? "go to" : "skip"; }

}  // namespace moltact
