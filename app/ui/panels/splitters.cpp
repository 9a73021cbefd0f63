// The draggable edges between the panels and the view.
#include "app/ui/panels/splitters.h"

#include <algorithm>

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"

namespace moltact {
namespace {

void splitter(const char* name, const Rectangle& panel, bool on_its_right, double& width, double min, double max) {
  if (panel.empty()) return;
  const Look& l = look();
  const float half = l.px(4), x = on_its_right ? panel.high.x : panel.low.x;
  if (!beginOverlay(name, {{x - half, panel.low.y}, {x + half, panel.high.y}})) return;
  ImGui::InvisibleButton(name, {2 * half, panel.size().y});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (active || hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  if (active) {
    const float at = ImGui::GetIO().MousePos.x;
    width = std::clamp(double((on_its_right ? at - panel.low.x : panel.high.x - at) / (l.scale * l.text)), min, max);
  }
  const float line = std::max(1.0f, l.scale) * (active || hovered ? 2.0f : 1.0f);
  ImGui::GetWindowDrawList()->AddRectFilled({x - 0.5f * line, panel.low.y}, {x + 0.5f * line, panel.high.y},
                                            active || hovered ? l.palette.accent : l.palette.line);
  recordRectangle(name, {x - half, panel.low.y}, {x + half, panel.high.y});
  endPanel();
}

// The edge above a panel below the view.
void levelSplitter(const char* name, const Layout& layout, const Rectangle& panel, float& share) {
  constexpr float kMin = 0.2f, kMax = 0.8f;
  const Look& l = look();
  const float half = l.px(6), y = panel.low.y;
  if (!beginOverlay(name, {{panel.low.x, y - half}, {panel.high.x, y + half}})) return;
  ImGui::InvisibleButton(name, {panel.size().x, 2 * half});
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  if (active || hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
  if (active) {
    const float room = layout.status.low.y - layout.menu.high.y;
    share = std::clamp((layout.status.low.y - ImGui::GetIO().MousePos.y) / std::max(1.0f, room), kMin, kMax);
  }
  const ImU32 colour = active || hovered ? l.palette.accent : l.palette.line;
  const float line = std::max(1.0f, l.scale), middle = 0.5f * (panel.low.x + panel.high.x), grip = l.px(18);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({panel.low.x, y - 0.5f * line}, {panel.high.x, y + 0.5f * line}, colour);
  draw->AddRectFilled({middle - grip, y - l.px(2)}, {middle + grip, y + l.px(2)}, colour, l.px(2));
  recordRectangle(name, {panel.low.x, y - half}, {panel.high.x, y + half});
  endPanel();
}

}  // namespace

void drawSplitters(Application& app) {
  const Layout& layout = app.layout();
  if (layout.tall) {
    const Rectangle& panel = layout.lesson.empty() ? layout.touch : layout.lesson;
    if (!panel.empty()) levelSplitter(kEdgeBelow, layout, panel, app.panels.window.below_share);
    return;
  }
  splitter(kLessonEdge, app.layout().lesson, true, app.settings.lesson_width, 240.0, 700.0);
  splitter(kTouchEdge, app.layout().touch, false, app.settings.touch_width, 220.0, 600.0);
}

}  // namespace moltact
