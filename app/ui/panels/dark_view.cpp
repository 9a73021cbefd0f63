#include "app/ui/panels/dark_view.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

// The same colours in every theme.
constexpr ImU32 kGround = IM_COL32(13, 15, 19, 255), kTrack = IM_COL32(46, 51, 61, 255),
                kBright = IM_COL32(232, 236, 242, 255);
constexpr ImU32 kQuiet = IM_COL32(152, 160, 173, 255), kFill = IM_COL32(72, 199, 182, 255);

constexpr float kPi = std::numbers::pi_v<float>;
constexpr float kFrom = 0.75f * kPi, kTo = 2.25f * kPi;  // of the meter's arc, which is open at the bottom

void centred(const char* name, ImFont* font, const std::string& text, ImVec2 middle, float width, ImU32 colour) {
  const ImVec2 size = font->CalcTextSizeA(font->FontSize, 1e9f, width, text.c_str());
  const ImVec2 low{std::round(middle.x - 0.5f * size.x), std::round(middle.y - 0.5f * size.y)};
  ImGui::GetWindowDrawList()->AddText(font, font->FontSize, low, colour, text.c_str(), nullptr, width);
  recordRectangle(name, {low.x, low.y}, {low.x + size.x, low.y + size.y}, text);
}

// An arc that is full at the largest force that the hand can receive.
void drawMeter(double force_N, double max_N, ImVec2 middle, float radius) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float thick = 0.13f * radius;
  const auto arc = [&](float to, ImU32 colour) {
    draw->PathArcTo(middle, radius, kFrom, to, 64);
    draw->PathStroke(colour, 0, thick);
    for (const float end : {kFrom, to})
      draw->AddCircleFilled({middle.x + radius * std::cos(end), middle.y + radius * std::sin(end)}, 0.5f * thick,
                            colour, 24);
  };
  arc(kTo, kTrack);
  const float part = max_N > 0.0 ? float(std::clamp(force_N / max_N, 0.0, 1.0)) : 0.0f;
  if (part > 0.004f) arc(kFrom + (kTo - kFrom) * part, kFill);
  const std::string text = quantityText(force_N, Dimension::Force, decimals(1));
  centred("view/force meter", look().font(Font::Title), text, {middle.x, middle.y + 0.86f * radius}, 0.0f, kBright);
}

// The direction of the surface's push as a force-feedback device renders it. The arrow is the lateral part; a purely
// lateral push reaches the ring. A push straight toward the user is a dot in the middle.
void drawDirection(const Vec3& direction, ImVec2 middle, float radius) {
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddCircle(middle, radius, kTrack, 64, look().px(1.5f));
  draw->AddCircleFilled(middle, look().px(3), kTrack, 20);
  if (direction == Vec3(0.0)) return;
  const float thick = look().px(4), head = look().px(13);
  const ImVec2 way{radius * float(direction.x), -radius * float(direction.y)};
  const float length = std::hypot(way.x, way.y);
  draw->AddCircleFilled(middle, look().px(5), kBright, 24);
  if (length > head) {
    const ImVec2 along{way.x / length, way.y / length}, across{-along.y, along.x};
    const ImVec2 tip{middle.x + way.x, middle.y + way.y}, neck{tip.x - head * along.x, tip.y - head * along.y};
    draw->AddLine(middle, neck, kBright, thick);
    draw->AddTriangleFilled(tip, {neck.x + 0.55f * head * across.x, neck.y + 0.55f * head * across.y},
                            {neck.x - 0.55f * head * across.x, neck.y - 0.55f * head * across.y}, kBright);
  } else {
    draw->AddLine(middle, {middle.x + way.x, middle.y + way.y}, kBright, 2 * thick);
  }
}

}  // namespace

void drawDarkView(Application& app, const Rectangle& view) {
  const Look& l = look();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({view.low.x, view.low.y}, {view.high.x, view.high.y}, kGround);
  recordRectangle("view/dark", view.low, view.high, "dark");
  const TouchLog& log = app.scene.log();
  const ImVec2 middle{0.5f * (view.low.x + view.high.x), 0.5f * (view.low.y + view.high.y)};
  const float width = view.size().x - 2 * l.px(20),
              radius = std::min(l.px(78), 0.25f * std::min(view.size().x, view.size().y));
  float below = middle.y;
  if (app.extensions().task_stager.showsForce()) {
    const Vec3 push = pushInView(app.scene);
    drawMeter(log.force_N(), app.scene.servo_settings.max_force_N, middle, radius);
    drawDirection(push, middle, 0.72f * radius);
    below += radius + l.px(22);
    if (push != Vec3(0.0))
      centred("view/push", l.font(Font::Body), pushText(push), {middle.x, below + l.px(38)}, width, kQuiet);
  }
  centred("view/state", l.font(Font::Body), app.extensions().reveal_policy.touchWord(), {middle.x, below + l.px(14)},
          width, log.felt() ? kBright : kQuiet);
  drawDarkEnergy(app, view, {kBright, kQuiet});
  const bool pushes = app.scene.controls.pressing();
  const std::string hint = app.panels.window.fingers
                               ? (pushes ? tr("Slide with the finger; + and − push") : tr("Put a finger here to push"))
                           : pushes ? tr("Slide with the mouse or the arrow keys; wheel, + and − push")
                                    : tr("Hold the left button, or Space, to push");
  centred("view/hint", l.font(Font::Small), hint, {middle.x, view.high.y - l.px(26)}, width, kQuiet);
}

void drawDarkVeil(const Rectangle& view, float strength) {
  ImGui::GetWindowDrawList()->AddRectFilled({view.low.x, view.low.y}, {view.high.x, view.high.y},
                                            faded(kGround, strength));
}

bool drawnDark(Application& app) {
  if (!app.extensions().task_stager.dark()) return false;
  WithText quiet(look().palette.quiet);
  ImGui::TextWrapped("%s", tr("The screen is dark: what you feel is all there is."));
  recordItem("hidden in the dark");
  return true;
}

}  // namespace moltact
