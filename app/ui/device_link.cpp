#include "app/ui/device_link.h"

#include <algorithm>
#include <cmath>

#include "app/ui/application.h"
#include "app/ui/extensions.h"
#include "engine/servo/plain_trackers.h"
#include "engine/servo/safety_stage.h"
#include "engine/servo/scale.h"

namespace moltact {
namespace {

constexpr double kAsk_s = 0.25;             // between two questions for the device's state
constexpr double kLookAgain_s = 2.0;        // for a device that is waited for
constexpr double kTurned = 1e-9;            // a view that has turned by less has not
constexpr double kTurn_rad_per_s = 1.5, kPan_heights_per_s = 0.5, kCloser_per_s = 2.2;  // of a view that a device leads fully
constexpr float kForgetTick = 1.0f / 3000;  // so the classes stand for the last 3 s
constexpr std::uint32_t kClutchButton = 2;  // the stylus's second

}  // namespace

void DeviceLink::look() { found_ = findDevices(); }

void DeviceLink::choose(Application& app, const std::string& name) {
  if (const std::optional<Problem> problem = use(app, name)) {
    app.messages.error(problem->text());
    return;
  }
  awaited_.clear();
  awaited_title_.clear();
  app.settings.device = name;
}

std::optional<Problem> DeviceLink::use(Application& app, const std::string& name, std::unique_ptr<Device> opened) {
  stopTrying(app);
  ServoLink& servo = app.scene.servo();
  if (name == "mouse") {
    servo.setDevice(nullptr);
  } else {
    // The old one goes first: it may be the same.
    if (name == chosen_) return std::nullopt;
    Expected<std::unique_ptr<Device>> device = opened ? std::move(opened) : openDevice(name);
    if (!device) return device.problem();
    servo.setDevice(std::move(*device));
  }
  chosen_ = name;
  status_ = DeviceStatus();
  asked_s_ = -1.0;
  // A hand that is held has an edge to its room, and a button to reach beyond it.
  app.scene.servo_settings.clutch = name == "mouse" ? ClutchSettings() : ClutchSettings{.buttons = kClutchButton, .at_edge = true};
  app.scene.fitToDevice();
  return std::nullopt;
}

void DeviceLink::begin(Application& app) {
  begun_ = true;
  std::string name = app.settings.device;
  // On a script's clock a device that happens to be plugged in is none of the script's business.
  if (name.empty() && app.scene.servo().clock() == ServoClock::RealThread) name = defaultDevice(findDevices()).name;
  if (name.empty() || name == "mouse") return;
  const std::optional<FoundDevice> found = findDevice(name);
  if (found && found->usable && !use(app, name)) return;
  // A name that no driver has any more is forgotten.
  if (!found && !findDevice(name.substr(0, name.find(':')))) return;
  awaited_ = name;
  awaited_title_ = found ? found->title : name;
  app.messages.notice(awaited_title_ + " is not there" + (found && !found->why.empty() ? " (" + found->why + ")" : "") + ". Until it is, the mouse leads.");
}

// The search is not the window's: a driver may take seconds to find that there is no device. A script waits, for its clock is
// not the search's.
void DeviceLink::await(Application& app) {
  if (!search_ && !awaited_.empty() && app.now_s() - looked_s_ >= kLookAgain_s) search_ = std::make_unique<DeviceSearch>(awaited_);
  if (!search_ || (!search_->done() && app.scene.servo().clock() == ServoClock::RealThread)) return;
  auto device = search_->take();
  search_.reset();
  looked_s_ = app.now_s();
  if (!device || awaited_.empty() || use(app, awaited_, std::move(*device))) return;
  awaited_.clear();
  awaited_title_.clear();
  app.messages.notice(app.scene.servo().chosen()->info().name + " is there and leads.");
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

// A cap or a stick that leads the view; not while a task keeps the screen dark.
void DeviceLink::leadView(Application& app) {
  Device* device = app.scene.servo().chosen();
  if (!device || !app.scene.stage() || app.scene.servo().fallenBack() || app.extensions().task_stager.dark()) return;
  const ViewWish wish = device->viewWish();
  const double dt = app.dt_s();
  Camera& camera = app.scene.camera;
  if (wish.turn != Vec3(0.0)) {
    const Vec3 turn = wish.turn * (kTurn_rad_per_s * dt);
    camera.orbit(turn.y, turn.x);
    camera.roll(turn.z);
  }
  if (wish.move != Vec3(0.0)) {
    const int height = std::max(1, int(app.layout().view.size().y));
    camera.pan(wish.move.x * kPan_heights_per_s * height * dt, -wish.move.y * kPan_heights_per_s * height * dt, height);
    camera.zoom(std::pow(kCloser_per_s, wish.move.z * dt));
  }
}

void DeviceLink::beforeTicks(Application& app) {
  if (!begun_) begin(app);
  await(app);
  leadView(app);
  turnWithView(app);
  if (chosen_ != "mouse")
    app.scene.servo_settings.clutch.buttons = app.extensions().task_stager.takesSecondButton() ? 0 : kClutchButton;
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

DeviceLink::ScaleWords DeviceLink::scaleWords(const Application& app) const {
  const ServoSettings& s = app.scene.servo_settings;
  if (app.extensions().task_stager.dark()) return {lengthScale(s.workspace) + ".", ""};
  const double felt = steadyStiffness_N_per_mm(s.stiffness_N_per_mm, app.scene.servo().device());
  return {scaleSentence(s.workspace, felt), scaleReason(s.workspace, felt)};
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
