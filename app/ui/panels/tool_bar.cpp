// The tool bar at the right end of the top line: icons with tool tips for the actions that have a place there. If room
// is short, the less important ones are left out.
#include <algorithm>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"

namespace moltact {

void drawToolBar(Application& app) {
  const Look& l = look();
  const float size = l.px(30), gap = l.px(4), margin = l.px(8);
  const Rectangle& bar = app.layout().menu;
  const float room = bar.size().x - app.panels.window.menus_end - 2 * margin;
  std::vector<const Action*> shown;
  for (const Action& a : allActions())
    if (a.tool > 0) shown.push_back(&a);
  const auto width = [&] { return float(shown.size()) * (size + gap) - gap; };
  for (int need = 9; need > 0 && width() > room; --need)
    std::erase_if(shown, [&](const Action* a) { return a->tool == need; });
  if (shown.empty()) return;
  const float edge = 0.5f * (bar.size().y - size), right = bar.high.x - margin;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, 0});
  if (beginOverlay("tool bar", {{right - width(), edge}, {right, edge + size}})) {
    for (const Action* a : shown) {
      if (a != shown.front()) ImGui::SameLine();
      const std::string tip = toolTip(*a);
      if (iconButton(("tool/" + std::string(a->name)).c_str(), a->icon, tip.c_str(), a->on && a->on(app),
                     enabled(*a, app)))
        a->run(app);
    }
    endPanel();
  }
  ImGui::PopStyleVar();
}

}  // namespace moltact
