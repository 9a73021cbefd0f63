#include "engine/device/hid/dual_shock.h"

#include <algorithm>
#include <cmath>

#include "engine/device/hid/rate_control.h"

namespace moltact {
namespace {

constexpr std::uint8_t kState = 1, kMotors = 5, kSetMotors = 1;
constexpr std::size_t kUsbBytes = 64, kBluetoothBytes = 10, kMotorBytes = 32;
constexpr double kStickDead = 0.12;  // sticks do not come back to their middle
constexpr int kSteps = 15;           // of rumble: a report is sent where the step changes

bool isDualShock(const HidEntry& entry) {
  const bool known = entry.vendor == 0x054c && (entry.product == 0x05c4 || entry.product == 0x09cc);
  return known && (entry.usage_page == 0 || (entry.usage_page == 1 && entry.usage == 5));
}

// A stick's axis rests at 128.
double stick(std::uint8_t byte) {
  const double part = std::clamp((byte - 128.0) / 127.0, -1.0, 1.0);
  return std::abs(part) < kStickDead ? 0.0 : part;
}

}  // namespace

std::optional<Problem> DualShockProtocol::begin(HidPort&, DeviceInfo&) {
  *this = {};
  return std::nullopt;
}

bool DualShockProtocol::take(std::span<const std::uint8_t> r, DevicePose& pose) noexcept {
  if ((r.size() != kUsbBytes && r.size() != kBluetoothBytes) || r[0] != kState) return false;
  by_usb_ = r.size() == kUsbBytes;
  push_ = {stick(r[1]), -stick(r[2]), (r[8] - r[9]) / 255.0};
  turn_ = {stick(r[4]), stick(r[3]), 0.0};
  // Square, cross, circle, triangle: the cross is the first button, the circle the second.
  const unsigned face = r[5] >> 4;
  pose.buttons = (face >> 1 & 3u) | (face & 1u) << 2 | (face & 8u);
  silent_s_ = 0;
  return true;
}

void DualShockProtocol::pass(double dt_s, DevicePose& pose) noexcept {
  if ((silent_s_ += dt_s) > rate_control::kSilence_s) push_ = turn_ = Vec3(0.0);
  rate_control::move(pose, push_, dt_s);
  wish_.turn = rate_control::shaped(turn_);
}

std::size_t DualShockProtocol::give(ForceN force, std::span<std::uint8_t, 64> out) noexcept {
  if (!by_usb_) return 0;
  const double part = finite(force.N) ? std::min(1.0, glm::length(force.N) / kFullRumble_N) : 0.0;
  const int step = static_cast<int>(std::ceil(part * kSteps - 1e-9));
  if (step == told_) return 0;
  told_ = step;
  std::fill(out.begin(), out.end(), std::uint8_t{0});
  out[0] = kMotors;
  out[1] = kSetMotors;
  // The weak motor trembles at a touch, the strong one comes in above a third.
  out[4] = static_cast<std::uint8_t>(step * 255 / kSteps);
  out[5] = static_cast<std::uint8_t>(std::max(0, step - kSteps / 3) * 255 / (kSteps - kSteps / 3));
  return kMotorBytes;
}

namespace {

const HidKind& dualShock() {
  static const HidKind kind{"Game pad (DualShock 4)", isDualShock, [] { return std::unique_ptr<HidProtocol>(new DualShockProtocol); }, [] {
                              DeviceInfo info;
                              info.workspace_mm = Vec3(2 * rate_control::kReach_mm);
                              return info;
                            }()};
  return kind;
}

}  // namespace

extern const DeviceDriver kDualShockDriver;
const DeviceDriver kDualShockDriver{
    .name = "gamepad",
    .sentence = "Sony DualShock 4: its sticks lead the hand and turn the view, its rumble stands for the force.",
    .find = [] { return findHid(dualShock()); },
    .open = [](const FoundDevice& found) { return openHid(dualShock(), found); },
};

}  // namespace moltact
