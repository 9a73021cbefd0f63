#include "engine/lesson/way_rules.h"

namespace moltact {

std::string WayRule::key() const {
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

std::string_view wordOf(WayRule::Then then) { return then == WayRule::Then::GoTo ? "go to" : "skip"; }

}  // namespace moltact
