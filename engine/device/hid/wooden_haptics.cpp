#include "engine/device/hid/wooden_haptics.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/device/hid/hid_kind.h"
#include "engine/device/packet/report_bytes.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr double kBase_m = 0.080, kUpper_m = 0.205, kFore_m = 0.245;
constexpr double kOriginForward_m = 0.220, kOriginUp_m = 0.080;
constexpr std::size_t kReport = 8;

bool isWoodenHaptics(const HidEntry& entry) { return entry.vendor == 0x1234 && entry.product == 0x0006; }

}  // namespace

// The device's own axes are x toward the user, y right, z up.
PointMm WoodenHapticsProtocol::place(const Vec3& a) {
  const double reach = kUpper_m * std::sin(a.y) + kFore_m * std::sin(a.z);
  const double forward = std::cos(a.x) * reach - kOriginForward_m, right = std::sin(a.x) * reach;
  const double up = kBase_m + kUpper_m * std::cos(a.y) - kFore_m * std::cos(a.z) - kOriginUp_m;
  return {1e3 * Vec3(right, up, forward)};
}

// The transpose of the position's Jacobian with respect to the angles.
Vec3 WoodenHapticsProtocol::torques(const Vec3& a, ForceN force) {
  const double reach = kUpper_m * std::sin(a.y) + kFore_m * std::sin(a.z), c = std::cos(a.x), s = std::sin(a.x);
  const double fx = force.N.z, fy = force.N.x, fz = force.N.y;
  return {reach * (c * fy - s * fx), kUpper_m * (std::cos(a.y) * (c * fx + s * fy) - std::sin(a.y) * fz),
          kFore_m * (std::cos(a.z) * (c * fx + s * fy) + std::sin(a.z) * fz)};
}

std::optional<Problem> WoodenHapticsProtocol::begin(PacketPort&, DeviceInfo&) {
  any_seen_ = calibrated_ = false;  // the encoders count from an unknown pose at power-on
  return std::nullopt;
}

DeviceGuidance WoodenHapticsProtocol::guidance() const noexcept {
  if (calibrated_) return {};
  return {N_("Hold both links of the device upright: its encoders count from there."), true};
}

bool WoodenHapticsProtocol::calibrate() noexcept {
  if (!any_seen_) return false;
  std::copy(std::begin(counts_), std::end(counts_), std::begin(upright_));
  angles_ = Vec3(0.0);
  return calibrated_ = true;
}

bool WoodenHapticsProtocol::parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept {
  if (report.size() != kReport) return false;
  any_seen_ = true;
  for (int k = 0; k < 3; ++k) {
    counts_[k] = int16At(report, 2 * std::size_t(k));
    const auto turned = static_cast<std::int16_t>(counts_[k] - upright_[k]);
    angles_[k] = -kGear[k] * kTwoPi * turned / kCountsATurn;  // the bodies rotate opposite to their motors
  }
  pose.position = place(angles_);
  return true;
}

std::size_t WoodenHapticsProtocol::encode(const Wrench& wrench, ReportBuffer out) noexcept {
  const Vec3 joints = torques(angles_, wrench.force);
  out[0] = 0;  // hidapi's marker for reports without an id
  // All three are scaled equally, so that the force keeps its direction.
  Vec3 mA;
  double biggest = 0;
  for (int k = 0; k < 3; ++k) {
    mA[k] = -1e3 * kGear[k] * joints[k] / kTorque_Nm_per_A;
    biggest = std::max(biggest, std::abs(mA[k]));
  }
  if (!std::isfinite(biggest))
    mA = Vec3(0.0);
  else if (biggest > kMax_mA)
    mA *= kMax_mA / biggest;
  for (int k = 0; k < 3; ++k) putInt16(out, 1 + 2 * std::size_t(k), int(std::lround(mA[k])));
  putInt16(out, 7, sent_++);
  return 1 + kReport;
}

DeviceInfo woodenHapticsInfo() {
  DeviceInfo info;
  info.name = "WoodenHaptics";
  info.workspace_mm = Vec3(200.0);
  info.dof_out = 3;
  info.max_force_N = 5.0;
  info.continuous_force_N = 1.5;
  info.max_stiffness_N_per_mm = 1.0;
  info.max_damping_N_s_per_m = 8.0;
  info.resolution_mm = 0.05;
  info.delay_s = 0.002;
  info.gives_force = true;
  return info;
}

namespace {

const HidKind& woodenHaptics() {
  static const HidKind kind{"WoodenHaptics", isWoodenHaptics,
                            [] { return std::unique_ptr<PacketProtocol>(new WoodenHapticsProtocol); },
                            woodenHapticsInfo()};
  return kind;
}

}  // namespace

extern const DeviceDriver kWoodenHapticsDriver;
const DeviceDriver kWoodenHapticsDriver{
    .name = "woodenhaptics",
    .sentence = N_("WoodenHaptics, the open stylus of 2015; it is calibrated with both links held upright."),
    .find = [] { return findHid(woodenHaptics()); },
    .open = [](const FoundDevice& found) { return openHid(woodenHaptics(), found); },
};

}  // namespace moltact
