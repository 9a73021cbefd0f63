#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/panels/lesson/lesson_keys.h"
#include "app/ui/panels/lesson/lesson_task_parts.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/figure_title.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr double kStep = 0.025;  // share of the axis that one press of an arrow moves the pen up or down

// The plotted area and its axes.
struct Area {
  ImVec2 low, high;
  double max_N;
  std::size_t points;

  float x(std::size_t k) const { return low.x + (high.x - low.x) * float(k) / float(points - 1); }
  float y(double force_N) const { return high.y - (high.y - low.y) * float(std::clamp(force_N / max_N, 0.0, 1.0)); }
  double force(float at_y) const { return max_N * double(std::clamp((high.y - at_y) / (high.y - low.y), 0.0f, 1.0f)); }
  std::size_t nearest(float at_x) const {
    return std::size_t(std::lround(std::clamp((at_x - low.x) / (high.x - low.x), 0.0f, 1.0f) * float(points - 1)));
  }
};

void drawCurve(const Area& area, const std::vector<double>& values, ImU32 colour, float thick, bool filled) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    const ImVec2 here{area.x(k), area.y(values[k])};
    if (k > 0 && std::isfinite(values[k - 1])) {
      const ImVec2 before{area.x(k - 1), area.y(values[k - 1])};
      if (filled)
        draw->AddQuadFilled(before, here, {here.x, area.high.y}, {before.x, area.high.y}, faded(colour, 0.16f));
      draw->AddLine(before, here, colour, thick);
    } else if (k + 1 >= values.size() || !std::isfinite(values[k + 1])) {
      draw->AddCircleFilled(here, thick, colour, 16);
    }
  }
}

void drawAxes(const Area& area, const TaskCurves& curves) {
  const Look& l = look();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImFont* font = l.font(Font::Small);
  const float size = font->FontSize;
  for (const double part : {0.0, 0.5, 1.0})
    draw->AddLine({area.low.x, area.y(part * area.max_N)}, {area.high.x, area.y(part * area.max_N)},
                  part > 0.0 ? l.palette.line : l.palette.faint, 1.0f);
  draw->AddLine({area.low.x, area.low.y}, {area.low.x, area.high.y}, l.palette.faint, 1.0f);
  const auto write = [&](ImVec2 at, float pivot, const char* what) {
    const float width = font->CalcTextSizeA(size, 1e9f, 0.0f, what).x;
    draw->AddText(font, size, {std::round(at.x - pivot * width), std::round(at.y)}, l.palette.quiet, what);
  };
  for (const double part : {0.5, 1.0}) {
    const std::string text = part == 1.0 ? quantityText(part * area.max_N, Dimension::Force, plain(2))
                                         : quantityNumber(part * area.max_N, Dimension::Force, plain(2));
    write({area.low.x - l.px(5), area.y(part * area.max_N) - 0.5f * size}, 1.0f, text.c_str());
  }
  write({area.low.x, area.high.y + l.px(3)}, 0.5f, "0");
  write({area.high.x, area.high.y + l.px(3)}, 1.0f, quantityText(curves.x_max_A, Dimension::Length, plain(2)).c_str());
  write({0.5f * (area.low.x + area.high.x), area.high.y + l.px(3)}, 0.5f,
        figureTitle(std::string(curves.x_name)).c_str());
}

void drawLegend(ImVec2 at, bool expected, bool felt, ImU32 drawn_colour, ImU32 felt_colour) {
  const Look& l = look();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  ImFont* font = l.font(Font::Small);
  const auto entry = [&](const char* what, ImU32 colour) {
    const float y = at.y + 0.5f * font->FontSize;
    draw->AddLine({at.x, y}, {at.x + l.px(16), y}, colour, l.px(2.5f));
    at.x += l.px(21);
    draw->AddText(font, font->FontSize, at, l.palette.quiet, what);
    at.x += font->CalcTextSizeA(font->FontSize, 1e9f, 0.0f, what).x + l.px(14);
  };
  if (expected) entry(tr("expected"), drawn_colour);
  if (felt) entry(tr("felt"), felt_colour);
}

// Draws from the last position of the mouse to the present one, so that a quick stroke has no gaps.
void drawWithMouse(const Area& area, CurveDraft& draft) {
  if (!ImGui::IsItemActive()) return;
  const ImGuiIO& io = ImGui::GetIO();
  const ImVec2 to = io.MousePos,
               from = ImGui::IsItemActivated() ? to : ImVec2{to.x - io.MouseDelta.x, to.y - io.MouseDelta.y};
  const std::size_t a = area.nearest(from.x), b = area.nearest(to.x);
  for (std::size_t k = std::min(a, b); k <= std::max(a, b); ++k) {
    const double part = a == b ? 1.0 : std::abs(double(k) - double(a)) / std::abs(double(b) - double(a));
    draft.values[k] = area.force(from.y + (to.y - from.y) * float(part));
  }
  draft.pen = b;
}

// Left and right move the pen along, up and down change its height. It draws only where nothing is drawn yet.
void drawWithArrows(const Area& area, CurveDraft& draft) {
  const auto times = [](ImGuiKey key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
  if (ImGui::GetIO().KeyShift) return;
  double& here = draft.values[draft.pen];
  const int up = times(ImGuiKey_UpArrow) - times(ImGuiKey_DownArrow),
            right = times(ImGuiKey_RightArrow) - times(ImGuiKey_LeftArrow);
  if (up != 0) here = std::clamp((std::isfinite(here) ? here : 0.0) + up * kStep * area.max_N, 0.0, area.max_N);
  if (right == 0 || (right < 0 && draft.pen == 0) || (right > 0 && draft.pen + 1 >= draft.values.size())) return;
  const double left_behind = std::isfinite(here) ? here : 0.0;
  here = left_behind;
  draft.pen = right > 0 ? draft.pen + 1 : draft.pen - 1;
  if (!std::isfinite(draft.values[draft.pen])) draft.values[draft.pen] = left_behind;
}

// Fills gaps and extends the ends, so that the curve has a value everywhere when it is handed in.
std::vector<double> whole(std::vector<double> values) {
  std::size_t last = values.size();
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (!std::isfinite(values[k])) continue;
    for (std::size_t hole = last == values.size() ? 0 : last + 1; hole < k; ++hole)
      values[hole] = last == values.size()
                         ? values[k]
                         : values[last] + (values[k] - values[last]) * double(hole - last) / double(k - last);
    last = k;
  }
  if (last < values.size())
    for (std::size_t k = last + 1; k < values.size(); ++k) values[k] = values[last];
  return values;
}

}  // namespace

void drawTaskCurve(Application& app, std::size_t index, const TaskCurves& curves, bool current) {
  const Look& l = look();
  const std::string name = "task/" + std::to_string(index);
  CurveDraft& draft = app.lesson.drafts().curves[index];
  if (draft.values.size() != curves.drawn.size()) draft = {curves.drawn, 0};
  const bool drawing = current && curves.drawing;

  const float width = ImGui::GetContentRegionAvail().x, small = l.font(Font::Small)->FontSize;
  const float left = l.tx(46), head = small + l.px(8), foot = small + l.px(6);
  const ImVec2 origin = ImGui::GetCursorScreenPos();
  const ImVec2 high{origin.x + width, origin.y + head + l.px(130) + foot};
  const Area area{
      {origin.x + left, origin.y + head}, {high.x - l.px(8), high.y - foot}, curves.max_N, curves.drawn.size()};
  ImGui::PushID(name.c_str());
  ImGui::InvisibleButton("curve", {width, high.y - origin.y});
  ImGui::PopID();
  if (drawing) {
    if (ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeAll);
    drawWithMouse(area, draft);
    // The arrows draw while no other control uses them.
    app.panels.arrows_draw = lessonKeysFree() && keysFree();
    const CurveDraft before = draft;
    if (app.panels.arrows_draw) drawWithArrows(area, draft);
    // With keys, the area may be partly out of view; scroll to it.
    const bool below = high.y > ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    if (below && draft.pen != before.pen) ImGui::SetScrollHereY(1.0f);
  }
  const bool any = std::any_of(draft.values.begin(), draft.values.end(), [](double v) { return std::isfinite(v); });
  std::string text = drawing ? any ? "drawing" : "empty" : "drawn";
  if (curves.agreement) text = quantityText(*curves.agreement, Dimension::Share);
  recordRectangle(name + "/curve", {area.low.x, area.low.y}, {area.high.x, area.high.y}, text);

  ImGui::GetWindowDrawList()->AddRectFilled(area.low, area.high, l.palette.raised);
  drawAxes(area, curves);
  const bool felt = std::any_of(curves.felt.begin(), curves.felt.end(), [](double v) { return std::isfinite(v); });
  const bool expects = curves.drawing || any;
  drawLegend({area.low.x, origin.y}, expects, felt, l.palette.accent, l.palette.warn);
  if (felt) drawCurve(area, curves.felt, l.palette.warn, l.px(2.2f), true);
  drawCurve(area, drawing ? draft.values : curves.drawn, l.palette.accent, l.px(2.2f), false);
  if (curves.agreement) {
    const std::string agree = trf("{0} in common", text);
    ImFont* font = l.font(Font::Small);
    const float agree_w = font->CalcTextSizeA(small, 1e9f, 0.0f, agree.c_str()).x;
    ImGui::GetWindowDrawList()->AddText(font, small, {area.high.x - agree_w, origin.y}, l.palette.text, agree.c_str());
  }
  if (!drawing) return;

  const double at = std::isfinite(draft.values[draft.pen]) ? draft.values[draft.pen] : 0.0;
  const ImVec2 pen{area.x(draft.pen), area.y(at)};
  ImGui::GetWindowDrawList()->AddCircleFilled(pen, l.px(5), l.palette.accent, 24);
  ImGui::GetWindowDrawList()->AddCircleFilled(pen, l.px(2.5f), l.palette.panel, 24);
  if (!any) {
    const char* how = tr("Draw here with the mouse or the arrow keys");
    ImFont* font = l.font(Font::Small);
    const float how_w = font->CalcTextSizeA(small, 1e9f, 0.0f, how).x;
    ImGui::GetWindowDrawList()->AddText(
        font, small, {std::round(0.5f * (area.low.x + area.high.x - how_w)), area.y(0.75 * area.max_N)},
        l.palette.quiet, how);
  }
  const float wipe_w = l.tx(70), gap = ImGui::GetStyle().ItemSpacing.x;
  if ((button((name + "/hand in").c_str(), withKey(tr("This is what I expect"), "Enter").c_str(), ButtonLook::Primary,
              width - wipe_w - gap, any) ||
       lessonKeyOnItem(app, '\n', name + "/hand in")) &&
      any) {
    draft.values = whole(draft.values);
    app.lesson.session()->answerTask({{}, draft.values});
  }
  ImGui::SameLine();
  if (button((name + "/wipe").c_str(), tr("Wipe"), ButtonLook::Plain, wipe_w, any))
    draft = {std::vector<double>(curves.drawn.size(), std::numeric_limits<double>::quiet_NaN()), 0};
}

}  // namespace moltact
