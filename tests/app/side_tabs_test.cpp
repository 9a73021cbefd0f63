// The tabs of the panel beside the view. Oracle: what was opened and closed, in order.
#include "app/ui/application/side_tabs.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "app/ui/panels/actions.h"
#include "app/ui/panels/side_panel.h"
#include "engine/lesson/keys.h"

namespace moltact {

TEST_CASE("a tab opens in front, and touch is in front again when it closes; touch itself never closes") {
  SideTabs tabs;
  CHECK(tabs.front() == "touch");
  tabs.show(false);
  tabs.open("methods");
  CHECK((tabs.shown() && tabs.has("methods") && tabs.front() == "methods"));
  tabs.open("other");
  tabs.bringToFront("methods");
  tabs.close("other");
  CHECK(tabs.front() == "methods");
  tabs.close("methods");
  CHECK((tabs.front() == "touch" && !tabs.has("methods")));
  tabs.bringToFront("methods");  // is not open
  tabs.close("touch");
  CHECK((tabs.front() == "touch" && tabs.has("touch")));
}

TEST_CASE("a scene opens its tabs, and one that asks for none gives back what the student had") {
  SideTabs tabs;
  tabs.open("other");
  tabs.applyLesson({"methods"});
  CHECK((tabs.front() == "methods" && !tabs.has("other")));
  tabs.applyLesson({"none"});
  CHECK_FALSE(tabs.shown());
  tabs.applyLesson({});
  CHECK((tabs.shown() && tabs.front() == "other" && !tabs.has("methods")));
}

TEST_CASE("a scene that locks its panels undoes what the student opens, but not which tab is in front") {
  SideTabs tabs;
  tabs.applyLesson({"touch", "methods"});
  tabs.bringToFront("touch");
  tabs.open("other");
  tabs.bringToFront("touch");
  tabs.enforceLesson({"touch", "methods"});
  CHECK((tabs.front() == "touch" && tabs.has("methods") && !tabs.has("other")));
  tabs.enforceLesson({});
  CHECK_FALSE(tabs.has("methods"));
}

TEST_CASE("each tab has its action, and a scene opens registered tabs only") {
  for (const SideTab& tab : sideTabs()) CHECK(findAction(tab.key));
  const std::vector<KeySpec>& keys = keysOf(KeyBlock::Scene);
  const auto panels = std::find_if(keys.begin(), keys.end(), [](const KeySpec& k) { return k.name == "panels"; });
  REQUIRE(panels != keys.end());
  for (const auto& word : panels->words) {
    const auto is = [&](const SideTab& tab) { return tab.key == word; };
    CHECK((word == "none" || std::any_of(sideTabs().begin(), sideTabs().end(), is)));
  }
}

}  // namespace moltact
