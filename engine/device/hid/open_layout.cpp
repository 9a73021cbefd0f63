#include "engine/device/hid/open_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/device/hid/hid_kind.h"
#include "engine/device/packet/report_bytes.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

using namespace open_layout;

bool isOpenDevice(const HidEntry& entry) { return entry.usage_page == kUsagePage && entry.usage == kUsage; }

constexpr std::array<std::uint8_t, 4> kMagic{'M', 'L', 'T', 'C'};

// A cut is reported for this time, so that the haptic thread cannot miss it. A loop that was stalled longer starts
// softly anyway.
constexpr double kCutReported_s = 0.020;
constexpr double kMaxAdvance_s = 0.002;  // limits a step after a stall, so that every cut is reported
constexpr double kMaxInt16 = 32767.0;    // largest signed 16-bit number

Problem noneOfIt(const char* what) {
  return Problem{"", 0, 0, trf("the device is none of the open layout: {0}", what), tr("see docs/device-protocol.md")};
}

// Returns why a description is unusable, with the name of the field.
std::optional<Problem> problemOf(std::span<const std::uint8_t> r) {
  const auto refuse = [](const std::string& what, const std::string& remedy) {
    return Problem{"", 0, 0, trf("the device's feature report 3 cannot be used: {0}", what), remedy};
  };
  const int unit_nm = uint16At(r, 6), peak_mN = uint16At(r, 8), lasting_mN = uint16At(r, 10);
  if (unit_nm == 0)
    return refuse(tr("its place's unit (byte 6) is 0"), tr("tell the length of a place's step there, in nm"));
  int longest_mm = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int room_mm = uint16At(r, 12 + 2 * axis);
    if (room_mm == 0)
      return refuse(trf("its room along {0} (byte {1}) is 0", std::string(1, char('x' + axis)), 12 + 2 * axis),
                    tr("tell it there, edge to edge, in mm"));
    longest_mm = std::max(longest_mm, room_mm);
  }
  if (const double reach_mm = 1e-6 * unit_nm * kMaxInt16; 0.5 * longest_mm > reach_mm)
    return refuse(
        trf("places in steps of {0} nm (byte 6) reach {1} from the middle, and its room of {2} mm (bytes 12 to 17) "
            "needs {3}",
            unit_nm, quantityText(reach_mm, Dimension::HandLength, decimals(1)), longest_mm,
            quantityText(0.5 * longest_mm, Dimension::HandLength, decimals(1))),
        trf("make the unit at least {0} nm, or the room smaller", int(std::ceil(0.5e6 * longest_mm / kMaxInt16))));
  if (peak_mN > int(kMaxInt16))
    return refuse(trf("its greatest force (byte 8) is {0} mN", peak_mN),
                  tr("a force report can ask for no more than 32767 mN: tell that at most"));
  if (peak_mN > 0 && lasting_mN == 0)
    return refuse(tr("its greatest force for good (byte 10) is 0, so that it could give none"),
                  tr("tell there what its motors bear for as long as you like, in mN"));
  return std::nullopt;
}

}  // namespace

std::optional<Problem> OpenLayoutProtocol::begin(PacketPort& port, DeviceInfo& info) {
  std::array<std::uint8_t, 64> report{kDescription};
  const int size = port.feature(report);
  of_kind_ = size >= int(kDescriptionBytes) && report[0] == kDescription &&
             std::equal(kMagic.begin(), kMagic.end(), report.begin() + 1);
  if (!of_kind_) return noneOfIt(tr("its feature report 3 does not begin with 'MLTC'"));
  if (report[5] != kVersion) return noneOfIt(tr("it speaks another version of the layout"));
  const std::span<const std::uint8_t> bytes(report);
  if (auto problem = problemOf(bytes)) return problem;
  const auto known = [&](std::size_t at, double unit, double otherwise) {
    return uint16At(bytes, at) ? unit * uint16At(bytes, at) : otherwise;
  };
  step_mm_ = 1e-6 * uint16At(bytes, 6);
  info.workspace_mm = Vec3(uint16At(bytes, 12), uint16At(bytes, 14), uint16At(bytes, 16));
  info.resolution_mm = step_mm_;
  info.max_force_N = 1e-3 * uint16At(bytes, 8);
  info.continuous_force_N = std::min(info.max_force_N, 1e-3 * uint16At(bytes, 10));
  info.max_stiffness_N_per_mm = known(18, 1e-3, DeviceSpecs::kUnknownStiffness_N_per_mm);
  info.damping_N_s_per_m = 1e-3 * uint16At(bytes, 20);
  info.max_damping_N_s_per_m = 1e-3 * uint16At(bytes, 22);
  info.friction_N = 1e-3 * uint16At(bytes, 24);
  info.delay_s = known(26, 1e-6, DeviceSpecs::kUnknownDelay_s);
  measures_orientation_ = bytes[28] & kMeasuresOrientation;
  info.dof_in = measures_orientation_ ? 6 : 3;
  info.gives_force = gives_ = info.max_force_N > 0;
  info.dof_out = gives_ ? 3 : 0;
  any_seen_ = false;
  status_ = 0;
  cut_s_ = 0;
  return std::nullopt;
}

bool OpenLayoutProtocol::parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept {
  if (report.size() < kPlaceBytes || report[0] != kPlaceReport) return false;
  const std::uint16_t number = uint16At(report, 1);
  const bool again = any_seen_ && number == seen_;  // a repeated report contains nothing new
  seen_ = number;
  any_seen_ = true;
  pose.position.mm = step_mm_ * Vec3(int16At(report, 7), int16At(report, 9), int16At(report, 11));
  if (measures_orientation_) {
    const Quat reported(int16At(report, 19) / kMaxInt16, int16At(report, 13) / kMaxInt16,
                        int16At(report, 15) / kMaxInt16, int16At(report, 17) / kMaxInt16);
    if (const double size = glm::length(reported); size > 0.9 && size < 1.1) pose.orientation = reported / size;
  }
  pose.buttons = report[21];
  status_ = report[22];
  if (status_ & kWatchdogTripped) cut_s_ = kCutReported_s;
  pose.fault = faulty();
  pose.motor_heat = status_ & kHot ? 1.0f : 0.0f;
  return !again;
}

DeviceGuidance OpenLayoutProtocol::guidance() const noexcept {
  if (status_ & kFault) return {N_("The device reports a fault: look at it and at its power, then plug it in again.")};
  if (status_ & kUncalibrated) return {N_("The device is not calibrated: do with it what its maker says for that.")};
  return {};
}

void OpenLayoutProtocol::advance(double dt_s, DevicePose& pose) noexcept {
  pose.fault = faulty();
  cut_s_ = std::max(0.0, cut_s_ - std::min(dt_s, kMaxAdvance_s));
}

std::size_t OpenLayoutProtocol::forceReport(ForceN force, bool motors_on, ReportBuffer out) noexcept {
  if (!gives_) return 0;
  const bool on = motors_on && finite(force.N);
  out[0] = kForceReport;
  putInt16(out, 1, sent_++);
  for (int k = 0; k < 3; ++k)
    putInt16(out, 3 + 2 * std::size_t(k),
             on ? int(std::lround(std::clamp(1e3 * force.N[k], -kMaxInt16, kMaxInt16))) : 0);
  out[9] = on;
  out[10] = kWatchdog_ms;
  return kForceBytes;
}

std::size_t OpenLayoutProtocol::encode(const Wrench& wrench, ReportBuffer out) noexcept {
  return forceReport(wrench.force, !faulty(), out);
}

std::size_t OpenLayoutProtocol::encodeStop(ReportBuffer out) noexcept { return forceReport({}, false, out); }

namespace {

const HidKind& openLayout() {
  DeviceInfo info;
  info.gives_force = true;  // true of most devices; each reports it itself
  static const HidKind kind{N_("Device of the open layout"), isOpenDevice,
                            [] { return std::unique_ptr<PacketProtocol>(new OpenLayoutProtocol); }, info};
  return kind;
}

}  // namespace

extern const DeviceDriver kOpenLayoutDriver;
const DeviceDriver kOpenLayoutDriver{
    .name = "open",
    .sentence = N_("A device that you build: any that speaks the reports of docs/device-protocol.md."),
    .find = [] { return findHid(openLayout()); },
    .open = [](const FoundDevice& found) { return openHid(openLayout(), found); },
};

}  // namespace moltact
