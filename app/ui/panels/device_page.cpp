// View > Device: the list of devices. For the one in use: live state, calibration, a gentle test force, the limits in
// force, the timing of the loop and the meaning of the scale.
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "app/ui/application/application.h"
#include "app/ui/extensions/device_link.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/rich_text.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/saturated.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

void words(const char* name, const std::string& text, ImU32 colour) {
  WithText coloured(colour);
  drawWrapped(name, text);
}

// Above the scrolled part.
void drawStop(Application& app, DeviceLink& link) {
  const Palette& p = look().palette;
  const bool panic = app.scene.servo_settings.panic;
  if (button("device/stop", panic ? tr("Allow force again (F9)") : tr("Stop all force (F9)"),
             panic ? ButtonLook::Primary : ButtonLook::Plain))
    app.scene.force().stop(!panic);
  std::string acted;
  for (const LimitWords* one : link.actingLimits()) acted += (acted.empty() ? "" : ", ") + std::string(tr(one->name));
  ImGui::SameLine(0, look().px(12));
  ImGui::AlignTextToFramePadding();
  words("device/acting", acted.empty() ? tr("No limit acts.") : trf("Acting: {0}", acted),
        acted.empty() ? p.quiet : p.warn);
  ImGui::Dummy({0, look().px(2)});
}

void drawUsable(DeviceLink& link) {
  sectionTitle(tr("Choose a device"));
  if (link.found().empty()) words("device/looking", tr("Looking …"), look().palette.quiet);
  for (const FoundDevice& one : link.found()) {
    if (!one.usable) continue;
    const std::string name = "device/" + one.name;
    if (button(name.c_str(), tr(one.title.c_str()), one.name == link.chosen() ? ButtonLook::Primary : ButtonLook::Plain,
               -1.0f))
      link.choose(one.name);
    if (one.place.empty()) continue;
    WithFont small(Font::Small);
    words((name + "/place").c_str(), one.place, look().palette.quiet);
  }
  if (!link.opening().empty())
    words("device/opening", trf("{0} is being opened …", link.opening()), look().palette.quiet);
  if (devicesAreAskedFor() && button("device/ask", tr("Show this page a device …"), ButtonLook::Plain, -1.0f))
    askForDevice();
}

// One field for each driver that takes an address.
void drawAddresses(DeviceLink& link) {
  const Look& l = look();
  for (const DeviceDriver& driver : deviceDrivers()) {
    if (!driver.find_at) continue;
    const std::string name = "device/" + std::string(driver.name), field = "##" + name;
    std::string& typed = link.address(driver);
    const FoundDevice there = driver.find_at(typed);
    const std::string device = std::string(driver.name) + ':' + typed;
    ImGui::Dummy({0, l.px(2)});
    words((name + "/title").c_str(), tr(there.title.c_str()), l.palette.text);
    const char* const connect = tr("Connect");
    const float width = ImGui::CalcTextSize(connect).x + 2.0f * ImGui::GetStyle().FramePadding.x + l.px(24);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - width - l.px(8));
    std::optional<FieldAsHighAsButton> high(std::in_place);
    bool asked = ImGui::InputTextWithHint(field.c_str(), std::string(driver.address_example).c_str(), &typed,
                                          ImGuiInputTextFlags_EnterReturnsTrue);
    high.reset();
    recordItem(name + "/address", typed);
    ImGui::SameLine(0, l.px(8));
    asked = button((name + "/connect").c_str(), connect,
                   device == link.chosen() ? ButtonLook::Primary : ButtonLook::Plain, -1.0f, there.usable) ||
            asked;
    if (asked && there.usable) link.choose(device);
    const std::string& below = there.usable ? there.note : there.why;
    if (typed.empty() || below.empty()) continue;
    const WithFont small(Font::Small);
    words((name + "/note").c_str(), below, l.palette.warn);
  }
}

// Devices that are listed although they cannot be used.
bool listedUnusable(const FoundDevice& one) {
  const DeviceDriver* const driver = findDriver(one.name);
  return !one.usable && !(driver && driver->find_at);
}

void drawUnusable(const DeviceLink& link) {
  if (std::none_of(link.found().begin(), link.found().end(), listedUnusable)) return;
  sectionTitle(tr("Not to be used now"));
  for (const FoundDevice& one : link.found()) {
    if (!listedUnusable(one)) continue;
    const std::string name = "device/" + one.name;
    words(name.c_str(), tr(one.title.c_str()), look().palette.text);
    WithFont small(Font::Small);
    words((name + "/why").c_str(), one.why, look().palette.quiet);
  }
}

// The device's workspace along one of its axes, `scale` pixels per millimetre, with the hand and its force.
void drawRoom(const char* name, const char* label, ImVec2 low, ImVec2 size, float scale, glm::dvec2 room_mm,
              glm::dvec2 hand_mm, glm::dvec2 force_N) {
  constexpr float kForce_px_per_N = 14.0f;
  const Look& l = look();
  const Palette& p = l.palette;
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const ImVec2 middle{low.x + 0.5f * size.x, low.y + 0.5f * size.y},
      half{0.5f * scale * float(room_mm.x), 0.5f * scale * float(room_mm.y)};
  const ImVec2 a{middle.x - half.x, middle.y - half.y}, b{middle.x + half.x, middle.y + half.y};
  draw->AddRectFilled(a, b, p.raised, l.px(6));
  draw->AddRect(a, b, p.line, l.px(6));
  draw->AddLine({middle.x, a.y}, {middle.x, b.y}, p.line);
  draw->AddLine({a.x, middle.y}, {b.x, middle.y}, p.line);
  const ImVec2 at{std::clamp(middle.x + scale * saturateToFloat(hand_mm.x), a.x, b.x),
                  std::clamp(middle.y - scale * saturateToFloat(hand_mm.y), a.y, b.y)};
  const ImVec2 tip{at.x + l.px(kForce_px_per_N) * float(force_N.x), at.y - l.px(kForce_px_per_N) * float(force_N.y)};
  draw->AddLine(at, tip, p.warn, l.px(3));
  draw->AddCircleFilled(at, l.px(5), p.accent, 24);
  recordRectangle(name, {a.x, a.y}, {b.x, b.y}, label);
  const WithFont small(Font::Small);
  draw->AddText({middle.x - 0.5f * ImGui::CalcTextSize(label).x, low.y + size.y + l.px(4)}, p.quiet, label);
}

// The front view and the view from above, if a haptic device is in use.
void drawRooms(const ServoSample& now, const DeviceInfo& info) {
  const Look& l = look();
  const Vec3& room = info.workspace_mm;
  // A recording may contain any workspace and any position of the hand.
  const auto drawn = [](double side_mm) { return side_mm >= 1.0 && side_mm <= 1e5; };
  if (!drawn(room.x) || !drawn(room.y) || !drawn(room.z)) return;
  const float gap = l.px(16), width = 0.5f * (ImGui::GetContentRegionAvail().x - gap);
  const float height = std::min(l.px(88), width * float(std::max(room.y, room.z) / room.x));
  const float scale = std::min(width / float(room.x), height / float(std::max(room.y, room.z)));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Vec3 &hand = now.hand.mm, &force = now.force.N;
  drawRoom("device/front", tr("from the front"), at, {width, height}, scale, {room.x, room.y}, {hand.x, hand.y},
           {force.x, force.y});
  drawRoom("device/above", tr("from above"), {at.x + width + gap, at.y}, {width, height}, scale, {room.x, room.z},
           {hand.x, -hand.z}, {force.x, -force.z});
  const WithFont small(Font::Small);
  ImGui::Dummy({2 * width + gap, height + l.px(4) + ImGui::GetFontSize()});
}

void drawLive(Application& app, DeviceLink& link) {
  const Palette& p = look().palette;
  ServoLink& servo = app.scene.servo();
  const DeviceInfo& info = servo.device();
  const ServoSample& now = servo.newest();
  sectionTitle(tr("In use"));
  words("device/name", tr(info.name.c_str()), p.text);
  if (!link.awaited().empty())
    words("device/awaited", trf("{0} leads as soon as it can be reached.", link.awaited()), p.warn);
  if (!link.status().text.empty()) words("device/status", link.status().text, p.warn);
  if (link.wantsCalibration(servo) && button("device/calibrate", tr("Calibrate"))) servo.loop().device()->calibrate();
  // Positions far outside any device's workspace are shown without a number; one of 300 digits would not fit.
  const auto shown_mm = [](double mm) { return std::abs(mm) <= 1e6 ? mm : std::nan(""); };
  const auto place = [&](double mm) { return quantityNumber(shown_mm(mm), Dimension::HandLength); };
  std::string line = trf("Hand at {0}, {1}, {2}; force {3}", place(now.hand.mm.x), place(now.hand.mm.y),
                         quantityText(shown_mm(now.hand.mm.z), Dimension::HandLength),
                         quantityText(glm::length(now.force.N), Dimension::Force));
  for (int k = 0; k < 32; ++k)
    if (now.buttons >> k & 1u) line = trf("{0}; button {1}", line, k + 1);
  words("device/live", line, p.quiet);
  drawRooms(now, info);
  const DeviceLink::ScaleWords scale = link.scaleWords(app.scene);
  words("device/scale", scale.sentence, p.text);
  if (!scale.reason.empty()) words("device/scale reason", scale.reason, p.quiet);
  if (!info.gives_force) return;
  if (link.status().motor_heat >= 0.0) {
    words("device/heat label", tr("Heat of the motors"), p.quiet);
    progressBar("device/heat", float(link.status().motor_heat), false);
  }
  const bool trying = link.tryingLeft_s() > 0.0;
  if (button("device/try", trying ? tr("Pulling to the right …") : tr("Try a gentle force"), ButtonLook::Plain, 0.0f,
             !trying && link.status().ready && !app.scene.playedHand().on() && !app.scene.servo_settings.panic))
    link.tryForce();
  tip(app.scene.playedHand().on()
          ? tr("Not while a recorded hand is shown or the device changes hands.")
          : trf("Pulls to the right with {0} for four seconds, growing slowly. Hold the stylus lightly.",
                quantityText(DeviceLink::kTry_N, Dimension::Force, decimals(1)))
                .c_str());
}

// What is known of a device's rotation.
std::string torqueText(const DeviceInfo& info) {
  if (info.dof_out < 6 || !(info.max_torque_N_mm > 0.0))
    return tr("It gives no torque. The arc in the picture shows how the molecule turns what you hold.");
  const std::string most = numberText(info.max_torque_N_mm) + "\u00a0N\u00a0mm";
  return info.rotational_damping_N_mm_s > 0.0
             ? trf("It gives a torque of at most {0}. The damping of its rotation is {1}.", most,
                   numberText(info.rotational_damping_N_mm_s) + "\u00a0N\u00a0mm\u00a0s/rad")
             : trf("It gives a torque of at most {0}. The damping of its rotation is not known.", most);
}

void drawLimits(Application& app) {
  const Palette& p = look().palette;
  const DeviceInfo& info = app.scene.servo().device();
  sectionTitle(tr("Safety"));
  const ServoSettings& s = app.scene.servo_settings;
  const auto force = [](double force_N, int digits) {
    return quantityText(force_N, Dimension::Force, decimals(digits));
  };
  const std::string text =
      info.gives_force
          ? trf("At most {0} for a moment and {1} for good. With the delay as it is measured the surface is at most "
                "{2} stiff.",
                force(std::min(info.max_force_N, s.max_force_N), 1), force(info.continuous_force_N, 2),
                quantityText(app.scene.servo().newest().stiffness_bound_N_per_mm, Dimension::Stiffness))
          : trf("This device gives no force. What you see of it on the screen is at most {0}.",
                force(s.max_force_N, 1));
  words("device/limits", text, p.quiet);
  if (info.gives_force) words("device/torque", torqueText(info), p.quiet);
}

// Recording a hand to a file. Opening the file plays it.
void drawRecording(Application& app) {
  HandRecorder& recorder = app.extensions().hand_recorder;
  const Palette& p = look().palette;
  sectionTitle(tr("Recording of the hand"));
  const auto seconds = [](double s) { return quantityText(s, Dimension::Time, decimals(1)); };
  if (recorder.recording()) {
    words("device/recording", trf("{0} recorded in {1}", seconds(recorder.recorded_s()), recorder.name()), p.text);
    if (button("device/record", tr("Stop recording"), ButtonLook::Primary)) recorder.stop();
  } else if (recorder.playing()) {
    words("device/recording",
          trf("{0} of {1} of {2}. No force is given meanwhile.",
              quantityNumber(recorder.at_s(), Dimension::Time, decimals(1)), seconds(recorder.length_s()),
              recorder.name()),
          p.text);
    if (button("device/record", tr("Stop playing"), ButtonLook::Primary)) recorder.endPlay();
  } else {
    const bool may = app.scene.stage() && !app.scene.playedHand().on() && !app.scene.force().trying();
    if (button("device/record", tr("Record …"), ButtonLook::Plain, 0.0f, may)) {
      app.panels.pages.device = false;  // one page at a time
      recorder.askToRecord();
    }
    tip(tr("Every position and force, 1000 per second, until the molecule or the method changes."));
    ImGui::SameLine(0, look().px(8));
    if (button("device/play", tr("Play one …"))) app.panels.pages.device = false, app.panels.pages.open = true;
    tip(tr("Leads the hand on its molecule as it was recorded. No force is given meanwhile."));
  }
}

// One bar per class of lateness.
void drawLateness(const DeviceLink& link) {
  const Look& l = look();
  sectionTitle(tr("How late ticks begin"));
  const auto& share = link.lateness();
  const float width = ImGui::GetContentRegionAvail().x, height = l.px(64), step = width / float(share.size());
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList* draw = ImGui::GetWindowDrawList();
  const float most = std::max(1e-6f, *std::max_element(share.begin(), share.end()));
  for (std::size_t k = 0; k < share.size(); ++k) {
    const float x = at.x + float(k) * step, top = at.y + height * (1.0f - share[k] / most);
    draw->AddRectFilled({x + l.px(2), std::min(top, at.y + height - l.px(1))}, {x + step - l.px(2), at.y + height},
                        l.palette.accent, l.px(2));
  }
  ImGui::Dummy({width, height});
  recordRectangle("device/late", {at.x, at.y}, {at.x + width, at.y + height}, "");
  WithFont small(Font::Small);
  WithText quiet(l.palette.quiet);
  const ImVec2 below = ImGui::GetCursorScreenPos();
  // "20 µs", "50", "100", "200", "500", "1 ms", "2", "5", "more": the unit only where it changes.
  for (std::size_t k = 0; k < share.size(); ++k) {
    std::string label = tr("more");
    if (k < DeviceLink::kLate_us.size()) {
      const double late_s = DeviceLink::kLate_us[k] * 1e-6;
      const auto unit = [](double s) -> std::string_view { return s < 1e-3 ? "µs" : "ms"; };
      const bool first = k == 0 || unit(late_s) != unit(DeviceLink::kLate_us[k - 1] * 1e-6);
      const QuantityOptions how{plain(), unit(late_s)};
      label = first ? quantityText(late_s, Dimension::Time, how) : quantityNumber(late_s, Dimension::Time, how);
    }
    const float text = ImGui::CalcTextSize(label.c_str()).x;
    if (text > step) widgets().noteCut(label);
    draw->AddText({at.x + (float(k) + 0.5f) * step - 0.5f * text, below.y}, l.palette.quiet, label.c_str());
  }
  ImGui::Dummy({width, ImGui::GetFontSize()});
}

}  // namespace

void drawDevicePage(Application& app) {
  DeviceLink& link = app.extensions().device;
  if (!beginPage("device page", tr("Device"), app.panels.pages.device, 560, 700)) return;
  drawStop(app, link);
  ImGui::BeginChild("list");
  const auto part = [] { ImGui::Dummy({0, look().px(8)}); };
  drawUsable(link);
  drawAddresses(link);
  part();
  drawLive(app, link);
  part();
  drawLimits(app);
  part();
  drawRecording(app);
  part();
  if (app.scene.servo().clock() == ServoClock::RealThread) {
    drawLateness(link);
    part();
  }
  drawUnusable(link);
  ImGui::EndChild();
  endPage();
}

}  // namespace moltact
