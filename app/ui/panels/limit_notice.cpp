// Describes the limits of the safety stage: that all force is stopped, and which limit acts. If the force is only
// drawn, it lists the limits that remove force while the user pushes.
#include <algorithm>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {

std::string limitText(const Application& app) {
  if (app.panels.pages.device) return {};  // that page shows the limits itself
  if (app.scene.servo_settings.panic) return tr("All force is stopped. F9 allows it again.");
  std::string text;
  for (const std::string& words : app.extensions().device.limitNotices()) text += (text.empty() ? "" : "\n") + words;
  return text;
}

// Over a dark or empty view; otherwise the lines at the view's lower edge contain it (view_overlays.cpp).
void drawLimitNotice(Application& app) {
  const Rectangle& view = app.layout().view;
  const bool stopped = app.scene.servo_settings.panic;
  const std::string text = limitText(app);
  if (text.empty() || view.empty() || app.panels.pages.welcome ||
      (app.scene.stage() && !app.extensions().task_stager.dark()))
    return;

  const Look& l = look();
  const Palette& p = l.palette;
  const float pad = l.px(12), most = std::min(view.size().x - l.px(28), l.tx(460));
  if (most < l.px(120)) return;
  const std::string lines = wrapped(text, most - 2 * pad);
  const ImVec2 words = ImGui::CalcTextSize(lines.c_str(), nullptr, false, most - 2 * pad);
  const float width = words.x + 2 * pad, height = words.y + 2 * l.px(8), bottom = view.high.y - l.px(56);
  ImGui::SetNextWindowPos({std::round(0.5f * (view.low.x + view.high.x - width)), std::round(bottom - height)});
  ImGui::SetNextWindowSize({width, height});
  ImGui::PushStyleColor(ImGuiCol_WindowBg, stopped ? p.bad_soft : p.warn_soft);
  ImGui::PushStyleColor(ImGuiCol_Border, faded(stopped ? p.bad : p.warn, 0.6f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, l.px(8));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0f, l.scale));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, l.px(8)});
  ImGui::Begin("limit notice", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoInputs);
  ImGui::PushTextWrapPos(pad + words.x + 1);
  ImGui::TextUnformatted(lines.c_str());
  recordItem("limits", text);
  ImGui::PopTextWrapPos();
  ImGui::End();
  ImGui::PopStyleVar(3);
  ImGui::PopStyleColor(2);
}

}  // namespace moltact
