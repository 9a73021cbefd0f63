#include "engine/device/hid/open_device.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace moltact {
namespace {

using namespace open_layout;

bool isOpenDevice(const HidEntry& entry) { return entry.usage_page == 0xFF00 && entry.usage == 1; }

constexpr std::array<std::uint8_t, 4> kMagic{'M', 'L', 'T', 'C'};

}  // namespace

std::optional<Problem> OpenProtocol::begin(HidPort& port, DeviceInfo& info) {
  std::array<std::uint8_t, 64> report{kDescription};
  const int size = port.feature(report);
  const auto refuse = [](const char* what) {
    return Problem{"", 0, 0, std::string("the device is none of the open layout: ") + what, "see docs/device-protocol.md"};
  };
  if (size < int(kDescriptionBytes) || report[0] != kDescription || !std::equal(kMagic.begin(), kMagic.end(), report.begin() + 1))
    return refuse("its feature report 3 does not begin with 'MLTC'");
  if (report[5] != kVersion) return refuse("it speaks another version of the layout");
  const std::span<const std::uint8_t> bytes(report);
  step_mm_ = 1e-6 * uint16At(bytes, 6);
  const double max_N = 1e-3 * uint16At(bytes, 8), continuous_N = 1e-3 * uint16At(bytes, 10);
  const Vec3 workspace(uint16At(bytes, 12), uint16At(bytes, 14), uint16At(bytes, 16));
  if (!(step_mm_ > 0) || workspace.x * workspace.y * workspace.z <= 0) return refuse("its place has no unit or no room");
  info.workspace_mm = workspace;
  info.resolution_mm = step_mm_;
  info.max_force_N = max_N;
  info.continuous_force_N = std::min(max_N, continuous_N);
  info.max_stiffness_N_per_mm = 1e-3 * uint16At(bytes, 18);
  info.damping_N_s_per_m = 1e-3 * uint16At(bytes, 20);
  info.max_damping_N_s_per_m = 1e-3 * uint16At(bytes, 22);
  info.friction_N = 1e-3 * uint16At(bytes, 24);
  info.delay_s = 1e-6 * uint16At(bytes, 26);
  info.dof_in = 3;  // the turn, where it is measured, is not used
  info.gives_force = gives_ = max_N > 0;
  info.dof_out = gives_ ? 3 : 0;
  any_seen_ = false;
  status_ = 0;
  return std::nullopt;
}

bool OpenProtocol::take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept {
  if (report.size() < kPlaceBytes || report[0] != kPlaceReport) return false;
  const std::uint16_t number = uint16At(report, 1);
  const bool again = any_seen_ && number == seen_;  // the same report twice tells nothing new
  seen_ = number;
  any_seen_ = true;
  pose.position.mm = step_mm_ * Vec3(int16At(report, 7), int16At(report, 9), int16At(report, 11));
  pose.buttons = report[21];
  status_ = report[22];
  pose.trouble = status_ & (kFault | kUncalibrated);
  pose.motor_heat = status_ & kHot ? 1.0f : 0.0f;
  return !again;
}

HidGuidance OpenProtocol::guidance() const noexcept {
  if (status_ & kFault) return {"The device reports a fault: look at it and at its power, then plug it in again."};
  if (status_ & kUncalibrated) return {"The device is not calibrated: do with it what its maker says for that."};
  return {};
}

std::size_t OpenProtocol::give(ForceN force, std::span<std::uint8_t, 64> out) noexcept {
  if (!gives_) return 0;
  out[0] = kForceReport;
  putInt16(out, 1, sent_++);
  const bool sound = finite(force.N);
  for (int k = 0; k < 3; ++k) putInt16(out, 3 + 2 * std::size_t(k), sound ? int(std::lround(std::clamp(1e3 * force.N[k], -32767.0, 32767.0))) : 0);
  out[9] = sound;
  out[10] = kWatchdog_ms;
  return kForceBytes;
}

namespace {

const HidKind& openLayout() {
  static const HidKind kind{"Device of the open layout", isOpenDevice, [] { return std::unique_ptr<HidProtocol>(new OpenProtocol); }, [] {
                              DeviceInfo info;
                              info.gives_force = true;  // most do; each tells it itself
                              return info;
                            }()};
  return kind;
}

}  // namespace

extern const DeviceDriver kOpenDriver;
const DeviceDriver kOpenDriver{
    .name = "open",
    .sentence = "A device that you build: any that speaks the reports of docs/device-protocol.md.",
    .find = [] { return findHid(openLayout()); },
    .open = [](const FoundDevice& found) { return openHid(openLayout(), found); },
};

}  // namespace moltact
