// The edges between the side panels and the view, which can be dragged.
#include <algorithm>

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"

namespace moltact {
namespace {

void splitter(const char* name, const Rectangle& panel, bool on_its_right, double& width, double least, double most) {
  if (panel.empty()) return;
  const Look& l = look();
  const float half = l.px(4), x = on_its_right ? panel.high.x : panel.low.x;
  if (!beginOverlay(name, {{x - half, panel.low.y}, {x + half, panel.high.y}})) return;
  ImGui::InvisibleButton(name, {2 * half, panel.size().y});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (active || hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (active) {
    const float at = ImGui::GetIO().MousePos.x;
    width = std::clamp(double((on_its_right ? at - panel.low.x : panel.high.x - at) / (l.scale * l.text)), least, most);
  }
  const float line = std::max(1.0f, l.scale) * (active || hovered ? 2.0f : 1.0f);
  ImGui::GetWindowDrawList()->AddRectFilled({x - 0.5f * line, panel.low.y}, {x + 0.5f * line, panel.high.y},
                                            active || hovered ? l.palette.accent : l.palette.line);
  recordRectangle(name, {x - half, panel.low.y}, {x + half, panel.high.y});
  endPanel();
}

}  // namespace

void drawSplitters(Application& app) {
  splitter("splitter/lesson", app.layout().lesson, true, app.settings.lesson_width, 240.0, 700.0);
  splitter("splitter/touch", app.layout().touch, false, app.settings.touch_width, 220.0, 600.0);
}

}  // namespace moltact
