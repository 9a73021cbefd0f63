#include "app/ui/extensions/device_link.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/application/panel_state.h"
#include "app/ui/extensions/task_stager.h"
#include "app/ui/files/settings.h"
#include "app/ui/widgets/layout.h"
#include "engine/language/catalogue.h"
#include "engine/servo/safety_stage.h"
#include "engine/workspace/scale.h"

namespace moltact {
namespace {

constexpr double kAsk_s = 0.25;  // interval between two queries of the device's state
constexpr double kTurn_rad_per_s = 1.5, kPan_heights_per_s = 0.5,
                 kCloser_per_s = 2.2;       // the speed of the view at full deflection of the device
constexpr float kForgetTick = 1.0f / 3000;  // forgetting factor: the classes cover the last 3 s
constexpr const char* kLent = "";           // the name of a device without a driver
constexpr std::uint32_t kClutchButton = 2;  // the second button of a stylus

}  // namespace

std::string DeviceLink::titleOf(const std::string& name) const {
  const auto one = std::find_if(found_.begin(), found_.end(), [&](const FoundDevice& f) { return f.name == name; });
  if (one != found_.end()) return tr(one->title.c_str());
  const DeviceDriver* const driver = findDriver(name);
  return driver && driver->find_at ? tr(driver->find_at("").title.c_str()) : name;
}

bool DeviceLink::noneChosen() const { return settings_.device.empty() && options_.device.empty(); }

std::string& DeviceLink::address(const DeviceDriver& driver) {
  const std::string own = std::string(driver.name) + ':';
  const auto [entry, is_new] = addresses_.try_emplace(std::string(driver.name));
  if (!is_new) return entry->second;
  for (const std::string* used : {&chosen_, &awaited_, &settings_.device_address})
    if (entry->second.empty() && used->starts_with(own)) entry->second = used->substr(own.size());
  return entry->second;
}

void DeviceLink::await(const std::string& name, const std::string& title) {
  awaited_ = name;
  awaited_title_ = title;
}

void DeviceLink::choose(const std::string& name) { wish(name, For::Choice); }

void DeviceLink::wish(const std::string& name, For purpose) {
  wish_ = Wish{name, purpose};
  unwanted_ = opening_ != nullptr;
  opening_title_ = purpose == For::Choice && name != "mouse" && name != chosen_ ? titleOf(name) : "";
}

// Runs between two frames. On the frames' clock it waits, so that scripts are deterministic.
void DeviceLink::openWished() {
  const bool waits = scene_.servo().clock() == ServoClock::Frames;
  if (opening_ && (waits || opening_->done())) finishOpening();
  if (opening_) return;
  if (!wish_ && !awaited_.empty() && time_.now_s - searched_s_ >= kLook_s) wish_ = Wish{awaited_, For::Awaited};
  if (!wish_) return;
  opened_for_ = *std::exchange(wish_, std::nullopt);
  const std::string& name = opened_for_.name;
  if (name == "mouse" || name == chosen_) {
    opening_title_.clear();
    if (name == "mouse") use(name, nullptr);
    finished(opened_for_);
    return;
  }
  unwanted_ = false;
  opening_ = std::make_unique<PendingDeviceOpen>(name, hardware_);
  if (waits) finishOpening();
}

void DeviceLink::finishOpening() {
  PendingDeviceOpen::Opened result = opening_->take();
  opening_.reset();
  if (opened_for_.purpose == For::Awaited) searched_s_ = time_.now_s;
  if (std::exchange(unwanted_, false)) return;
  opening_title_.clear();
  if (!result.in_use && !result.device) return failed(opened_for_, result);
  const std::string& name = opened_for_.name;
  if (result.in_use) {
    chosen_ = name;  // the device has another name in the list now
  } else {
    use(name, *std::move(result.device));
    hardware_ = result.hardware;
    if (result.found && !result.found->note.empty()) messages_.notice(result.found->note);
  }
  finished(opened_for_);
}

void DeviceLink::finished(const Wish& wish) {
  if (wish.purpose == For::Awaited)
    messages_.notice(trf("{0} is there and leads.", tr(scene_.servo().loop().device()->info().name.c_str())));
  await("", "");
  if (wish.purpose != For::Choice) return;
  settings_.device = wish.name;
  if (const DeviceDriver* driver = findDriver(wish.name); driver && driver->find_at)
    settings_.device_address = wish.name;
  messages_.takeBack(offer_id_);
}

void DeviceLink::failed(const Wish& wish, const PendingDeviceOpen::Opened& result) {
  switch (wish.purpose) {
    case For::Choice:
      messages_.error(result.device.problem().text());
      return;
    case For::Start: {
      // A name without a driver is dropped.
      const DeviceDriver* const driver = findDriver(wish.name);
      if (!result.found && !driver) return;
      await(wish.name, result.found ? tr(result.found->title.c_str()) : wish.name);
      // Only opening the address shows whether a server answers there.
      std::string why = result.found ? result.found->why : "";
      if (why.empty() && driver && driver->find_at) why = result.device.problem().message;
      messages_.notice(!why.empty() ? trf("{0} is not there ({1}). Until it is, the mouse leads.", awaited_title_, why)
                                    : trf("{0} is not there. Until it is, the mouse leads.", awaited_title_));
      return;
    }
    case For::GiveBack:
      await(wish.name, titleOf(wish.name));
      return;
    case For::Default:
    case For::Awaited:
      return;
  }
}

void DeviceLink::use(const std::string& name, std::unique_ptr<Device> device) {
  stopTrying();
  scene_.servo().setDevice(std::move(device));
  taken(name);
  // A haptic device has a limited workspace and a button for the clutch.
  scene_.servo_settings.clutch =
      name == "mouse" ? ClutchSettings() : ClutchSettings{.buttons = kClutchButton, .at_edge = true};
  scene_.view().fitDevice();
}

void DeviceLink::taken(const std::string& name) {
  chosen_ = name;
  hardware_.clear();
  status_ = DeviceStatus();
  messages_.takeBack(shown_id_);
  reported_.clear();
  asked_s_ = -1.0;
}

void DeviceLink::useTemporarily(std::unique_ptr<Device> device) {
  stopTrying();
  wish_.reset();
  unwanted_ = opening_ != nullptr;
  opening_title_.clear();
  scene_.servo().setDevice(std::move(device));
  taken(kLent);
}

// The mouse is used until the device is open again. The caller must no longer access the lent device.
void DeviceLink::giveBack(const std::string& before) {
  use("mouse", nullptr);
  if (before == "mouse" || before == kLent) return;
  wish(before, For::GiveBack);
  if (scene_.servo().clock() == ServoClock::Frames) openWished();
}

void DeviceLink::begin() {
  begun_ = true;
  const std::string& name = options_.device.empty() ? settings_.device : options_.device;
  takes_default_ = name.empty() && options_.devices_unasked;
  if (!name.empty() && name != "mouse" && !wish_) wish(name, For::Start);
}

double DeviceLink::lookEvery_s() const {
  if (panels_.pages.device) return kLook_s;
  return noneChosen() && options_.devices_unasked ? kLookForOffer_s : 0.0;
}

void DeviceLink::look() {
  if (std::optional<std::vector<FoundDevice>> seen = lister_.take(); seen && !seen->empty()) {
    found_ = std::move(*seen);
    offer();
  }
  const double every_s = lookEvery_s();
  if (every_s == 0.0 || (looked_s_ >= 0.0 && time_.now_s - looked_s_ < every_s)) return;
  looked_s_ = time_.now_s;
  lister_.begin(scene_.servo().clock() == ServoClock::Frames);
}

// Only at the start is a device used without being chosen. Later nothing changes without the user.
void DeviceLink::offer() {
  if (!noneChosen() || !options_.devices_unasked) return;
  if (std::exchange(takes_default_, false)) {
    const std::string name = defaultDevice(found_).name;
    if (name != "mouse") wish(name, For::Default);
    return;
  }
  if (scene_.servo().loop().device() && scene_.servo().loop().device()->info().gives_force) return;
  const auto best = std::find_if(found_.begin(), found_.end(), [](const FoundDevice& one) {
    return one.usable && one.auto_selectable && one.gives_force;
  });
  const std::string name = best == found_.end() ? "" : best->name;
  if (name == offered_) return;
  offered_ = name;
  messages_.takeBack(offer_id_);
  if (!name.empty())
    offer_id_ =
        messages_.ask(MessageKind::Notice,
                      trf("{0} is plugged in. Choose it on the device page to feel with it.", best->title), {"device"});
}

void DeviceLink::tryForce() {
  if (scene_.force().tryOut(kTry_N)) trying_s_ = kTry_s;
}

void DeviceLink::stopTrying() {
  trying_s_ = 0.0;
  scene_.force().endTrial();
}

// Lets a 6-DOF mouse or stick move the view, except while a task keeps the screen dark.
void DeviceLink::leadView() {
  Device* device = scene_.servo().loop().device();
  if (!device || !scene_.stage() || scene_.servo().loop().fallenBack() || stager_.dark()) return;
  const ViewMotion wish = device->viewMotion();
  const double dt = time_.dt_s;
  Camera& camera = scene_.camera;
  if (wish.rotation != Vec3(0.0)) {
    const Vec3 turn = wish.rotation * (kTurn_rad_per_s * dt);
    camera.orbit(turn.y, turn.x);
    camera.roll(turn.z);
  }
  if (wish.move != Vec3(0.0)) {
    const int height = std::max(1, int(layout_.view.size().y));
    camera.pan(wish.move.x * kPan_heights_per_s * height * dt, -wish.move.y * kPan_heights_per_s * height * dt, height);
    camera.zoom(std::pow(kCloser_per_s, wish.move.z * dt));
  }
}

void DeviceLink::beforeTicks() {
  if (!begun_) begin();
  look();
  openWished();
  leadView();
  scene_.view().follow();
  if (chosen_ != "mouse") scene_.servo_settings.clutch.buttons = stager_.takesSecondButton() ? 0 : kClutchButton;
  for (double& left : limit_left_s_) left = std::max(0.0, left - time_.dt_s);
  // The panic key, another scene and the playback of a recording end the test force.
  trying_s_ = scene_.force().trying() ? trying_s_ - time_.dt_s : 0.0;
  if (trying_s_ <= 0.0) stopTrying();
  ask();
}

// Shows the device's message while it holds, with actions.
void DeviceLink::ask() {
  Device* device = scene_.servo().loop().device();
  if (!device || (asked_s_ >= 0.0 && time_.now_s - asked_s_ < kAsk_s)) return;
  asked_s_ = time_.now_s;
  const DeviceStatus was = std::exchange(status_, device->status());
  const std::string name = tr(device->info().name.c_str());
  std::string now = status_.text;
  if (!status_.connected)
    now = trf("{0} Until then the mouse leads.", now);
  else if (!status_.ready)
    now = trf("{0} gives no force yet. {1}", name, now);
  if (now == reported_) return;
  messages_.takeBack(shown_id_);
  reported_ = now;
  if (wantsCalibration(scene_.servo()))
    shown_id_ = messages_.ask(MessageKind::Warning, now, {"calibrate", "device"});
  else if (!now.empty())
    shown_id_ = messages_.ask(MessageKind::Warning, now, {"device"});
  if (!was.connected && status_.connected && status_.ready)
    messages_.notice(trf("{0} leads again.", name));
  else if (!was.ready && status_.ready)
    messages_.notice(trf("{0} is ready.", name));
}

bool DeviceLink::wantsCalibration(const ServoLink& servo) const {
  return servo.loop().device() && status_.connected && status_.asks_calibrate;
}

void DeviceLink::watchTicks(const std::vector<ServoSample>& ticks) {
  for (const ServoSample& tick : ticks) {
    for (std::size_t k = 0; k < limitWords().size(); ++k)
      if (tick.limits.has(limitWords()[k].limit)) limit_left_s_[k] = kShowLimit_s;
    soft_start_s_ = tick.limits.has(Limit::SoftStart) ? soft_start_s_ + kTick_s : 0.0;
    std::size_t at = 0;
    while (at < kLate_us.size() && double(tick.late_us) > kLate_us[at]) ++at;
    for (float& share : lateness_) share -= share * kForgetTick;
    lateness_[at] += kForgetTick;
  }
}

void DeviceLink::afterPanels() {
  if (!panels_.pages.device) stopTrying();
  watchTicks(scene_.servo().everyTick());
}

DeviceLink::ScaleWords DeviceLink::scaleWords(const HapticSession& scene) const {
  const ServoSettings& s = scene.servo_settings;
  if (stager_.dark()) return {lengthScale(s.workspace) + ".", ""};
  const double felt = steadyStiffness_N_per_mm(s.stiffness_N_per_mm, scene.servo().device());
  return {scaleSentence(s.workspace, felt), scaleReason(s.workspace, felt)};
}

std::vector<const LimitWords*> DeviceLink::actingLimits() const {
  std::vector<const LimitWords*> out;
  for (std::size_t k = 0; k < limitWords().size(); ++k)
    if (limit_left_s_[k] > 0.0) out.push_back(&limitWords()[k]);
  return out;
}

std::vector<std::string> DeviceLink::limitNotices() const {
  std::vector<std::string> out;
  const bool gives_force = scene_.servo().device().gives_force;
  for (const LimitWords* one : actingLimits()) {
    if (!gives_force && (one->limit != Limit::LateLoop || !scene_.controls.pressing())) continue;
    if (one->limit == Limit::Panic || (one->limit == Limit::SoftStart && soft_start_s_ < kLongStart_s)) continue;
    // The device's message is more precise; it is shown only once.
    const bool own_words = one->limit == Limit::DeviceFault && !reported_.empty();
    if (!own_words)
      out.emplace_back(tr(one->sentence));
    else if (!messages_.shows(shown_id_))
      out.push_back(reported_);
  }
  return out;
}

}  // namespace moltact
