#include "engine/device/hid/play_station.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "engine/device/hid/hid_kind.h"
#include "engine/device/hid/rate_control.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::uint8_t kState = 1;
constexpr std::size_t kUsbBytes = 64, kBluetoothBytes = 10;
constexpr double kStickDead = 0.12;  // sticks do not return exactly to their middle
constexpr int kSteps = 15;           // steps of rumble: a report is sent when the step changes

bool isPad(const HidEntry& entry, std::initializer_list<std::uint16_t> products) {
  return entry.vendor == 0x054c && std::find(products.begin(), products.end(), entry.product) != products.end() &&
         (entry.usage_page == 0 || (entry.usage_page == 1 && entry.usage == 5));
}
bool isDualShock4(const HidEntry& entry) { return isPad(entry, {0x05c4, 0x09cc}); }
bool isDualSense(const HidEntry& entry) { return isPad(entry, {0x0ce6, 0x0df2}); }  // the second: Edge

// A stick's axis rests at 128.
double stick(std::uint8_t byte) {
  const double part = std::clamp((byte - 128.0) / 127.0, -1.0, 1.0);
  return std::abs(part) < kStickDead ? 0.0 : part;
}

}  // namespace

std::optional<Problem> PlayStationProtocol::begin(PacketPort&, DeviceInfo&) {
  *this = PlayStationProtocol(usb_);
  return std::nullopt;
}

bool PlayStationProtocol::parseReport(std::span<const std::uint8_t> r, DevicePose& pose) noexcept {
  if ((r.size() != kUsbBytes && r.size() != kBluetoothBytes) || r[0] != kState) return false;
  by_usb_ = r.size() == kUsbBytes;
  const PadLayout& at = by_usb_ ? usb_ : kDualShock4;
  push_ = {stick(r[1]), -stick(r[2]), (r[at.left_trigger] - r[at.right_trigger]) / 255.0};
  turn_ = {stick(r[4]), stick(r[3]), 0.0};
  // Square, cross, circle, triangle; the cross is the first button, the circle the second.
  const unsigned face = r[at.buttons] >> 4;
  pose.buttons = (face >> 1 & 3u) | (face & 1u) << 2 | (face & 8u);
  silent_s_ = 0;
  return true;
}

void PlayStationProtocol::advance(double dt_s, DevicePose& pose) noexcept {
  if ((silent_s_ += dt_s) > rate_control::kSilence_s) push_ = turn_ = Vec3(0.0);
  rate_control::move(pose, push_, dt_s);
  view_motion_ = {};
  if (rotates_hand_)
    rate_control::rotate(pose, turn_, dt_s);
  else
    view_motion_.rotation = rate_control::shaped(turn_);
}

std::size_t PlayStationProtocol::encode(const Wrench& wrench, ReportBuffer out) noexcept {
  if (!by_usb_) return 0;
  const double part = finite(wrench.force.N) ? std::min(1.0, glm::length(wrench.force.N) / kFullRumble_N) : 0.0;
  const int step = static_cast<int>(std::ceil(part * kSteps - 1e-9));
  if (step == sent_step_) return 0;
  sent_step_ = step;
  std::fill(out.begin(), out.end(), std::uint8_t{0});
  out[0] = usb_.report;
  out[1] = usb_.sets_motors;
  // The weak motor starts at a touch, the strong one above a third.
  out[usb_.weak_motor] = static_cast<std::uint8_t>(step * 255 / kSteps);
  out[usb_.strong_motor] = static_cast<std::uint8_t>(std::max(0, step - kSteps / 3) * 255 / (kSteps - kSteps / 3));
  return usb_.bytes;
}

std::size_t PlayStationProtocol::encodeFinalReport(ReportBuffer out) noexcept {
  sent_step_ = -1;
  const std::size_t length = encode(Wrench{}, out);
  sent_step_ = -1;  // the next step counts as a change
  return length;
}

namespace {

DeviceInfo padInfo() {
  DeviceInfo info{shownForceFigures()};
  info.workspace_mm = Vec3(2 * rate_control::kReach_mm);
  return info;
}
const HidKind& dualShock() {
  static const HidKind kind{N_("Game pad (DualShock 4)"), isDualShock4,
                            [] { return std::unique_ptr<PacketProtocol>(new PlayStationProtocol(kDualShock4)); },
                            padInfo()};
  return kind;
}
const HidKind& dualSense() {
  static const HidKind kind{N_("Game pad (DualSense)"), isDualSense,
                            [] { return std::unique_ptr<PacketProtocol>(new PlayStationProtocol(kDualSense)); },
                            padInfo()};
  return kind;
}

}  // namespace

extern const DeviceDriver kDualShock4Driver, kDualSenseDriver;
const DeviceDriver kDualShock4Driver{
    .name = "gamepad",  // stored in users' settings
    .sentence = N_("Sony DualShock 4: its sticks lead the hand and turn the view, its rumble stands for the force."),
    .find = [] { return findHid(dualShock()); },
    .open = [](const FoundDevice& found) { return openHid(dualShock(), found); },
};
const DeviceDriver kDualSenseDriver{
    .name = "dualsense",
    .sentence = N_("Sony DualSense: its sticks lead the hand and turn the view, its rumble stands for the force."),
    .find = [] { return findHid(dualSense()); },
    .open = [](const FoundDevice& found) { return openHid(dualSense(), found); },
};

}  // namespace moltact
