// In the view's lower right corner while the probe touches: the depth of the hand under the surface, seen from the
// side. In the view itself, the depth mostly lies along the line of sight.
#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {

void drawDepthGauge(Application& app, ViewRoom& room, float bottom_px) {
  const Rectangle& view = room.view;
  const ServoSample& now = app.scene.log().latest();
  const double depth_A = now.contact.depth_A();
  // A body has several contacts and no single depth.
  if (!app.settings.depth_gauge || app.scene.stage().body || !app.scene.look.shown.has(ViewPart::Hip) ||
      !now.contact.touching() || !(depth_A > 0.0) || !std::isfinite(depth_A))
    return;
  const Look& l = look();
  const ImVec2 size{l.px(92), l.px(124)};
  const ImVec2 low{view.high.x - size.x - l.px(18), bottom_px - size.y}, high{low.x + size.x, low.y + size.y};
  const Rectangle place{{low.x, low.y}, {high.x, high.y}};
  if (low.x < view.low.x + l.px(220) || low.y < view.low.y + l.px(56) || !room.isFree(place)) return;
  room.take(place);
  const Theme theme = l.viewTheme();
  const auto packed = [](const Colour& c) { return ImGui::ColorConvertFloat4ToU32({c.x, c.y, c.z, 1.0f}); };
  const double strongest_N = std::max(0.1, app.scene.servo_settings.max_force_N);
  const ImU32 warm = packed(forceColour(theme, app.scene.log().force_N() / strongest_N));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(l.palette.panel, 0.85f), l.px(8));

  // The probe at the same scale as the depth; both shrink if they do not fit.
  const float inside = size.y - l.px(44), middle = 0.5f * (low.x + high.x);
  const double whole_A = 2.0 * now.probe_A + std::max(depth_A, 2.0);
  const float px_per_A = std::min(saturateToFloat(inside / whole_A), l.px(16));
  const float radius = std::max(l.px(3), saturateToFloat(now.probe_A) * px_per_A),
              top = low.y + l.px(8) + 2.0f * radius;
  const float hand = top - radius + std::min(saturateToFloat(depth_A) * px_per_A, high.y - l.px(30) - top + radius);
  draw->AddRectFilled({low.x + l.px(6), top}, {high.x - l.px(6), high.y - l.px(24)}, faded(l.palette.quiet, 0.25f));
  draw->AddLine({low.x + l.px(6), top}, {high.x - l.px(6), top}, l.palette.quiet, std::max(1.0f, l.px(1.5f)));
  draw->AddCircleFilled({middle, top - radius}, radius, faded(packed(theme.probe), 0.35f), 32);
  draw->AddCircle({middle, top - radius}, radius, packed(theme.probe), 32, std::max(1.0f, l.px(1.5f)));
  draw->AddLine({middle, top - radius}, {middle, hand}, warm, std::max(1.5f, l.px(3)));
  draw->AddCircleFilled({middle, hand}, l.px(3.5f), packed(theme.hip), 16);

  const std::string text = quantityText(depth_A, Dimension::Length, decimals(1));
  ImFont* font = l.font(Font::Small);
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str());
  draw->AddText(font, font->FontSize, {middle - 0.5f * extent.x, high.y - l.px(20)}, l.palette.text, text.c_str());
  recordRectangle("view/depth", {low.x, low.y}, {high.x, high.y}, text);
}

}  // namespace moltact
