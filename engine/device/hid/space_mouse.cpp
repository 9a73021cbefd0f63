#include "engine/device/hid/space_mouse.h"

#include <algorithm>
#include <cmath>

#include "engine/device/hid/hid_kind.h"
#include "engine/device/hid/rate_control.h"
#include "engine/device/packet/report_bytes.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::uint8_t kPush = 1, kTurn = 2, kButtons = 3;
constexpr std::uint32_t kSwitch = 1;  // the first button

// The device's axes are x right, y toward the user, z down. Its values occasionally exceed the mechanical stops.
Vec3 axesAt(std::span<const std::uint8_t> report, std::size_t at) {
  const auto axis = [&](std::size_t k) {
    return std::clamp(int16At(report, at + 2 * k) / SpaceMouseProtocol::kFull, -1.0, 1.0);
  };
  return {axis(0), -axis(2), axis(1)};
}

bool isSpaceMouse(const HidEntry& entry) {
  constexpr std::uint16_t kLogitech[] = {0xc626, 0xc627, 0xc629, 0xc62b};
  constexpr std::uint16_t k3Dconnexion[] = {0xc62e, 0xc62f, 0xc631, 0xc632, 0xc633, 0xc635, 0xc652};
  const auto has = [&](std::span<const std::uint16_t> all) {
    return std::find(all.begin(), all.end(), entry.product) != all.end();
  };
  const bool known = (entry.vendor == 0x046d && has(kLogitech)) || (entry.vendor == 0x256f && has(k3Dconnexion));
  // A receiver has several interfaces; the axes are on usage 8, multi-axis controller.
  return known && (entry.usage_page == 0 || (entry.usage_page == 1 && entry.usage == 8));
}

}  // namespace

std::optional<Problem> SpaceMouseProtocol::begin(PacketPort&, DeviceInfo&) {
  axes_ = {};
  view_motion_ = {};
  return std::nullopt;
}

bool SpaceMouseProtocol::parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept {
  if (report.empty()) return false;
  if (report[0] == kPush && (report.size() == 7 || report.size() == 13)) {
    axes_.push = axesAt(report, 1);
    if (report.size() == 13) axes_.rotation = axesAt(report, 7);
  } else if (report[0] == kTurn && report.size() == 7) {
    axes_.rotation = axesAt(report, 1);
  } else if (report[0] == kButtons && report.size() >= 2) {
    const std::uint32_t before = pressed_;
    pressed_ = 0;
    for (std::size_t k = 1; k < report.size() && k <= 4; ++k) pressed_ |= std::uint32_t(report[k]) << (8 * (k - 1));
    if (pressed_ & ~before & kSwitch) leads_view_ = !leads_view_;
    pose.buttons = pressed_ & ~kSwitch;
    return true;
  } else {
    return false;  // battery and other reports
  }
  silent_s_ = 0;
  return true;
}

void SpaceMouseProtocol::advance(double dt_s, DevicePose& pose) noexcept {
  if ((silent_s_ += dt_s) > rate_control::kSilence_s) axes_ = {};
  view_motion_ = {};
  // A hand cannot push without rotating slightly, or the reverse; the stronger of both acts.
  const bool turns = glm::length(axes_.rotation) > glm::length(axes_.push);
  if (turns && rotates_hand_ && !leads_view_)
    rate_control::rotate(pose, axes_.rotation, dt_s);
  else if (turns)
    view_motion_.rotation = rate_control::shaped(axes_.rotation);
  else if (leads_view_)
    view_motion_.move = rate_control::shaped(axes_.push);
  else
    rate_control::move(pose, axes_.push, dt_s);
}

namespace {

const HidKind& spaceMouse() {
  DeviceInfo info{shownForceFigures()};
  info.dof_in = 6;
  info.workspace_mm = Vec3(2 * rate_control::kReach_mm);
  static const HidKind kind{"3Dconnexion SpaceMouse", isSpaceMouse,
                            [] { return std::unique_ptr<PacketProtocol>(new SpaceMouseProtocol); }, info};
  return kind;
}

}  // namespace

extern const DeviceDriver kSpaceMouseDriver;
const DeviceDriver kSpaceMouseDriver{
    .name = "spacemouse",
    .sentence = N_("3Dconnexion SpaceMouse: leads the hand and turns the view, gives no force."),
    .find = [] { return findHid(spaceMouse()); },
    .open = [](const FoundDevice& found) { return openHid(spaceMouse(), found); },
};

}  // namespace moltact
