#include "app/ui/device_link.h"

#include <algorithm>

#include "app/ui/application.h"
#include "engine/servo/plain_trackers.h"

namespace moltact {
namespace {

constexpr double kAsk_s = 0.25;             // between two questions for the device's state
constexpr double kTurned = 1e-9;            // a view that has turned by less has not
constexpr float kForgetTick = 1.0f / 3000;  // so the classes stand for the last 3 s
constexpr std::uint32_t kClutchButton = 2;  // the stylus's second

}  // namespace

void DeviceLink::look() { found_ = findDevices(); }

void DeviceLink::choose(Application& app, const std::string& name) {
  stopTrying(app);
  ServoLink& servo = app.scene.servo();
  if (name == "mouse") {
    servo.setDevice(nullptr);
  } else {
    // The old one goes first: it may be the same.
    if (name == chosen_) return;
    auto device = openDevice(name);
    if (!device) {
      app.messages.error(device.problem().text());
      return;
    }
    servo.setDevice(std::move(*device));
  }
  chosen_ = name;
  status_ = DeviceStatus();
  asked_s_ = -1.0;
  // A hand that is held has an edge to its room, and a button to reach beyond it.
  app.scene.servo_settings.clutch = name == "mouse" ? ClutchSettings() : ClutchSettings{.buttons = kClutchButton, .at_edge = true};
}

void DeviceLink::tryForce(Application& app) {
  const ServoSettings& s = app.scene.servo_settings;
  if (!(s.stiffness_N_per_mm > 0.0)) return;
  trying_s_ = kTry_s;
  app.scene.servo().tryTracker(std::make_unique<PullTracker>(kTry_N / s.stiffness_N_per_mm * s.workspace.A_per_mm));
}

void DeviceLink::stopTrying(Application& app) {
  if (trying_s_ <= 0.0) return;
  trying_s_ = 0.0;
  app.scene.useMethod(app.scene.method());
}

// The device's right is the screen's right. Where that changes the hand is placed anew, so that nothing is dragged along.
void DeviceLink::turnWithView(Application& app) {
  const Camera& camera = app.scene.camera;
  const bool leads = app.scene.servo().chosen() && !app.scene.servo().fallenBack();
  const glm::dmat3 wanted = leads ? glm::dmat3(camera.right(), camera.up(), camera.back()) : glm::dmat3(1.0);
  glm::dmat3& turn = app.scene.servo_settings.workspace.turn;
  double off = 0;
  for (int k = 0; k < 3; ++k) off = std::max(off, glm::distance(wanted[k], turn[k]));
  if (off <= kTurned) return;
  turn = wanted;
  ++app.scene.servo_settings.placements;
}

void DeviceLink::beforeTicks(Application& app) {
  turnWithView(app);
  for (double& left : limit_left_s_) left = std::max(0.0, left - app.dt_s());
  if (trying_s_ > 0.0) {
    trying_s_ -= app.dt_s();
    if (trying_s_ <= 0.0) {
      trying_s_ = app.dt_s();
      stopTrying(app);
    }
  }
  Device* device = app.scene.servo().chosen();
  if (!device || (asked_s_ >= 0.0 && app.now_s() - asked_s_ < kAsk_s)) return;
  asked_s_ = app.now_s();
  const bool was = status_.connected;
  status_ = device->status();
  if (was && !status_.connected) app.messages.warning(status_.text + " Until then the mouse leads.");
  if (!was && status_.connected) app.messages.notice(device->info().name + " leads again.");
}

void DeviceLink::ticks(Application&, const FeltTicks& felt) {
  for (const FeltTick& t : felt.ticks) {
    for (std::size_t k = 0; k < limitWords().size(); ++k)
      if (t.sample.limits.has(limitWords()[k].limit)) limit_left_s_[k] = kShowLimit_s;
    std::size_t at = 0;
    while (at < kLate_us.size() && double(t.sample.late_us) > kLate_us[at]) ++at;
    for (float& share : lateness_) share -= share * kForgetTick;
    lateness_[at] += kForgetTick;
  }
}

void DeviceLink::afterPanels(Application& app) {
  // A scene that was opened meanwhile has its own tracker.
  if (trying_s_ > 0.0 && !app.panels.device_page) stopTrying(app);
}

std::vector<const LimitWords*> DeviceLink::shownLimits() const {
  std::vector<const LimitWords*> out;
  for (std::size_t k = 0; k < limitWords().size(); ++k) {
    const Limit limit = limitWords()[k].limit;
    if (limit_left_s_[k] > 0.0 && limit != Limit::SoftStart && limit != Limit::Panic) out.push_back(&limitWords()[k]);
  }
  return out;
}

}  // namespace moltact
