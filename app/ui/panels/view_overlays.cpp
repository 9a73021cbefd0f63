#include "app/ui/panels/view_overlays.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/scene/view_picture.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr float kBeside_px = 40;  // at 96 dpi: the label keeps so far from the marks at the contact

// A line of text on a rounded ground, wrapped at `width`; returns its height.
float pill(const char* name, const std::string& text, ImVec2 anchor, ImVec2 pivot, float width, ImU32 ground,
           ImU32 colour, float alpha = 1.0f) {
  const Look& l = look();
  const ImVec2 pad{l.px(12), l.px(7)};
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - 2 * pad.x);
  const ImVec2 whole{size.x + 2 * pad.x, size.y + 2 * pad.y};
  const ImVec2 low{std::round(anchor.x - pivot.x * whole.x), std::round(anchor.y - pivot.y * whole.y)};
  const ImVec2 high{low.x + whole.x, low.y + whole.y};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(ground, 0.88f * alpha), l.px(8));
  draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + pad.x, low.y + pad.y}, faded(colour, alpha),
                text.c_str(), nullptr, size.x + 1);
  recordRectangle(name, {low.x, low.y}, {high.x, high.y}, text);
  return whole.y;
}

// A length of 1, 2 or 5 times a power of ten that takes 50 to 125 pixels at 96 dpi, at the target's depth.
void scaleBar(const Application& app, const Rectangle& view) {
  const Look& l = look();
  const double pixel_A = app.scene.camera.pixel_A(app.scene.camera.distance_A, int(view.size().y));
  if (!(pixel_A > 0.0) || !std::isfinite(pixel_A)) return;
  const double most_A = pixel_A * double(l.px(125));
  double length_A = std::pow(10.0, std::floor(std::log10(most_A)));
  for (const double step : {5.0, 2.0})
    if (length_A * step <= most_A) {
      length_A *= step;
      break;
    }
  const std::string text = quantityText(length_A, Dimension::Length, plain());
  const float width = saturateToFloat(length_A / pixel_A), x1 = view.high.x - l.px(18), x0 = x1 - width,
              y = view.high.y - l.px(20);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImU32 colour = l.palette.quiet;
  const float thick = std::max(1.0f, l.px(1.5f)), tick = l.px(4);
  ImFont* small = l.font(Font::Small);
  const ImVec2 size = small->CalcTextSizeA(small->FontSize, 1e9f, 0, text.c_str());
  const float pad = l.px(6), half = 0.5f * std::max(width, size.x), middle = 0.5f * (x0 + x1);
  draw->AddRectFilled({middle - half - pad, y - tick - size.y - 0.5f * pad}, {middle + half + pad, y + tick + pad},
                      faded(l.palette.panel, 0.75f), l.px(6));
  draw->AddLine({x0, y}, {x1, y}, colour, thick);
  draw->AddLine({x0, y - tick}, {x0, y + tick}, colour, thick);
  draw->AddLine({x1, y - tick}, {x1, y + tick}, colour, thick);
  draw->AddText(small, small->FontSize, {middle - 0.5f * size.x, y - tick - size.y}, colour, text.c_str());
  recordRectangle("view/scale bar", {x0, y - tick - size.y}, {x1, y + tick}, text);
}

// The force in newtons, a little beyond the arrow's head; beside the contact where the arrow points at the viewer.
void forceLabel(const Application& app, const ServoSample& now, const Rectangle& view) {
  const double force_N = app.scene.log().force_N();
  const Vec3& lift = now.contact.displacement_A;
  const double depth_A = glm::length(lift);
  if (!(force_N >= 0.05) || !(depth_A > 0.0)) return;
  const Look& l = look();
  const glm::vec2 size = view.size();
  const double pixel_A = app.scene.camera.pixel_A(app.scene.camera.distance_A, std::max(1, int(size.y)));
  const double arrow_A = pixel_A * double(l.px(kArrow_px_per_N) * saturateToFloat(force_N) + l.px(26));
  const Vec3 foot = app.scene.camera.project(now.contact.scp, int(size.x), int(size.y));
  Vec3 at = app.scene.camera.project({now.contact.scp.A + lift * (arrow_A / depth_A)}, int(size.x), int(size.y));
  const std::string text = quantityText(app.scene.log().shownForce_N(), Dimension::Force, decimals(1));
  ImFont* font = l.font(Font::Small);
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str());
  if (std::hypot(at.x - foot.x, at.y - foot.y) < double(l.px(kBeside_px)))
    at = foot + Vec3(double(l.px(kBeside_px) + 0.5f * extent.x), 0.0, 0.0);
  const float x = std::clamp(view.low.x + saturateToFloat(at.x) - 0.5f * extent.x, view.low.x + l.px(6),
                             view.high.x - extent.x - l.px(6));
  const float y = std::clamp(view.low.y + saturateToFloat(at.y) - 0.5f * extent.y, view.low.y + l.px(6),
                             view.high.y - extent.y - l.px(6));
  const ImVec2 pad{l.px(5), l.px(2)};
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({x - pad.x, y - pad.y}, {x + extent.x + pad.x, y + extent.y + pad.y},
                      faded(l.palette.panel, 0.85f), l.px(5));
  draw->AddText(font, font->FontSize, {x, y}, l.palette.text, text.c_str());
  recordRectangle("view/force", {x, y}, {x + extent.x, y + extent.y}, text);
}

const char* hintText(bool has_pressed, bool left_handed, bool fingers, bool body) {
  if (fingers)
    return has_pressed ? tr("Two fingers turn the molecule and magnify it")
                       : tr("Put a finger on the molecule to push against it");
  if (has_pressed && body)
    return left_handed ? tr("Drag with the left button to turn the molecule, with Ctrl to turn what you hold")
                       : tr("Drag with the right button to turn the molecule, with Ctrl to turn what you hold");
  if (has_pressed)
    return left_handed ? tr("Drag with the left button to turn the molecule, wheel to come closer")
                       : tr("Drag with the right button to turn the molecule, wheel to come closer");
  return left_handed ? tr("Hold the right button, or Space, to push against the molecule")
                     : tr("Hold the left button, or Space, to push against the molecule");
}

// A press that has come to rest tells how it goes on: until the person has done so once, and wherever a task waits for it.
bool wantsPushHint(const Application& app) {
  constexpr double kAtRest_s = 1.2;
  const ViewControls& controls = app.scene.controls;
  if (app.panels.fingers || app.scene.playing() || app.scene.servo().deviceLeads() ||
      controls.pressRested_s() < kAtRest_s)
    return false;
  const LessonSession* session = app.lesson.session();
  const Task* task = session && !app.panels.welcome ? session->taskAt(session->currentTask()) : nullptr;
  return !controls.hasPushed() || (task && task->wantsHarderPush());
}

// A press beside the molecule meets nothing: it is told where the eyes are.
void emptyPlaceNotice(const Application& app, const Rectangle& view) {
  constexpr double kSoon_s = 0.25;
  const ViewControls& controls = app.scene.controls;
  if (!controls.pressesNothing() || controls.pressRested_s() < kSoon_s || app.scene.playing() ||
      app.scene.servo().deviceLeads() || app.scene.log().touching())
    return;
  const Look& l = look();
  const std::string text = tr("There is nothing under the pointer here. Point at the molecule and push.");
  const float width = std::min(l.tx(260), view.size().x - l.px(28)), half = 0.5f * width + l.px(14);
  const glm::vec2 at = view.low + glm::vec2(controls.aim_px());
  const float x = std::clamp(at.x, view.low.x + half, std::max(view.low.x + half, view.high.x - half));
  const float y = std::clamp(at.y + l.px(24), view.low.y + l.px(14), view.high.y - l.tx(110));
  pill("view/nothing here", text, {x, y}, {0.5f, 0.0f}, width, l.palette.warn_soft, l.palette.text);
}

// What takes long is seen to go on: a bar that runs to and fro.
void loadingSign(const Application& app, const Rectangle& view) {
  constexpr double kLong_s = 0.5, kRound_s = 1.6;
  if (app.loadingFor_s() < kLong_s) return;
  const Look& l = look();
  const float width = std::min(l.tx(260), 0.8f * view.size().x), high = l.px(5),
              x0 = 0.5f * (view.low.x + view.high.x - width);
  const float y = 0.5f * (view.low.y + view.high.y);
  pill("view/loading", tr("Opening …"), {x0 + 0.5f * width, y - l.px(10)}, {0.5f, 1.0f}, width, l.palette.panel,
       l.palette.text);
  const double turn = std::fmod(app.now_s(), kRound_s) / kRound_s, part = turn < 0.5 ? 2.0 * turn : 2.0 - 2.0 * turn;
  const float knob = 0.3f * width, x = x0 + float(part) * (width - knob);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({x0, y}, {x0 + width, y + high}, l.palette.pressed, 0.5f * high);
  draw->AddRectFilled({x, y}, {x + knob, y + high}, l.palette.accent, 0.5f * high);
}

// The picture shows the former style meanwhile.
void surfaceSign(Application& app, const Rectangle& view, float width) {
  const std::optional<float> share = app.picture().surfaceProgress();
  if (!share) return;
  const Look& l = look();
  pill("view/surface", trf("The surface is being computed: {0} %", int(100.0f * *share)),
       {0.5f * (view.low.x + view.high.x), view.low.y + l.px(12)}, {0.5f, 0.0f}, width - l.px(84), l.palette.panel,
       l.palette.text);
}

}  // namespace

void drawViewOverlays(Application& app, const Rectangle& view) {
  const Look& l = look();
  const Palette& p = l.palette;
  const float margin = l.px(14), width = view.size().x - 2 * margin;
  if (width < l.px(120)) return;
  const ServoSample& now = app.scene.log().latest();

  const ImVec2 corner{view.high.x - l.px(42), view.low.y + l.px(12)};
  if (app.scene.stage())
    ImGui::GetWindowDrawList()->AddRectFilled(corner, {corner.x + l.px(30), corner.y + l.px(30)}, faded(p.panel, 0.75f),
                                              l.px(6));
  ImGui::SetCursorScreenPos(corner);
  if (app.scene.stage() &&
      iconButton("view/reset", Icon::Fit, (tr("Reset view") + (" (" + keysText("Home") + ")")).c_str()))
    app.resetViewByHand();

  loadingSign(app, view);
  if (!app.scene.stage()) {
    if (!app.loading())
      pill("view/empty", tr("Open a molecule or a lesson: File, Open, or drop a file here."),
           {0.5f * (view.low.x + view.high.x), 0.5f * (view.low.y + view.high.y)}, {0.5f, 0.5f}, width, p.panel,
           p.text);
    return;
  }
  drawColourLegend(app, view, drawStateSlider(app, view));
  drawDepthGauge(app, view);
  surfaceSign(app, view, width);
  if (now.contact.touching() && app.scene.shown.has(ViewPart::Force)) forceLabel(app, now, view);
  // Words stand left of the scale bar; in a narrow view they need all of it.
  const bool roomy = width > l.tx(320);
  if (roomy) scaleBar(app, view);
  const float bottom = view.high.y - margin, words = roomy ? width - l.tx(150) : width;
  const std::string measured = measuringText(app);
  float above = bottom;  // where the next pill ends
  if (now.contact.fault == Fault::StartedInside) {
    above -= l.px(8) + pill("view/state", contactText(app.scene.stage().molecule.get(), now.contact, 0.0),
                            {view.low.x + margin, bottom}, {0, 1}, words, p.warn_soft, p.warn);
  } else if (now.contact.touching()) {
    const WithFont font(app.settings.large_state_text ? Font::Heading : Font::Body);
    // The line rests a moment before it tells something new; by then it may be the first touch.
    const StateText& state = app.extensions().state_text;
    above -= l.px(8) + pill("view/state",
                            state.tellsContact()        ? state.line(app.scene)
                            : app.scene.touchesUnseen() ? unnamedContactText(now.contact)
                                                        : contactText(app.scene.stage().molecule.get(), now.contact,
                                                                      app.scene.log().shownForce_N()),
                            {view.low.x + margin, bottom}, {0, 1}, words, p.panel, p.text);
  } else if (const float hint = float(app.scene.controls.hintStrength());
             hint > 0.0f && measured.empty() && !app.scene.playing() && !app.scene.servo().deviceLeads()) {
    above -= l.px(8) + pill("view/hint",
                            hintText(app.scene.controls.hasPressed(), app.settings.left_handed, app.panels.fingers,
                                     app.scene.stage().body != nullptr),
                            {view.low.x + margin, bottom}, {0, 1}, words, p.panel, p.quiet, hint);
  }
  if (now.contact.touching() && wantsPushHint(app))
    above -= l.px(8) + pill("view/push hint",
                            tr("To push harder, keep it held and roll the wheel, move two fingers on the trackpad, or "
                               "press +; − is lighter."),
                            {view.low.x + margin, above}, {0, 1}, words, p.panel, p.text);
  emptyPlaceNotice(app, view);
  if (!measured.empty()) pill("view/measuring", measured, {view.low.x + margin, above}, {0, 1}, words, p.panel, p.text);
}

}  // namespace moltact
