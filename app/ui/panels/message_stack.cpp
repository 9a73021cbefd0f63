// Messages over the view's upper edge, each with a cross to dismiss it.
#include <optional>

#include "app/ui/application/application.h"
#include "app/ui/panels/actions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// Draws the buttons in a row below the text; unavailable actions are disabled. Returns the pressed one, which the
// caller runs after all are drawn, because it may remove the message.
const Action* drawActions(Application& app, const Message& message, const std::string& name) {
  const Action* pressed = nullptr;
  for (std::size_t k = 0; k < message.actions.size(); ++k) {
    const Action* action = findAction(message.actions[k]);
    if (!action) continue;
    if (k > 0) ImGui::SameLine(0, look().px(8));
    if (button((name + "/" + std::string(action->name)).c_str(), std::string(tr(action->label)).c_str(),
               ButtonLook::Plain, 0.0f, enabled(*action, app)))
      pressed = action;
  }
  return pressed;
}

}  // namespace

void drawMessageStack(Application& app) {
  const Look& l = look();
  const Rectangle& view = app.layout().view;
  app.panels.window.messages_end = 0.0f;
  if (app.messages.all().empty()) return;
  const Rectangle room = view.size().x > l.px(260) ? view
                                                   : Rectangle{{0, app.layout().menu.high.y},
                                                               {app.layout().menu.high.x, app.layout().status.low.y}};
  const float margin = l.px(12), width = std::min(room.size().x - 2 * margin, l.tx(560));
  constexpr float kMax = 0.45f;  // share of the room's height
  float y = room.low.y + margin;
  std::optional<std::size_t> dismissed;
  const Action* chosen = nullptr;
  for (std::size_t k = 0; k < app.messages.all().size(); ++k) {
    const Message& m = app.messages.all()[k];
    const Palette& p = l.palette;
    const ImU32 ground = m.kind == MessageKind::Error     ? p.bad_soft
                         : m.kind == MessageKind::Warning ? p.warn_soft
                                                          : p.good_soft;
    const ImU32 edge = m.kind == MessageKind::Error ? p.bad : m.kind == MessageKind::Warning ? p.warn : p.good;
    const float pad = l.px(12), text_w = width - 2 * pad - l.px(40);
    const std::string lines = wrapped(m.text, text_w);
    const float text_h = ImGui::CalcTextSize(lines.c_str(), nullptr, false, text_w).y;
    const float actions_h = m.actions.empty() ? 0.0f : l.px(8) + l.tx(34);
    const float height = std::min(std::max(text_h, l.tx(22)) + actions_h + 2 * pad, room.high.y - y - margin);
    // The view below needs room too: later messages wait.
    if (height < l.px(30) || (k > 0 && y + height - room.low.y > kMax * room.size().y)) break;
    const std::string name = "message/" + std::to_string(k);
    ImGui::SetNextWindowPos({0.5f * (room.low.x + room.high.x - width), y});
    ImGui::SetNextWindowSize({width, height});
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ground);
    ImGui::PushStyleColor(ImGuiCol_Border, faded(edge, 0.6f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, l.px(8));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, std::max(1.0f, l.scale));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {pad, pad});
    ImGui::Begin(name.c_str(), nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNavFocus);
    ImGui::PushTextWrapPos(pad + text_w);
    ImGui::TextUnformatted(lines.c_str());
    recordItem(name, m.text);
    ImGui::PopTextWrapPos();
    if (!m.actions.empty()) {
      ImGui::SetCursorPos({pad, pad + std::max(text_h, l.tx(22)) + l.px(8)});
      if (const Action* pressed = drawActions(app, m, name)) chosen = pressed;
    }
    ImGui::SetCursorPos({width - pad - l.px(24), pad - l.px(5)});
    if (iconButton((name + "/dismiss").c_str(), Icon::Close, tr("Dismiss"))) dismissed = k;
    ImGui::End();
    ImGui::PopStyleVar(3);
    ImGui::PopStyleColor(2);
    y += height + l.px(8);
  }
  app.panels.window.messages_end = y;
  if (dismissed) app.messages.dismiss(*dismissed);
  if (chosen) chosen->run(app);
}

}  // namespace moltact
