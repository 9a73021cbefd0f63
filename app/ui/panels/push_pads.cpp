#include "app/ui/panels/push_pads.h"

#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr float kSize = 52.0f, kGap = 12.0f;  // at 96 dpi; a finger's tip

void drawPad(const char* name, ImVec2 low, float size, bool harder) {
  const Look& l = look();
  ImGui::SetCursorScreenPos(low);
  ImGui::InvisibleButton(name, {size, size});
  const std::string says = harder ? tr("Push harder: hold it while another finger pushes")
                                  : tr("Push more lightly: hold it while another finger pushes");
  recordItem(name, says);
  tip(says.c_str());
  const ImVec2 middle{low.x + 0.5f * size, low.y + 0.5f * size};
  const float arm = l.px(9), half = l.px(1.5f);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddCircleFilled(middle, 0.5f * size, faded(l.palette.panel, 0.85f), 40);
  draw->AddCircle(middle, 0.5f * size, l.palette.line, 40, std::max(1.0f, l.scale));
  draw->AddRectFilled({middle.x - arm, middle.y - half}, {middle.x + arm, middle.y + half}, l.palette.text);
  if (harder) draw->AddRectFilled({middle.x - half, middle.y - arm}, {middle.x + half, middle.y + arm}, l.palette.text);
}

}  // namespace

Rectangle pushPadsPlace(const Application& app, const Rectangle& view) {
  if (!app.panels.window.fingers || !app.scene.stage() || app.scene.playedHand().on() ||
      app.scene.servo().deviceLeads())
    return {};
  const Look& l = look();
  const float size = l.px(kSize), gap = l.px(kGap), margin = l.px(14);
  if (view.size().x < 3 * size || view.size().y < 2 * size + 5 * gap) return {};
  const float x = view.high.x - margin - size, y = 0.5f * (view.low.y + view.high.y) - size - 0.5f * gap;
  return {{x, y}, {x + size, y + 2 * size + gap}};
}

void drawPushPads(Application& app, const Rectangle& view) {
  const Rectangle place = pushPadsPlace(app, view);
  if (place.empty()) return;
  const float size = look().px(kSize);
  drawPad(kHarderPad, {place.low.x, place.low.y}, size, true);
  drawPad(kLighterPad, {place.low.x, place.high.y - size}, size, false);
}

}  // namespace moltact
