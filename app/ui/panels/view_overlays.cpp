#include "app/ui/panels/view_overlays.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/push_pads.h"
#include "app/ui/scene/body_place.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/scene/view_picture.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr float kBeside_px = 40;  // at 96 dpi: distance of the label from the marks at the contact

// An overlap of half a pixel is ignored.
bool overlap(const Rectangle& a, const Rectangle& b) {
  constexpr float kNone = 0.5f;
  return a.low.x < b.high.x - kNone && b.low.x < a.high.x - kNone && a.low.y < b.high.y - kNone &&
         b.low.y < a.high.y - kNone;
}

ImVec2 pillSize(const std::string& lines, float width) {
  const Look& l = look();
  const ImVec2 size = ImGui::CalcTextSize(lines.c_str(), nullptr, false, width - 2 * l.px(12));
  return {size.x + 2 * l.px(12), size.y + 2 * l.px(7)};
}

// Draws a line of text on a rounded background, wrapped at `width`, and takes its place; returns its height. Text that
// does not fit in the view is left out.
float drawPill(ViewRoom& room, const char* name, const std::string& text, ImVec2 anchor, ImVec2 pivot, float width,
               ImU32 ground, ImU32 colour, float alpha = 1.0f) {
  const Look& l = look();
  const ImVec2 pad{l.px(12), l.px(7)};
  const std::string lines = wrapped(text, width - 2 * pad.x);
  const ImVec2 size = ImGui::CalcTextSize(lines.c_str(), nullptr, false, width - 2 * pad.x);
  const ImVec2 whole{size.x + 2 * pad.x, size.y + 2 * pad.y};
  const ImVec2 low{std::round(anchor.x - pivot.x * whole.x), std::round(anchor.y - pivot.y * whole.y)};
  const ImVec2 high{low.x + whole.x, low.y + whole.y};
  if (low.y < room.view.low.y) return -l.px(8);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled(low, high, faded(ground, 0.88f * alpha), l.px(8));
  draw->AddText(ImGui::GetFont(), ImGui::GetFontSize(), {low.x + pad.x, low.y + pad.y}, faded(colour, alpha),
                lines.c_str(), nullptr, size.x + 1);
  recordRectangle(name, {low.x, low.y}, {high.x, high.y}, text);
  room.take({{low.x, low.y}, {high.x, high.y}});
  return whole.y;
}

// A length of 1, 2 or 5 times a power of ten that takes 50 to 125 pixels at 96 dpi, at the target's depth.
void scaleBar(const Application& app, ViewRoom& room) {
  const Rectangle& view = room.view;
  const Look& l = look();
  const double pixel_A = app.scene.camera.pixel_A(app.scene.camera.distance_A, int(room.whole.size().y));
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
  room.take({{middle - half - pad, y - tick - size.y - 0.5f * pad}, {middle + half + pad, y + tick + pad}});
}

// The force in newtons, a little beyond the arrow's head, or beside the contact if the arrow points at the viewer. If
// that place is taken, the other sides of the contact are tried; the line below shows the force too.
void forceLabel(const Application& app, const ServoSample& now, ViewRoom& room) {
  const Rectangle& view = room.view;
  const double force_N = app.scene.log().force_N();
  const Vec3 lift = now.forceDirection();
  const double depth_A = glm::length(lift);
  if (!(force_N >= 0.05) || !(depth_A > 0.0)) return;
  const Look& l = look();
  const glm::vec2 size = room.whole.size();
  const double pixel_A = app.scene.camera.pixel_A(app.scene.camera.distance_A, std::max(1, int(size.y)));
  const double arrow_A = pixel_A * double(l.px(kArrow_px_per_N) * saturateToFloat(force_N) + l.px(26));
  const Vec3 foot = app.scene.camera.project(now.forcePlace(), int(size.x), int(size.y));
  Vec3 at = app.scene.camera.project({now.forcePlace().A + lift * (arrow_A / depth_A)}, int(size.x), int(size.y));
  std::string text = quantityText(app.scene.log().shownForce_N(), Dimension::Force, decimals(1));
  if (const std::size_t contacts = app.scene.bodyContacts().count;
      contacts > 0 && app.extensions().reveal_policy.names(now.contact))
    text += ", " + trnf("{0} contact", "{0} contacts", contacts, contacts);
  ImFont* font = l.font(Font::Small);
  const ImVec2 extent = font->CalcTextSizeA(font->FontSize, 1e9f, 0, text.c_str());
  const Vec3 aside(double(l.px(kBeside_px) + 0.5f * extent.x), 0.0, 0.0), upward(0.0, double(l.px(kBeside_px)), 0.0);
  if (std::hypot(at.x - foot.x, at.y - foot.y) < double(l.px(kBeside_px))) at = foot + aside;
  const ImVec2 pad{l.px(5), l.px(2)};
  for (const Vec3& place : {at, foot + aside, foot - aside, foot - upward, foot + upward}) {
    const float x = std::clamp(room.whole.low.x + saturateToFloat(place.x) - 0.5f * extent.x, view.low.x + l.px(6),
                               view.high.x - extent.x - l.px(6));
    const float y = std::clamp(room.whole.low.y + saturateToFloat(place.y) - 0.5f * extent.y, view.low.y + l.px(6),
                               view.high.y - extent.y - l.px(6));
    const Rectangle ground{{x - pad.x, y - pad.y}, {x + extent.x + pad.x, y + extent.y + pad.y}};
    if (!room.isFree(ground)) continue;
    ImDrawList* draw = ImGui::GetWindowDrawList();
    draw->AddRectFilled({ground.low.x, ground.low.y}, {ground.high.x, ground.high.y}, faded(l.palette.panel, 0.85f),
                        l.px(5));
    draw->AddText(font, font->FontSize, {x, y}, l.palette.text, text.c_str());
    recordRectangle("view/force", {x, y}, {x + extent.x, y + extent.y}, text);
    return;
  }
}

// Whether the scene leaves anything to touch: the box of an empty grid has no size.
bool hasSurface(const HapticSession& scene) {
  return !scene.stage() || scene.stage().spheres->low_A() != scene.stage().spheres->high_A();
}

const char* hintText(bool has_pressed, bool left_handed, bool fingers, bool body) {
  if (fingers && has_pressed && body) return tr("Two fingers turn what you hold, three the molecule");
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

// Once a press has come to rest, a hint explains the next control. It is shown until the user has used it once, and
// whenever a task waits for it.
bool wantsPushHint(const Application& app) {
  constexpr double kAtRest_s = 1.2;
  const ViewControls& controls = app.scene.controls;
  if (app.panels.window.fingers || app.scene.playedHand().on() || app.scene.servo().deviceLeads() ||
      controls.pressRested_s() < kAtRest_s)
    return false;
  const LessonSession* session = app.lesson.session();
  const Task* task = session && !app.panels.pages.welcome ? session->taskAt(session->currentTask()) : nullptr;
  return !controls.hasPushed() || (task && task->wantsHarderPush());
}

// How much of the held body is back at the place that the scene marks.
std::string inPlaceText(const Application& app) {
  const HapticSession& scene = app.scene;
  const LessonSession* session = app.lesson.session();
  if (!session || !app.lesson.onStage() || !scene.stage().body || !session->scene().highlight.given()) return {};
  const std::vector<std::uint32_t> marked = session->scene().highlight.select(*scene.stage().molecule);
  const std::vector<std::uint32_t>& held = scene.stage().body->atoms;
  if (!std::includes(marked.begin(), marked.end(), held.begin(), held.end())) return {};
  const BodyPlace place = bodyPlace(scene.stage(), scene.log().latest());
  const std::string within = quantityText(kInPlace_A, Dimension::Length, decimals(0));
  std::string text = trf("{0} of {1} atoms in place, to {2}", place.in_place, place.atoms, within);
  if (const std::size_t stopped = scene.bodyContacts().body.size(); stopped > 0)
    text += "; " + trnf("{0} is stopped", "{0} are stopped", stopped, stopped);
  return text;
}

// A press beside the molecule touches nothing. The notice is below the pointer, or above it if that place is taken.
void emptyPlaceNotice(const Application& app, ViewRoom& room) {
  constexpr double kSoon_s = 0.25;
  const ViewControls& controls = app.scene.controls;
  if (!controls.pressesNothing() || controls.pressRested_s() < kSoon_s || app.scene.playedHand().on() ||
      app.scene.servo().deviceLeads() || app.scene.log().felt())
    return;
  const Look& l = look();
  const Rectangle& view = room.view;
  const std::string text = tr("There is nothing under the pointer here. Point at the molecule and push.");
  const float width = std::min(l.tx(260), view.size().x - l.px(28)), half = 0.5f * width;
  const ImVec2 size = pillSize(wrapped(text, width - 2 * l.px(12)), width);
  const glm::vec2 at = room.whole.low + glm::vec2(controls.aim_px());
  const float x = std::clamp(at.x, view.low.x + half, std::max(view.low.x + half, view.high.x - half));
  for (const float low : {at.y + l.px(24), at.y - l.px(24) - size.y, view.low.y + l.px(14)}) {
    const float y = std::clamp(low, view.low.y + l.px(14), std::max(view.low.y + l.px(14), view.high.y - size.y));
    for (const float aside : {0.0f, 0.6f * size.x, -0.6f * size.x}) {
      const float middle = std::clamp(x + aside, view.low.x + half, std::max(view.low.x + half, view.high.x - half));
      if (!room.isFree({{middle - 0.5f * size.x, y}, {middle + 0.5f * size.x, y + size.y}})) continue;
      drawPill(room, "view/nothing here", text, {middle, y}, {0.5f, 0.0f}, width, l.palette.warn_soft, l.palette.text);
      return;
    }
  }
}

}  // namespace

bool mayNameAtoms(const Application& app) {
  if (app.extensions().task_stager.dark() || app.extensions().reveal_policy.all() || app.scene.playedHand().on() ||
      app.extensions().playback.on())
    return false;
  return !app.lesson.session() || !app.lesson.onStage() || app.lesson.session()->stepDone();
}

namespace {

// Shows the name of the atom under the pointer while it does not push.
void hoveredAtom(const Application& app, ViewRoom& room) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!mayNameAtoms(app) || app.panels.window.fingers || app.scene.controls.pressing() || ImGui::IsAnyMouseDown() ||
      app.scene.log().felt() || !ImGui::IsMousePosValid() || !ImGui::IsWindowHovered() || ImGui::IsAnyItemActive())
    return;
  const glm::dvec2 at(double(io.MousePos.x - room.whole.low.x), double(io.MousePos.y - room.whole.low.y));
  const glm::dvec2 size(room.whole.size());
  if (at.x < 0 || at.y < 0 || at.x >= size.x || at.y >= size.y) return;
  const auto atom = atomAt(app.scene, at, size);
  const AtomList& hidden = app.scene.look.atoms.hidden;
  if (!atom || (hidden && std::binary_search(hidden->begin(), hidden->end(), *atom))) return;
  const Look& l = look();
  const WithFont small(Font::Small);
  const std::string text = atomText(*app.scene.stage().molecule, *atom, true);
  const float width = std::min(l.tx(280), room.view.size().x - l.px(28));
  const ImVec2 extent = pillSize(wrapped(text, width - 2 * l.px(12)), width);
  const float x =
      std::clamp(io.MousePos.x + l.px(14), room.view.low.x, std::max(room.view.low.x, room.view.high.x - extent.x));
  for (const float y : {io.MousePos.y - l.px(12) - extent.y, io.MousePos.y + l.px(20)}) {
    if (y < room.view.low.y || y + extent.y > room.view.high.y || !room.isFree({{x, y}, {x + extent.x, y + extent.y}}))
      continue;
    drawPill(room, "view/under the pointer", text, {x, y}, {0.0f, 0.0f}, width, l.palette.panel, l.palette.text);
    return;
  }
}

// An animated bar during slow loading.
void loadingSign(const Application& app, ViewRoom& room) {
  const Rectangle& view = room.view;
  constexpr double kLong_s = 0.5, kRound_s = 1.6;
  if (app.loadingFor_s() < kLong_s) return;
  const Look& l = look();
  const float width = std::min(l.tx(260), 0.8f * view.size().x), high = l.px(5),
              x0 = 0.5f * (view.low.x + view.high.x - width);
  const float y = 0.5f * (view.low.y + view.high.y);
  drawPill(room, "view/loading", tr("Opening …"), {x0 + 0.5f * width, y - l.px(10)}, {0.5f, 1.0f}, width,
           l.palette.panel, l.palette.text);
  const double turn = std::fmod(app.now_s(), kRound_s) / kRound_s, part = turn < 0.5 ? 2.0 * turn : 2.0 - 2.0 * turn;
  const float knob = 0.3f * width, x = x0 + float(part) * (width - knob);
  ImDrawList* draw = ImGui::GetWindowDrawList();
  draw->AddRectFilled({x0, y}, {x0 + width, y + high}, l.palette.pressed, 0.5f * high);
  draw->AddRectFilled({x, y}, {x + knob, y + high}, l.palette.accent, 0.5f * high);
}

void drawReset(Application& app, ViewRoom& room) {
  const Look& l = look();
  const float side = l.px(30);
  const ImVec2 low{room.view.high.x - l.px(42), room.view.low.y + l.px(12)};
  const Rectangle place{{low.x, low.y}, {low.x + side, low.y + side}};
  if (!room.isFree(place)) return;
  room.take(place);
  ImGui::GetWindowDrawList()->AddRectFilled(low, {low.x + side, low.y + side}, faded(l.palette.panel, 0.75f), l.px(6));
  ImGui::SetCursorScreenPos(low);
  if (iconButton("view/reset", Icon::Fit, (tr("Reset view") + (" (" + keysText("Home") + ")")).c_str()))
    app.resetViewByHand();
}

// The view's part below the messages, which cover its upper edge.
Rectangle belowMessages(const Application& app, Rectangle view) {
  view.low.y = std::clamp(app.panels.window.messages_end, view.low.y, std::max(view.low.y, view.high.y - 1.0f));
  return view;
}

// Meanwhile the picture shows the previous style, or grey atoms.
void surfaceSign(Application& app, ViewRoom& room, float width) {
  const std::optional<float> surface = app.picture().surfaceProgress(),
                             potential = app.extensions().potential_colours.progress();
  if (!surface && !potential) return;
  const Look& l = look();
  drawPill(room, "view/surface",
           surface ? trf("The surface is being computed: {0} %", int(100.0f * *surface))
                   : trf("The potential is being computed: {0} %", int(100.0f * *potential)),
           {0.5f * (room.view.low.x + room.view.high.x), room.view.low.y + l.px(12)}, {0.5f, 0.0f}, width - l.px(84),
           l.palette.panel, l.palette.text);
}

}  // namespace

bool ViewRoom::isFree(const Rectangle& place) const {
  return std::none_of(taken_.begin(), taken_.end(), [&](const Rectangle& t) { return overlap(t, place); });
}

void drawViewOverlays(Application& app, const Rectangle& whole_view) {
  const Look& l = look();
  const Palette& p = l.palette;
  ViewRoom room{whole_view, belowMessages(app, whole_view)};
  const Rectangle& view = room.view;
  const float margin = l.px(14), width = view.size().x - 2 * margin;
  if (width < l.px(120)) return;
  const ServoSample& now = app.scene.log().latest();
  const auto pill = [&](const auto&... what) { return drawPill(room, what...); };

  loadingSign(app, room);
  if (!app.scene.stage()) {
    if (!app.loading())
      pill("view/empty", tr("Open a molecule or a lesson: File, Open, or drop a file here."),
           ImVec2(0.5f * (view.low.x + view.high.x), 0.5f * (view.low.y + view.high.y)), ImVec2(0.5f, 0.5f), width,
           p.panel, p.text);
    return;
  }
  for (const auto draw : {drawStateSlider, drawTrajectoryBar})
    if (const Rectangle slider = draw(app, view); !slider.empty()) {
      room.take(slider);
      room.slider = slider;
    }
  if (const Rectangle pads = pushPadsPlace(app, whole_view); !pads.empty()) room.take(pads);
  drawScanCard(app, room);
  surfaceSign(app, room, width);
  // Text is left of the scale bar; in a narrow view it needs the whole width.
  const bool roomy = width > l.tx(320);
  if (roomy) scaleBar(app, room);
  const float bottom = view.high.y - margin, words = roomy ? width - l.tx(150) : width;
  const std::string measured = measuringText(app);
  float above = bottom;  // lower edge of the next pill
  if (now.contact.fault == Fault::StartedInside) {
    above -= l.px(8) + pill("view/state",
                            contactText(app.scene.stage().molecule.get(), now.contact, 0.0, true, now.holds_body),
                            ImVec2(view.low.x + margin, bottom), ImVec2(0, 1), words, p.warn_soft, p.warn);
  } else if (now.felt()) {
    const WithFont font(app.settings.large_state_text ? Font::Heading : Font::Body);
    // The text lags a moment behind the state. The present state may already be the first touch.
    const StateText& state = app.extensions().state_text;
    above -= l.px(8) + pill("view/state",
                            state.tellsContact() ? state.line(app.scene)
                            : !app.extensions().reveal_policy.names(now.contact)
                                ? unnamedContactText(now.contact, true)
                                : feltText(app.scene.stage().molecule.get(), now, app.scene.log().shownForce_N()),
                            ImVec2(view.low.x + margin, bottom), ImVec2(0, 1), words, p.panel, p.text);
  } else if (const float hint = float(app.scene.controls.hintStrength());
             hint > 0.0f && measured.empty() && hasSurface(app.scene) && !app.scene.playedHand().on() &&
             !app.scene.servo().deviceLeads()) {
    above -= l.px(8) + pill("view/hint",
                            hintText(app.scene.controls.hasPressed(), app.settings.left_handed,
                                     app.panels.window.fingers, app.scene.stage().body != nullptr),
                            ImVec2(view.low.x + margin, bottom), ImVec2(0, 1), words, p.panel, p.quiet, hint);
  }
  if (const std::string limits = limitText(app); !limits.empty()) {
    const bool stopped = app.scene.servo_settings.panic;
    above -= l.px(8) + pill("limits", limits, ImVec2(view.low.x + margin, above), ImVec2(0, 1), words,
                            stopped ? p.bad_soft : p.warn_soft, p.text);
  }
  if (now.contact.touching() && wantsPushHint(app))
    above -= l.px(8) + pill("view/push hint",
                            tr("To push harder, keep it held and roll the wheel, move two fingers on the trackpad, or "
                               "press +; − is lighter."),
                            ImVec2(view.low.x + margin, above), ImVec2(0, 1), words, p.panel, p.text);
  if (const std::string text = inPlaceText(app); !text.empty())
    above -= l.px(8) + pill("view/in place", text, ImVec2(view.low.x + margin, above), ImVec2(0, 1), words,
                            p.accent_soft, p.text);
  if (!measured.empty())
    above -= l.px(8) +
             pill("view/measuring", measured, ImVec2(view.low.x + margin, above), ImVec2(0, 1), words, p.panel, p.text);
  room.words_top = above;
  drawReset(app, room);
  drawColourLegend(app, room);
  drawDepthGauge(app, room, roomy ? view.high.y - l.px(64) : above);
  drawEnergyGauge(app, room, roomy ? view.high.y - l.px(64) : above);
  if (now.felt() && app.scene.look.shown.has(ViewPart::Force)) forceLabel(app, now, room);
  emptyPlaceNotice(app, room);
  hoveredAtom(app, room);
}

}  // namespace moltact
