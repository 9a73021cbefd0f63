#include "engine/device/omni/omni_device.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {

constexpr int kStaleReads = 100;     // reads from outside the callback until the device counts as gone
constexpr int kTroubleTicks = 500;   // without force after the driver cut one
constexpr int kWarmTicks = 5000;     // with small force after the driver found the motors warm
constexpr int kLookTicks = 100;      // between two looks at calibration and temperature
constexpr auto kShowError = std::chrono::seconds(5);
constexpr auto kTryAgain = std::chrono::seconds(2);
constexpr auto kLastFrame = std::chrono::milliseconds(100);
constexpr int kMostErrors = 64;      // drained at once; the stack is short

// One device of this kind in a process: the driver has one default device.
std::atomic<bool> in_use{false};

std::string words(std::uint32_t code) {
  const hd::ErrorWords text = hd::errorWords(code);
  return text.message + ' ' + text.remedy;
}

}  // namespace

bool OmniDevice::inUse() { return in_use.load(); }

Expected<std::unique_ptr<OmniDevice>> OmniDevice::open() {
  const auto library = hd::Library::get();
  if (!library) return library.problem();
  if (in_use.exchange(true)) return Problem{"", 0, 0, "the device is open already", "close it first"};
  std::unique_ptr<OmniDevice> device(new OmniDevice(**library));
  if (auto problem = device->initialise()) return *problem;
  return Expected<std::unique_ptr<OmniDevice>>(std::move(device));
}

OmniDevice::~OmniDevice() {
  stopClock();
  if (device_ != hd::kInvalidHandle) hd_.disableDevice(device_);
  in_use.store(false);
}

std::optional<Problem> OmniDevice::initialise() {
  while (hd_.getError().code != hd::kNoError) {}
  device_ = hd_.initDevice(nullptr);
  const std::uint32_t error = hd_.getError().code;
  if (device_ == hd::kInvalidHandle || error != hd::kNoError) {
    device_ = hd::kInvalidHandle;
    const hd::ErrorWords text = hd::errorWords(error == hd::kNoError ? std::uint32_t(hd::kCommError) : error);
    return Problem{"", 0, 0, "no Omni or Touch could be opened: " + text.message, text.remedy};
  }
  hd_.makeCurrentDevice(device_);
  const auto text = [&](std::uint32_t name) {
    const char* found = hd_.getString(name);
    return std::string(found ? found : "");
  };
  model_ = text(hd::kModel);
  serial_ = text(hd::kSerial);
  info_ = DeviceInfo();
  info_.name = model_.empty() ? "Omni" : model_;
  info_.gives_force = true;
  // What the driver does not tell, or tells as 0, stays the Omni's published figure.
  const auto figure = [&](std::uint32_t name, double& to, double scale) {
    double value = 0;
    hd_.getDoublev(name, &value);
    if (std::isfinite(value) && value > 0) to = value * scale;
  };
  info_.continuous_force_N = 0.88;
  figure(hd::kMaxForce, info_.max_force_N, 1.0);
  figure(hd::kMaxContinuousForce, info_.continuous_force_N, 1.0);
  figure(hd::kMaxStiffness, info_.max_stiffness_N_per_mm, 1.0);
  figure(hd::kMaxDamping, info_.max_damping_N_s_per_m, 1e3);  // the driver tells N s/mm
  double box[6] = {};
  hd_.getDoublev(hd::kUsableWorkspace, box);
  const Vec3 size(box[3] - box[0], box[4] - box[1], box[5] - box[2]);
  if (finite(size) && size.x > 0 && size.y > 0 && size.z > 0) info_.workspace_mm = size;
  info_.dof_in = 6;
  info_.dof_out = 3;
  hd_.getIntegerv(hd::kInputDof, &info_.dof_in);
  hd_.getIntegerv(hd::kOutputDof, &info_.dof_out);
  int style = 0;
  hd_.getIntegerv(hd::kCalibrationStyle, &style);
  calibration_style_ = std::uint32_t(style);
  hd_.enable(hd::kForceOutput);
  hd_.enable(hd::kMaxForceClamping);
  hd_.enable(hd::kForceRamping);
  while (hd_.getError().code != hd::kNoError) {}
  gone_.store(false);
  pose_ = {};
  return std::nullopt;
}

bool OmniDevice::startClock(TickTarget& target) {
  target_ = &target;
  schedule();
  return true;
}

void OmniDevice::schedule() {
  if (device_ == hd::kInvalidHandle) return;
  ends_.store(false);
  ended_.store(false);
  stale_reads_ = frames_ = 0;
  scheduled_ = hd_.scheduleAsynchronous(&OmniDevice::callback, this, hd::kHighestPriority);
  hd_.setSchedulerRate(1000);
  hd_.startScheduler();
  scheduling_ = true;
  if (drainErrors()) gone_.store(true);
}

void OmniDevice::unschedule() {
  if (!scheduling_) return;
  scheduling_ = false;
  // The callback's last frame gives no force; where the scheduler has died there is none to wait for.
  ends_.store(true, std::memory_order_release);
  const auto until = std::chrono::steady_clock::now() + kLastFrame;
  while (!ended_.load(std::memory_order_acquire) && std::chrono::steady_clock::now() < until)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  hd_.stopScheduler();
  hd_.unschedule(scheduled_);
  while (hd_.getError().code != hd::kNoError) {}
}

void OmniDevice::stopClock() {
  unschedule();
  target_ = nullptr;
}

hd::CallbackCode OmniDevice::callback(void* self) { return static_cast<OmniDevice*>(self)->frame(); }

hd::CallbackCode OmniDevice::frame() noexcept {
  if (ended_.load(std::memory_order_relaxed)) return hd::kDone;
  const bool look = frames_++ % kLookTicks == 0;
  if (look || calibrate_.load(std::memory_order_acquire)) checkCalibration();  // before the frame begins, as the interface asks

  hd_.beginFrame(device_);
  double position[3] = {};
  int buttons = 0, inkwell = 0;
  hd_.getDoublev(hd::kPosition, position);
  hd_.getIntegerv(hd::kButtons, &buttons);
  hd_.getIntegerv(hd::kInkwellSwitch, &inkwell);
  if (look) {
    double heat[6] = {};
    hd_.getDoublev(hd::kMotorTemperature, heat);
    motor_heat_.store(std::clamp(*std::max_element(heat, heat + 6), 0.0, 1.0), std::memory_order_relaxed);
  }
  in_inkwell_.store(inkwell != 0, std::memory_order_relaxed);
  pose_.position.mm = {position[0], position[1], position[2]};
  pose_.buttons = std::uint32_t(buttons);
  pose_.fresh = true;
  pose_.connected = !gone_.load(std::memory_order_relaxed);
  const double heat = motor_heat_.load(std::memory_order_relaxed);
  pose_.motor_heat = warm_ticks_ > 0 ? 1.0f : float(std::isfinite(heat) ? std::max(0.0, heat) : 1.0);
  pose_.trouble = troubled_ticks_ > 0 || calibration_.load(std::memory_order_relaxed) != hd::kCalibrated;
  if (troubled_ticks_ > 0) --troubled_ticks_;
  if (warm_ticks_ > 0) --warm_ticks_;

  const bool ends = ends_.load(std::memory_order_acquire);
  force_N_ = Vec3(0.0);
  if (!ends && target_) {
    frame_thread_.store(std::this_thread::get_id(), std::memory_order_relaxed);
    stale_reads_ = 0;
    target_->tickOfDevice();
    frame_thread_.store(std::thread::id(), std::memory_order_relaxed);
  }
  const double force[3] = {force_N_.x, force_N_.y, force_N_.z};
  hd_.setDoublev(hd::kCurrentForce, force);
  hd_.endFrame(device_);
  const bool broken = drainErrors();
  if (ends || broken) {
    ended_.store(true, std::memory_order_release);
    return hd::kDone;
  }
  return hd::kContinue;
}

void OmniDevice::checkCalibration() noexcept {
  std::uint32_t state = hd_.checkCalibration();
  const bool asked = calibrate_.exchange(false, std::memory_order_acq_rel);
  // The reset of the encoders takes the stylus's present place for the resting one: only when the person says so.
  if (calibration_style_ & hd::kInkwell || calibration_style_ & hd::kAuto) {
    if (state == hd::kNeedsUpdate) {
      hd_.updateCalibration(calibration_style_ & hd::kInkwell ? hd::kInkwell : hd::kAuto);
      state = hd_.checkCalibration();
    }
  } else if (state != hd::kCalibrated && asked) {
    hd_.updateCalibration(hd::kEncoderReset);
    state = hd_.checkCalibration();
  }
  calibration_.store(state, std::memory_order_relaxed);
}

// True where the device or its clock is lost.
bool OmniDevice::drainErrors() noexcept {
  bool lost = false;
  for (int k = 0; k < kMostErrors; ++k) {
    const hd::ErrorInfo error = hd_.getError();
    if (error.code == hd::kNoError) break;
    last_error_.store(error.code, std::memory_order_relaxed);
    errors_.fetch_add(1, std::memory_order_release);
    if (error.code == hd::kWarmMotors) warm_ticks_ = kWarmTicks;
    else if (error.code > hd::kWarmMotors && error.code <= hd::kForceError) troubled_ticks_ = kTroubleTicks;
    else if ((error.code >= hd::kDeviceFault && error.code <= hd::kTimerError) || error.code == hd::kBadHandle ||
             error.code == hd::kSchedulerFull || error.code == hd::kInvalidPriority)
      lost = true;
  }
  if (lost) gone_.store(true, std::memory_order_relaxed);
  return lost;
}

DevicePose OmniDevice::read(double) noexcept {
  if (frame_thread_.load(std::memory_order_relaxed) == std::this_thread::get_id()) return pose_;
  // The maker's clock stands and the loop's own has taken over.
  DevicePose stale = pose_;
  stale.fresh = false;
  stale.connected = ++stale_reads_ <= kStaleReads && !gone_.load(std::memory_order_relaxed);
  return stale;
}

void OmniDevice::write(ForceN force) noexcept {
  if (frame_thread_.load(std::memory_order_relaxed) == std::this_thread::get_id()) force_N_ = force.N;
}

DeviceStatus OmniDevice::status() {
  const auto now = std::chrono::steady_clock::now();
  DeviceStatus status;
  status.motor_heat = motor_heat_.load(std::memory_order_relaxed);

  if (gone_.load() && now >= try_again_) {
    try_again_ = now + kTryAgain;
    unschedule();
    if (device_ != hd::kInvalidHandle) hd_.disableDevice(device_);
    device_ = hd::kInvalidHandle;
    if (!initialise() && target_) schedule();
  }
  if (gone_.load()) {
    status.connected = status.ready = false;
    const std::uint32_t error = last_error_.load(std::memory_order_relaxed);
    status.text = words(error == hd::kNoError ? std::uint32_t(hd::kCommError) : error);
    return status;
  }

  if (const std::uint32_t count = errors_.load(std::memory_order_acquire); count != errors_told_) {
    errors_told_ = count;
    error_shown_ = last_error_.load(std::memory_order_relaxed);
    shown_until_ = now + kShowError;
  }
  switch (calibration_.load(std::memory_order_relaxed)) {
    case hd::kCalibrated: break;
    case hd::kNeedsUpdate: status.text = "The device is being calibrated: leave the stylus where it is."; break;
    default:
      if (calibration_style_ & hd::kInkwell)
        status.text = in_inkwell_.load() ? "Calibrating: leave the stylus in the inkwell."
                                         : "Put the stylus's tip into the inkwell, the dark hole in the device, and leave it there until this goes away.";
      else if (calibration_style_ & hd::kAuto)
        status.text = "Move the stylus slowly to and fro, as far as it goes on every side, until this goes away.";
      else
        status.text = "Hold the arm in its resting place, all joints at right angles as in the maker's picture, and press Calibrate.";
  }
  status.ready = status.text.empty();
  if (status.text.empty() && now < shown_until_) status.text = words(error_shown_);
  return status;
}

}  // namespace moltact
