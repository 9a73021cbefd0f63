#include "engine/device/omni/omni_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/device/omni/omni_connection.h"
#include "engine/language/catalogue.h"
#include "engine/platform/background.h"

namespace moltact {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kStaleReads = 100;      // reads outside the callback after which the device counts as disconnected
constexpr int kReportStall = 250;     // reads after which the stall is reported and the device reopened
constexpr int kReportNoFrame = 2000;  // the same if the clock was started and has not ticked yet
constexpr int kFaultTicks = 500;      // ticks without force after the driver has cut one
constexpr int kWarmTicks = 5000;      // ticks with small force after the driver has reported warm motors
constexpr int kLookTicks = 100;       // ticks between two readings of the temperature
constexpr int kUpdateTicks = 10;      // ticks between two updates of a missing calibration
constexpr int kResetTicks = 3000;     // ticks for which the reset of the encoders is tried
constexpr auto kShowError = std::chrono::seconds(5);
constexpr auto kTryAgain = std::chrono::seconds(2);
constexpr auto kLastFrame = std::chrono::milliseconds(100);

std::string words(std::uint32_t code) {
  const hd::ErrorWords text = hd::errorWords(code);
  return text.message + ' ' + text.remedy;
}

// Keeps the most severe error of several stacks and frames until the window reads it.
void keepWorst(std::atomic<std::uint32_t>& worst, std::uint32_t code) noexcept {
  std::uint32_t kept = worst.load(std::memory_order_relaxed);
  while (hd::errorWeight(code) > hd::errorWeight(kept) &&
         !worst.compare_exchange_weak(kept, code, std::memory_order_relaxed)) {
  }
}

}  // namespace

std::optional<OmniDevice::Seen> OmniDevice::taken() {
  const auto session = OmniConnection::get().taken();
  if (!session) return std::nullopt;
  return Seen{session->model, session->serial};
}
void OmniDevice::closeUnused() { OmniConnection::get().closeUnused(); }

Expected<std::unique_ptr<OmniDevice>> OmniDevice::open(std::int64_t (*now_ns)() noexcept) {
  const auto library = hd::Library::get();
  if (!library) return library.problem();
  auto session = OmniConnection::get().take(**library);
  if (!session) return session.problem();
  return std::unique_ptr<OmniDevice>(new OmniDevice(**library, std::move(*session), now_ns));
}

Expected<OmniDevice::Seen> OmniDevice::look() {
  const auto library = hd::Library::get();
  if (!library) return library.problem();
  const auto seen = OmniConnection::get().look(**library);
  if (!seen) return seen.problem();
  return Seen{seen->model, seen->serial};
}

OmniDevice::OmniDevice(const hd::Library& library, OmniSession session, std::int64_t (*now_ns)() noexcept)
    : hd_(library), info_(session.info), session_(std::move(session)), guard_(library, now_ns) {}

OmniDevice::~OmniDevice() {
  stopClock();
  closeOmni(hd_, session_);
  OmniConnection::get().giveBack();
}

bool OmniDevice::startClock(ClockListener& target) {
  finishRevival();
  target_.store(&target);
  schedule();
  return true;
}

void OmniDevice::schedule() {
  if (session_.device == hd::kInvalidHandle) return;
  handle_.store(session_.device);
  calibration_style_.store(session_.calibration_style);
  workspace_middle_mm_ = session_.workspace_middle_mm;
  calibrate_.store(false);
  framed_.store(false);
  stalled_reads_.store(0);
  ends_.store(false);
  anew_.store(true);
  none_given_.store(true);
  ended_.store(false);
  guard_.start();
  last_act_.arm(&OmniDevice::lastAct, this);
  scheduled_ = hd_.scheduleAsynchronous(&OmniDevice::callback, this, hd::kHighestPriority);
  hd_.setSchedulerRate(1000);
  hd_.startScheduler();
  scheduling_ = true;
  note(drainErrors(hd_));
}

void OmniDevice::unschedule() {
  if (!scheduling_) return;
  scheduling_ = false;
  // The callback's last frame gives no force. If the scheduler has died there is none.
  ends_.store(true, std::memory_order_release);
  const auto until = Clock::now() + kLastFrame;
  while (!ended_.load(std::memory_order_acquire) && Clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  const bool last_frame_came = ended_.exchange(true, std::memory_order_acq_rel);
  guard_.stop();
  const bool none_given = last_frame_came && none_given_.load(std::memory_order_acquire);
  if (!none_given) guard_.switchOff();
  hd_.stopScheduler();
  if (!none_given) writeZeroForce();  // the callback no longer runs
  hd_.unschedule(scheduled_);
  last_act_.disarm();
  drainErrors(hd_);
}

void OmniDevice::stopClock() {
  finishRevival();
  unschedule();
  target_.store(nullptr);
}

void OmniDevice::revive() {
  revival_ = inBackground([this]() -> Expected<OmniSession> {
    unschedule();
    closeOmni(hd_, session_);
    return openOmni(hd_);
  });
}

void OmniDevice::takeRevived() {
  Expected<OmniSession> session = revival_.get();
  if (!session) {
    why_not_ = session.problem().text();
    gone_.store(true);
    return;
  }
  why_not_.clear();
  session_ = std::move(*session);
  info_.set(session_.info);
  OmniConnection::get().renewed(session_);
  gone_.store(false);
}

// Waits for a running revival.
void OmniDevice::finishRevival() {
  if (revival_.valid()) takeRevived();
}

hd::CallbackCode OmniDevice::callback(void* self) { return static_cast<OmniDevice*>(self)->frame(); }

// The first frame after the start of the clock: the motion of the hand meanwhile is unknown.
void OmniDevice::begin() noexcept {
  const std::uint32_t discontinuities = own_.pose.discontinuities;
  own_ = {};
  own_.pose.discontinuities = discontinuities + 1;
}

hd::CallbackCode OmniDevice::frame() noexcept {
  if (ended_.load(std::memory_order_acquire)) return hd::kDone;
  if (anew_.exchange(false, std::memory_order_acq_rel)) begin();
  guard_.frame();
  const bool ends = ends_.load(std::memory_order_acquire);
  if (own_.broken)
    writeZeroForce();
  else
    tickFrame(ends);
  // A last frame that the driver has not accepted is repeated while unschedule() waits.
  if (!ends || (!own_.broken && !none_given_.load(std::memory_order_acquire))) return hd::kContinue;
  ended_.store(true, std::memory_order_release);
  return hd::kDone;
}

// Writes the force and ends the frame; `failed`: its begin has failed. Returns true if the device or its clock is lost.
// A failed frame leaves the force of an earlier one on the motors, so the output is switched off in this tick.
bool OmniDevice::endFrame(const Vec3& force_N, bool failed) noexcept {
  const double force[3] = {force_N.x, force_N.y, force_N.z};
  hd_.setDoublev(hd::kCurrentForce, force);
  hd_.endFrame(handle_.load(std::memory_order_relaxed));
  const Drained after = drain();
  if (failed || after.fails_frame) {
    guard_.switchOff();
  } else {
    none_given_.store(force_N == Vec3(0.0), std::memory_order_release);
    if (!own_.broken) guard_.written();
  }
  return after.lost;
}

// A complete frame without force.
void OmniDevice::writeZeroForce() noexcept {
  drain();
  hd_.beginFrame(handle_.load(std::memory_order_relaxed));
  endFrame(Vec3(0.0), drain().fails_frame);
}

OmniDevice::Drained OmniDevice::drain() noexcept {
  Drained out;
  out.lost = note(drainErrors(hd_, [&](std::uint32_t code) {
    out.fails_frame = out.fails_frame || hd::failsFrame(code);
    if (code == hd::kWarmMotors)
      own_.warm_ticks = kWarmTicks;
    else if (hd::cutsForce(code))
      own_.fault_ticks = kFaultTicks;
  }));
  return out;
}

void OmniDevice::tickFrame(bool ends) noexcept {
  look(own_.frames++ % kLookTicks == 0);  // before the frame begins, as the interface requires

  bool broken = drain().lost;  // errors of earlier calls do not belong to this frame
  hd_.beginFrame(handle_.load(std::memory_order_relaxed));
  const Drained begun = drain();
  own_.begin_failed = begun.fails_frame;
  if (begun.fails_frame) guard_.switchOff();
  double position[3] = {}, transform[16] = {};
  int buttons = 0;
  hd_.getDoublev(hd::kPosition, position);
  hd_.getDoublev(hd::kTransform, transform);
  hd_.getIntegerv(hd::kButtons, &buttons);
  if (calibration_style_.load(std::memory_order_relaxed) & hd::kInkwell) {
    hd::Boolean out_of_inkwell = 1;  // the switch is on while it is not pressed
    hd_.getBooleanv(hd::kInkwellSwitch, &out_of_inkwell);
    in_inkwell_.store(!out_of_inkwell, std::memory_order_relaxed);
  }
  // Checked before the force is written, so that an error ends the force in this frame.
  broken = drain().lost || begun.lost || broken;
  DevicePose& pose = own_.pose;
  pose.fresh = !begun.fails_frame;
  pose.age_s = pose.fresh ? 0.0f : pose.age_s + 0.001f;
  if (pose.fresh) {
    pose.position.mm = Vec3(position[0], position[1], position[2]) - workspace_middle_mm_;
    pose.orientation = hd::orientationOf(transform, pose.orientation);
    pose.buttons = std::uint32_t(buttons);
  }
  pose.connected = !gone_.load(std::memory_order_relaxed);
  const double heat = motor_heat_.load(std::memory_order_relaxed);
  pose.motor_heat = own_.warm_ticks > 0 ? 1.0f : float(std::max(0.0, heat));
  pose.fault = own_.fault_ticks > 0 || guard_.cut() || calibration_.load(std::memory_order_relaxed) != hd::kCalibrated;
  own_.fault_ticks = std::max(0, own_.fault_ticks - 1);
  own_.warm_ticks = std::max(0, own_.warm_ticks - 1);
  last_pose_.write(pose);
  framed_.store(true, std::memory_order_release);
  stalled_reads_.store(0, std::memory_order_relaxed);

  own_.force_N = Vec3(0.0);
  if (ClockListener* const target = target_.load(std::memory_order_acquire); target && !ends && !broken) {
    frame_thread_.store(std::this_thread::get_id(), std::memory_order_release);
    target->onDeviceTick();
    frame_thread_.store(std::thread::id(), std::memory_order_release);
  }
  // The output may be switched on again only during a frame without force.
  if (forceInhibited() || guard_.cut()) own_.force_N = Vec3(0.0);
  broken = endFrame(own_.force_N, begun.fails_frame) || broken;
  if (!broken) return;
  // In this tick, because there may be no other. Even if the driver accepts only one frame per tick, the output is off.
  // Later frames do not restart the force.
  own_.broken = true;
  guard_.switchOff();
  writeZeroForce();
}

// Called in a signal handler.
bool OmniDevice::lastAct(void* data) noexcept {
  OmniDevice& self = *static_cast<OmniDevice*>(data);
  if (self.ended_.load(std::memory_order_acquire)) return true;
  if (self.frame_thread_.load(std::memory_order_acquire) == std::this_thread::get_id()) {
    // The signal has interrupted a frame that this thread has open. The interrupted code is our own and holds no lock
    // of the driver, so the frame can be ended here.
    self.frame_thread_.store(std::thread::id(), std::memory_order_release);
    self.endFrame(Vec3(0.0), self.own_.begin_failed);
  }
  return self.none_given_.load(std::memory_order_acquire) || self.guard_.off();
}

void OmniDevice::look(bool now) noexcept {
  if (calibrate_.exchange(false, std::memory_order_acq_rel)) own_.resetting_ticks = kResetTicks;
  // In each tick, so that no force is based on an invalid position.
  checkCalibration(now || own_.frames % kUpdateTicks == 0);
  if (own_.resetting_ticks > 0 && --own_.resetting_ticks == 0) reset_failed_.store(true, std::memory_order_relaxed);
  resetting_.store(own_.resetting_ticks > 0, std::memory_order_relaxed);
  if (!now) return;
  double heat[6] = {};
  hd_.getDoublev(hd::kMotorTemperature, heat);
  const double largest = *std::max_element(heat, heat + 6);
  motor_heat_.store(std::isfinite(largest) ? std::clamp(largest, 0.0, 1.0) : 1.0, std::memory_order_relaxed);
}

void OmniDevice::checkCalibration(bool may_update) noexcept {
  const std::uint32_t style = calibration_style_.load(std::memory_order_relaxed);
  std::uint32_t state = hd_.checkCalibration();
  // The reset of the encoders assumes that the stylus is in its rest position. It is performed only after the user's
  // confirmation, and repeated until the driver has accepted it.
  const bool automatic = style & (hd::kInkwell | hd::kAuto);
  const bool update =
      may_update && (automatic ? state == hd::kNeedsUpdate : state != hd::kCalibrated && own_.resetting_ticks > 0);
  if (update) {
    hd_.updateCalibration(style & hd::kInkwell ? hd::kInkwell : style & hd::kAuto ? hd::kAuto : hd::kEncoderReset);
    state = hd_.checkCalibration();
  }
  if (state == hd::kCalibrated) {
    own_.resetting_ticks = 0;
    reset_failed_.store(false, std::memory_order_relaxed);
  }
  calibration_.store(state, std::memory_order_relaxed);
}

// Any thread. Returns true if the device or its clock is lost.
bool OmniDevice::note(std::uint32_t worst) noexcept {
  if (worst == hd::kNoError) return false;
  keepWorst(worst_error_, worst);
  if (!hd::endsConnection(worst)) return false;
  lost_by_.store(worst, std::memory_order_relaxed);
  gone_.store(true, std::memory_order_release);
  return true;
}

DevicePose OmniDevice::read(double) noexcept {
  if (frame_thread_.load(std::memory_order_relaxed) == std::this_thread::get_id()) return own_.pose;
  // The vendor's clock is stalled and the loop's own clock has taken over.
  DevicePose stale = last_pose_.read();
  const int stood = stalled_reads_.fetch_add(1, std::memory_order_relaxed) + 1;
  stale.fresh = false;
  stale.age_s = 0.001f * float(stood);
  stale.connected =
      framed_.load(std::memory_order_acquire) && stood <= kStaleReads && !gone_.load(std::memory_order_acquire);
  return stale;
}

void OmniDevice::write(ForceN force) noexcept {
  if (frame_thread_.load(std::memory_order_relaxed) == std::this_thread::get_id()) own_.force_N = force.N;
}

bool OmniDevice::lost() const noexcept {
  return gone_.load(std::memory_order_acquire) ||
         stalled_reads_.load() > (framed_.load() ? kReportStall : kReportNoFrame);
}

DeviceStatus OmniDevice::status() {
  const auto now = Clock::now();
  if (revival_.valid() && revival_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) {
    takeRevived();
    if (!gone_.load() && target_.load()) schedule();
    try_again_ = now + kTryAgain;
  }
  DeviceStatus status;
  status.motor_heat = motor_heat_.load(std::memory_order_relaxed);
  if (revival_.valid() || lost()) {
    if (!revival_.valid() && now >= try_again_) revive();
    status.connected = status.ready = false;
    const std::uint32_t error = lost_by_.load(std::memory_order_relaxed);
    if (!why_not_.empty())
      status.text = why_not_;
    else if (!gone_.load())
      status.text = tr("The driver of the device no longer answers. It is opened anew.");
    else
      status.text = words(error == hd::kNoError ? std::uint32_t(hd::kCommError) : error);
    return status;
  }

  if (const std::uint32_t error = worst_error_.exchange(hd::kNoError, std::memory_order_relaxed); error != hd::kNoError)
    if (now >= shown_until_ || hd::errorWeight(error) >= hd::errorWeight(error_shown_)) {
      error_shown_ = error;
      shown_until_ = now + kShowError;
    }
  if (framed_.load(std::memory_order_acquire)) status.text = guidance(status);  // unknown before the first frame
  status.ready = status.text.empty();
  if (status.text.empty() && now < shown_until_) status.text = words(error_shown_);
  return status;
}

// The instructions for the calibration; empty when it is complete.
std::string OmniDevice::guidance(DeviceStatus& status) const {
  const std::uint32_t state = calibration_.load(std::memory_order_relaxed),
                      style = calibration_style_.load(std::memory_order_relaxed);
  if (state == hd::kCalibrated) return "";
  const bool updating =
      style & (hd::kInkwell | hd::kAuto) ? state == hd::kNeedsUpdate : resetting_.load(std::memory_order_relaxed);
  if (updating) return tr("The device is being calibrated: leave the stylus where it is.");
  if (style & hd::kInkwell)
    return in_inkwell_.load() ? tr("Calibrating: leave the stylus in the inkwell.")
                              : tr("Put the stylus's tip into the inkwell, the dark hole in the device, and leave it "
                                   "there until this goes away.");
  if (style & hd::kAuto)
    return tr("Move the stylus slowly to and fro, as far as it goes on every side, until this goes away.");
  status.asks_calibrate = true;
  std::string hold = tr("Hold the arm in its resting place, all joints at right angles as in the maker's picture.");
  if (reset_failed_.load(std::memory_order_relaxed)) hold = tr("The device did not take that place.") + (" " + hold);
  return hold;
}

}  // namespace moltact
