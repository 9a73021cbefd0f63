#include "app/ui/panels/side_panel.h"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/panels/dark_view.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawTouchTab(Application& app);
#define MOLTACT_DECLARE(Name, ...) void draw##Name##Tab(Application& app);
MOLTACT_SIDE_TABS(MOLTACT_DECLARE)
#undef MOLTACT_DECLARE

std::span<const SideTab> sideTabs() {
#define MOLTACT_TAB(Name, key, title, ...) SideTab{key, title, &draw##Name##Tab},
  static constexpr std::array kTabs{MOLTACT_TAB(Touch, SideTabs::kTouch.data(), N_("Touch"))
                                        MOLTACT_SIDE_TABS(MOLTACT_TAB)};
#undef MOLTACT_TAB
  return kTabs;
}

namespace {

// Draws the titles of the open tabs; of one alone, the panel's title.
void drawTabs(SideTabs& state) {
  std::vector<std::string> titles;
  std::vector<const char*> keys;
  for (const SideTab& tab : sideTabs()) {
    if (!state.has(tab.key)) continue;
    titles.emplace_back(tab.title);
    keys.push_back(tab.key);
  }
  if (keys.size() == 1) {
    const WithFont title(Font::Title);
    ImGui::TextUnformatted(tr(titles[0].c_str()));
    return;
  }
  auto front = std::size_t(std::find(keys.begin(), keys.end(), state.front()) - keys.begin());
  if (segments("tab", titles, front)) state.bringToFront(keys[front]);
}

}  // namespace

void drawSidePanel(Application& app) {
  const std::span<const SideTab> tabs = sideTabs();
  const auto front =
      std::find_if(tabs.begin(), tabs.end(), [&](const SideTab& t) { return t.key == app.panels.tabs.front(); });
  const SideTab& tab = front == tabs.end() ? tabs[0] : *front;
  if (!beginPanel(tab.key, app.layout().touch)) return;
  if (!drawnDark(app)) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {look().px(8), look().px(10)});
    drawTabs(app.panels.tabs);
    tab.draw(app);
    ImGui::PopStyleVar();
  }
  endPanel();
}

}  // namespace moltact
