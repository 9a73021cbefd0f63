// At the top of the view for a scene with two structures: a slider between them, and a button for each. The tab Motion
// says so.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/moving_states.h"
#include "app/ui/panels/motion_sections.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {

bool drawMovingStatesSection(Application& app) {
  const std::string why = app.extensions().movers.get<MovingStates>().unavailable();
  if (!why.empty()) drawWrapped("states/slider", why);
  return !why.empty();
}

Rectangle drawStateSlider(Application& app, const Rectangle& view) {
  MovingStates& states = app.extensions().movers.get<MovingStates>();
  // During playback, the recording moves them.
  if (!states.ready() || app.extensions().playback.on()) return {};
  const Look& l = look();
  // The button that resets the view is in the corner beside it.
  const float room = view.size().x - l.px(120), pad = l.px(8), gap = l.px(8), high = l.tx(30);
  if (room < l.tx(140)) return {};
  const auto widthOf = [&](int state) {
    return std::min(ImGui::CalcTextSize(states.name(state).c_str()).x + l.px(24), 0.32f * room);
  };
  const float left = widthOf(0), right = widthOf(1), track = std::min(l.tx(180), room - left - right - 2 * (gap + pad)),
              width = left + right + track + 2 * (gap + pad);
  const ImVec2 low{std::round(0.5f * (view.low.x + view.high.x - width)), view.low.y + l.px(10)};
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + width, low.y + high + 2 * pad}, faded(l.palette.panel, 0.9f),
                                            l.px(8));
  const auto end = [&](int state, float x, float wide) {
    ImGui::SetCursorScreenPos({x, low.y + pad});
    const std::string text = elided(states.name(state), wide - l.px(16));
    if (button(("view/state/" + std::to_string(state)).c_str(), text.c_str(), ButtonLook::Plain, wide))
      states.goTo(state);
    tip(trf("Move the atoms to the state “{0}”", states.name(state)).c_str());
  };
  end(0, low.x + pad, left);
  ImGui::SetCursorScreenPos({low.x + pad + left + gap, low.y + pad + 0.5f * (high - ImGui::GetFrameHeight())});
  ImGui::SetNextItemWidth(track);
  float wanted = float(states.wanted());
  if (ImGui::SliderFloat("##states", &wanted, 0.0f, 1.0f, "", ImGuiSliderFlags_AlwaysClamp))
    states.goTo(double(wanted));
  // The present position of the atoms between the structures.
  const ImVec2 a = ImGui::GetItemRectMin(), b = ImGui::GetItemRectMax();
  const float x = a.x + l.px(4) + float(states.share()) * (b.x - a.x - l.px(8));
  ImGui::GetWindowDrawList()->AddLine({x, b.y + l.px(1)}, {x, b.y + l.px(4)}, l.palette.accent, l.px(2));
  recordItem("view/states", quantityText(states.share(), Dimension::Share));
  end(1, low.x + pad + left + gap + track + gap, right);
  return {{low.x, low.y}, {low.x + width, low.y + high + 2 * pad}};
}

}  // namespace moltact
