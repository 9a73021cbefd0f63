// Below the view during the playback of an attempt: play, a timeline with marks, the last event, speed, close.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/clock_text.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

ImU32 colourOf(TimelineMark::Kind kind) {
  const Palette& p = look().palette;
  switch (kind) {
    case TimelineMark::Kind::Step:
      return p.quiet;
    case TimelineMark::Kind::Task:
    case TimelineMark::Kind::Right:
      return p.good;
    case TimelineMark::Kind::Wrong:
      return p.bad;
    case TimelineMark::Kind::Hint:
      return p.warn;
  }
  return p.quiet;
}

// A step is a line across the bar, an answer a disc or a cross, a task a square, a hint a triangle. The shapes do not
// depend on colour vision.
void drawMark(ImDrawList* draw, const TimelineMark& m, float x, float y, float half) {
  const ImU32 colour = colourOf(m.kind);
  const float r = look().px(4);
  switch (m.kind) {
    case TimelineMark::Kind::Step:
      draw->AddLine({x, y - half}, {x, y + half}, colour, std::max(1.0f, look().px(1.5f)));
      break;
    case TimelineMark::Kind::Right:
      draw->AddCircleFilled({x, y}, r, colour, 16);
      break;
    case TimelineMark::Kind::Task:
      draw->AddRectFilled({x - 0.9f * r, y - 0.9f * r}, {x + 0.9f * r, y + 0.9f * r}, colour);
      break;
    case TimelineMark::Kind::Hint:
      draw->AddTriangleFilled({x, y - r}, {x + r, y + r}, {x - r, y + r}, colour);
      break;
    case TimelineMark::Kind::Wrong:
      draw->AddLine({x - r, y - r}, {x + r, y + r}, colour, look().px(2));
      draw->AddLine({x - r, y + r}, {x + r, y - r}, colour, look().px(2));
      break;
  }
}

void drawScrubber(Playback& playback, float width) {
  const Look& l = look();
  const float high = l.tx(30);
  ImGui::InvisibleButton("scrub", {std::max(width, l.px(40)), high});
  const ImVec2 low = ImGui::GetItemRectMin(), end = ImGui::GetItemRectMax();
  const double length_s = std::max(1e-9, playback.timeline().length_s());
  const float edge = l.px(6), from = low.x + edge, to = end.x - edge, middle = 0.5f * (low.y + end.y), half = l.px(9);
  const auto place = [&](double t_s) {
    return from + (to - from) * std::clamp(saturateToFloat(t_s / length_s), 0.0f, 1.0f);
  };
  const float pointer = ImGui::GetIO().MousePos.x;
  const TimelineMark* near = nullptr;
  if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
    float nearest = l.px(6);
    for (const TimelineMark& m : playback.timeline().marks())
      if (const float away = std::abs(place(m.t_s) - pointer); away < nearest) {
        nearest = away;
        near = &m;
      }
    const double t_s = length_s * double(std::clamp((pointer - from) / (to - from), 0.0f, 1.0f));
    if (ImGui::IsItemActive()) playback.seek(near && ImGui::IsMouseClicked(0) ? near->t_s : t_s);
    ImGui::SetTooltip(
        "%s", ((near ? near->text + "  " : "") + clockText(saturateToInteger<int>(near ? near->t_s : t_s))).c_str());
  }
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float bar = l.px(3);
  draw->AddRectFilled({from, middle - bar}, {to, middle + bar}, l.palette.pressed, bar);
  draw->AddRectFilled({from, middle - bar}, {std::max(place(playback.at_s()), from), middle + bar},
                      faded(l.palette.accent, 0.55f), bar);
  for (const TimelineMark& m : playback.timeline().marks()) drawMark(draw, m, place(m.t_s), middle, half);
  const float x = place(playback.at_s());
  draw->AddCircleFilled({x, middle}, l.px(8), l.palette.accent, 28);
  draw->AddCircleFilled({x, middle}, l.px(3.5f), l.palette.panel, 20);
  recordRectangle("playback/bar", {low.x, low.y}, {end.x, end.y}, clockText(saturateToInteger<int>(playback.at_s())));
}

void drawSpeed(Playback& playback) {
  static constexpr double kSpeeds[] = {0.5, 1.0, 2.0, 4.0, 8.0};
  const std::string text = numberText(playback.speed) + " ×";
  if (!button("playback/speed", text.c_str(), ButtonLook::Plain, look().tx(58))) return;
  const double* after =
      std::find_if(std::begin(kSpeeds), std::end(kSpeeds), [&](double s) { return s > playback.speed + 1e-9; });
  playback.speed = after == std::end(kSpeeds) ? kSpeeds[0] : *after;
}

void keys(Playback& playback) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!keysFree() || io.KeyCtrl || io.KeyAlt) return;
  constexpr double kStep_s = 5.0;
  if (ImGui::IsKeyPressed(ImGuiKey_Space, false)) playback.setRunning(!playback.running());
  if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow, true))
    io.KeyShift ? playback.seekMark(-1) : playback.seek(playback.at_s() - kStep_s);
  if (ImGui::IsKeyPressed(ImGuiKey_RightArrow, true))
    io.KeyShift ? playback.seekMark(1) : playback.seek(playback.at_s() + kStep_s);
}

std::string summaryText(const Playback& playback) {
  const AttemptHeader& h = playback.timeline().header();
  std::string out = h.student.empty() ? h.lesson.title : h.student + ", " + h.lesson.title;
  if (const std::string step = playback.timeline().step(playback.at_s()); !step.empty()) out += " · " + step;
  if (const std::string last = playback.lastMark(); !last.empty() && last != playback.timeline().step(playback.at_s()))
    out += " · " + last;
  return out;
}

}  // namespace

void drawPlaybackBar(Application& app) {
  Playback& playback = app.extensions().playback;
  if (!playback.on()) return;
  const Look& l = look();
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(14), l.px(8)});
  const bool shown =
      beginPanel("playback", app.layout().strip, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (!shown) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Rectangle& r = app.layout().strip;
  draw->AddLine({r.low.x, r.low.y}, {r.high.x, r.low.y}, l.palette.line, std::max(1.0f, l.scale));
  keys(playback);

  const float whole = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  if (button("playback/play", playback.running() ? tr("Pause") : tr("Play"), ButtonLook::Primary, l.tx(72)))
    playback.setRunning(!playback.running());
  tip(trf("Space; arrows left and right by {0}, with Shift from mark to mark",
          quantityText(5, Dimension::Time, decimals(0)))
          .c_str());
  ImGui::SameLine();
  const std::string length = clockText(saturateToInteger<int>(playback.timeline().length_s())),
                    time = clockText(saturateToInteger<int>(playback.at_s())) + " / " + length;
  // If room is short, the time has priority over the words.
  const bool wide = whole > l.tx(430);
  const float time_w = wide ? ImGui::CalcTextSize((length + " / " + length).c_str()).x + l.px(6) + gap : 0.0f;
  drawScrubber(playback, whole - l.tx(72) - l.tx(58) - time_w - 2 * gap);
  ImGui::SameLine();
  const float y = ImGui::GetCursorPosY();
  if (wide) {
    ImGui::SetCursorPosY(y + std::max(0.0f, 0.5f * (l.tx(30) - ImGui::GetFontSize())));
    WithText quiet(l.palette.quiet);
    ImGui::TextUnformatted(time.c_str());
    recordItem("playback/time", time);
  }
  ImGui::SameLine(l.px(14) + whole - l.tx(58));
  ImGui::SetCursorPosY(y);
  drawSpeed(playback);

  // The last event is shown if there is room beside the switches.
  const float switches = l.tx(350), close_w = l.tx(72);
  const bool roomy = whole > switches + l.tx(120);
  const std::string words = (wide ? "" : time + "  ") + summaryText(playback);
  {
    WithText quiet(l.palette.quiet);
    const float row = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(row + l.px(6));
    ImGui::TextUnformatted(elided(words, roomy ? whole - switches : whole - close_w - gap).c_str());
    recordItem("playback/told", words);
    ImGui::SameLine(l.px(14) + whole - (roomy ? switches - gap : close_w));
    ImGui::SetCursorPosY(row);
  }
  if (roomy) {
    if (button("playback/follow", playback.follows_view ? tr("View as it was") : tr("View is yours"), ButtonLook::Plain,
               l.tx(128)))
      playback.follows_view = !playback.follows_view;
    tip(tr("Whether the molecule turns as the student turned it, or only as you do"));
    ImGui::SameLine();
    if (button("playback/rests", playback.skips_rests ? tr("Rests left out") : tr("Rests shown"), ButtonLook::Plain,
               l.tx(124)))
      playback.skips_rests = !playback.skips_rests;
    tip(trf("Times when the hand lay still for more than {0}", quantityText(3, Dimension::Time, decimals(0))).c_str());
    ImGui::SameLine();
  }
  const bool close = button("playback/close", tr("Close"), ButtonLook::Plain, close_w);
  endPanel();
  if (close) playback.close();
}

}  // namespace moltact
