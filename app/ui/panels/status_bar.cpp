// The status bar: the device, the molecule, and for experts the timing of the 1 kHz loop and how much of the molecule
// is modelled. If room is short, the least important parts are left out first.
#include <optional>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

struct Segment {
  const char* name;
  std::string text;
  std::string tip;
  int need;       ///< 0: shown longest
  ImU32 dot = 0;  ///< a coloured dot before the text; 0: none
};

// "4 558": a thin space between thousands.
std::string grouped(std::size_t n) {
  std::string digits = std::to_string(n);
  for (int at = int(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), "\u00A0");
  return digits;
}

Segment loopSegment(const Application& app) {
  const Palette& p = look().palette;
  if (app.scene.servo().clock() == ServoClock::Frames)
    return {"status/loop", trf("{0}, virtual clock", quantityText(1000.0, Dimension::Frequency)), "", 3, p.good};
  if (app.scene.servo().clock() == ServoClock::Page)
    return {"status/loop", trf("{0}, with the picture", quantityText(1000.0, Dimension::Frequency)),
            tr("In a browser the touch loop runs with the picture: each frame runs one tick per elapsed millisecond."),
            3, p.good};
  const LoopHealth& h = app.scene.log().health();
  const ServoThread& thread = *app.scene.servo().thread();
  const RealtimeStatus status = thread.realtime();
  const char* kind = status == RealtimeStatus::Realtime   ? tr("real-time")
                     : status == RealtimeStatus::Ordinary ? tr("ordinary priority")
                                                          : tr("starting");
  const auto micro = [](double time_us, int digits) {
    return quantityText(time_us * 1e-6, Dimension::Time, {decimals(digits), "µs"});
  };
  const std::string late = micro(h.late_p99_us, 0);
  const std::string text = trf("{0}, {1}, late {2}, tick {3}", quantityText(h.rate_Hz, Dimension::Frequency), kind,
                               late, micro(h.work_mean_us, 1));
  std::string tip = trf(
      "The touch loop should run 1000 times a second. 99 of 100 ticks began at most {0} late; the longest took {1}; "
      "{2} were left out.",
      late, micro(h.work_max_us, 1), thread.missedTicks());
  if (status == RealtimeStatus::Ordinary)
    tip += std::string(" ") + tr("The system does not allow this program real-time priority, so ticks may come late "
                                 "while the picture is drawn.");
  const bool well = h.rate_Hz > 950 && (status == RealtimeStatus::Realtime || h.late_p99_us < 2000);
  return {"status/loop", text, tip, 3, well ? p.good : p.warn};
}

// The ratio between the hand's motion and the molecule: shown with a haptic device, or if the scale is not the
// molecule's default.
std::optional<Segment> scaleSegment(const Application& app) {
  const HapticSession& scene = app.scene;
  const bool magnified = scene.view().fit.magnification(scene.servo_settings.workspace) > 1.005;
  if (!scene.stage() || !(scene.servo().loop().device() || magnified)) return {};
  const DeviceLink::ScaleWords scale = app.extensions().device.scaleWords(app.scene);
  std::string text = scale.sentence;
  if (text.ends_with('.')) text.pop_back();
  if (magnified)
    text = trf("{0}, magnified {1} times", text,
               numberText(scene.view().fit.magnification(scene.servo_settings.workspace), decimals(1)));
  return Segment{"status/scale", text, scale.reason, 2, magnified ? look().palette.accent : 0};
}

}  // namespace

void drawStatusBar(Application& app) {
  const Look& l = look();
  WithFont small(Font::Small);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {l.px(14), 0});
  const bool shown =
      beginPanel("status bar", app.layout().status, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (!shown) return;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const Rectangle& r = app.layout().status;
  draw->PushClipRectFullScreen();
  draw->AddLine({r.low.x, r.low.y}, {r.high.x, r.low.y}, l.palette.line, std::max(1.0f, l.scale));
  draw->PopClipRect();

  const ServoSample& now = app.scene.log().latest();
  const RevealPolicy& policy = app.extensions().reveal_policy;
  std::vector<Segment> segments;
  segments.push_back({"status/contact",
                      policy.hidesTouch()                         ? policy.touchWord()
                      : app.scene.log().touching()                ? tr("touching")
                      : app.scene.log().felt()                    ? tr("a force is felt")
                      : now.contact.fault == Fault::StartedInside ? tr("inside")
                                                                  : tr("free"),
                      !policy.names(now.contact)
                          ? std::string()
                          : feltText(app.scene.stage().molecule.get(), now, app.scene.log().shownForce_N()),
                      0, app.scene.log().felt() ? l.palette.accent : l.palette.faint});
  segments.push_back({"status/device", tr(app.scene.servo().device().name.c_str()),
                      app.scene.servo().device().gives_force
                          ? ""
                          : tr("No force-feedback device is connected; the mouse or keyboard stands in for it."),
                      2});
  if (std::optional<Segment> scale = scaleSegment(app)) segments.push_back(*scale);
  // Tick times and the number of atoms would give away what is touched. They are also shown while methods are compared.
  const bool expert = app.settings.expert || app.panels.tabs.has("methods");
  if (!policy.all() && expert) segments.push_back(loopSegment(app));
  // A molecule that is not drawn is not named.
  if (app.scene.stage() && !policy.all() && !app.scene.look.drawsNothing()) {
    const Molecule& m = *app.scene.stage().molecule;
    segments.push_back(
        {"status/molecule", m.id.empty() ? app.scene.molecule().file.filename().string() : m.id, m.title, 1});
    if (!app.scene.playedHand().on() && expert)
      segments.push_back(
          {"status/modelled",
           trf("{0} of {1} atoms modelled", grouped(now.memory_usage.atoms_modelled), grouped(m.atoms.size())),
           tr("The tracker prepares only the atoms near your probe."), 4});
  }
  if (app.loading()) segments.push_back({"status/loading", tr("Opening …"), "", 0, l.palette.warn});

  const float gap = l.px(22), dot = l.px(14);
  const auto width = [&](const Segment& s) { return ImGui::CalcTextSize(s.text.c_str()).x + (s.dot ? dot : 0.0f); };
  for (int need = 4; need > 0; --need) {
    float total = -gap;
    for (const Segment& s : segments) total += width(s) + gap;
    if (total <= r.size().x - 2 * l.px(14)) break;
    std::erase_if(segments, [&](const Segment& s) { return s.need == need; });
  }
  float x = r.low.x + l.px(14);
  const float y = std::round(0.5f * (r.low.y + r.high.y - ImGui::GetFontSize()));
  for (const Segment& s : segments) {
    if (s.dot) {
      draw->AddCircleFilled({x + l.px(4), 0.5f * (r.low.y + r.high.y)}, l.px(4), s.dot, 20);
      x += dot;
    }
    ImGui::SetCursorScreenPos({x, y});
    WithText quiet(l.palette.quiet);
    ImGui::TextUnformatted(s.text.c_str());
    recordItem(s.name, s.text);
    tip(s.tip.c_str());
    x += ImGui::CalcTextSize(s.text.c_str()).x + gap;
  }
  endPanel();
}

}  // namespace moltact
