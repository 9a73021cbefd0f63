// Below the view while a class takes turns: who is at the device and for how long, who is next, and the predictions of
// those who wait.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/clock_text.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// Text vertically centred in a row of buttons.
void rowText(const char* name, const std::string& text, ImU32 colour) {
  const float y = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(y + std::round(0.5f * (look().tx(34) - ImGui::GetFontSize())));
  WithText with(colour);
  ImGui::TextUnformatted(text.c_str());
  recordItem(name, text);
  ImGui::SameLine();
  ImGui::SetCursorPosY(y);
}

void drawTurn(ClassTurns& turns, float whole) {
  const Look& l = look();
  const Turns& t = turns.turns();
  const float gap = ImGui::GetStyle().ItemSpacing.x, buttons = l.tx(96 + 84 + 74 + 66) + 3 * gap;
  const bool roomy = whole > buttons + l.tx(230);
  const float row = ImGui::GetCursorPosY();
  const bool short_time = t.left_s() < 15.0 && t.state() == Turns::State::Running;
  rowText("turns/left", clockText(int(std::ceil(t.left_s()))), short_time ? l.palette.bad : l.palette.accent);
  {
    WithFont strong(Font::Strong);
    const float room = whole - l.tx(60) - (roomy ? buttons : l.tx(96) + gap);
    const std::string who = elided(t.current(), std::max(l.tx(40), t.names().size() > 1 && roomy ? 0.6f * room : room));
    rowText("turns/current", who, l.palette.text);
  }
  if (roomy && t.names().size() > 1)
    rowText("turns/next", trf("then {0}", elided(t.next(), l.tx(110))), l.palette.quiet);
  ImGui::SameLine(l.px(14) + whole - (roomy ? buttons : l.tx(96)));
  ImGui::SetCursorPosY(row);
  if (button("turns/pass", tr("Pass on"), ButtonLook::Primary, l.tx(96))) return turns.passOn();
  if (!roomy) return;
  ImGui::SameLine();
  const bool paused = t.state() == Turns::State::Paused;
  if (button("turns/pause", paused ? tr("Go on") : tr("Pause"), ButtonLook::Plain, l.tx(84)))
    paused ? turns.resume() : turns.pause();
  tip(tr("Stops the time of this turn"));
  ImGui::SameLine();
  if (button("turns/longer", ("+" + quantityText(60, Dimension::Time, {plain(), "min"})).c_str(), ButtonLook::Plain,
             l.tx(74)))
    turns.extend(60.0);
  ImGui::SameLine();
  if (button("turns/end", tr("End"), ButtonLook::Plain, l.tx(66))) turns.end();
  tip(tr("Ends the turns; what everyone did is kept"));
}

void drawTime(const Turns& t, const Rectangle& r) {
  const Look& l = look();
  const float part = float(std::clamp(t.left_s() / std::max(1.0, t.turn_s()), 0.0, 1.0)),
              high = std::max(2.0f, l.px(3));
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({r.low.x, r.low.y}, {r.high.x, r.low.y + high}, l.palette.pressed);
  draw->AddRectFilled({r.low.x, r.low.y}, {r.low.x + part * r.size().x, r.low.y + high},
                      t.left_s() < 15.0 ? l.palette.bad : l.palette.accent);
}

void drawPrediction(Application& app, ClassTurns& turns, float whole) {
  const Look& l = look();
  ClassTurns::Draft& draft = turns.draft;
  const std::vector<std::string> waiting = turns.turns().waiting();
  if (waiting.empty()) return;
  draft.who = std::min(draft.who, waiting.size() - 1);
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  {
    WithText quiet(l.palette.quiet);
    const std::string asked = trf("Who waits, predicts: {0}", turns.prompt(app.lesson));
    ImGui::TextUnformatted(elided(asked, whole).c_str());
    recordItem("turns/prompt", asked);
    tip(asked.c_str());
  }
  const float name_w = std::min(l.tx(150), 0.3f * whole), keep_w = l.tx(72);
  std::optional<FieldAsHighAsButton> high(std::in_place);
  ImGui::SetNextItemWidth(name_w);
  const bool open = ImGui::BeginCombo("##who", elided(waiting[draft.who], name_w - l.tx(44)).c_str());
  if (!open) recordItem("turns/who", waiting[draft.who]);
  if (open) {
    for (std::size_t k = 0; k < waiting.size(); ++k) {
      if (ImGui::Selectable((waiting[k] + "##" + std::to_string(k)).c_str(), k == draft.who)) draft.who = k;
      recordItem("turns/who/" + std::to_string(k), waiting[k]);
    }
    ImGui::EndCombo();
  }
  ImGui::SameLine();
  ImGui::SetNextItemWidth(whole - name_w - keep_w - 2 * gap);
  bool keep = ImGui::InputTextWithHint("##prediction", tr("your prediction"), &draft.prediction,
                                       ImGuiInputTextFlags_EnterReturnsTrue);
  high.reset();
  recordItem("turns/prediction", draft.prediction);
  ImGui::SameLine();
  keep = button("turns/keep", tr("Keep"), ButtonLook::Plain, keep_w) || keep;
  if (!keep || !turns.predict(waiting[draft.who], draft.prediction)) return;
  app.messages.notice(trf("Kept: what {0} predicts.", waiting[draft.who]));
  draft.prediction.clear();
  draft.who = (draft.who + 1) % waiting.size();
}

}  // namespace

void drawTurnsStrip(Application& app) {
  ClassTurns& turns = app.extensions().turns;
  if (!turns.on() || app.extensions().playback.on()) return;
  const Look& l = look();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(14), l.px(10)});
  const bool shown =
      beginPanel("turns", app.layout().strip, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (!shown) return;
  const float whole = ImGui::GetContentRegionAvail().x;
  drawTime(turns.turns(), app.layout().strip);
  drawTurn(turns, whole);
  if (turns.on()) drawPrediction(app, turns, whole);
  endPanel();
}

}  // namespace moltact
