// A stand-in for OpenHaptics' libHD.so, built from its published documentation, with the device model in the scripted
// hand behind it. It is as strict as the documentation. Calls outside a frame, getters of the wrong type, nested
// begins, a second frame per tick and bad handles push errors onto the stack, newest first. The callback runs without
// its lock. The functions standIn… are for tests: they advance its clock or let it run at 1 kHz, and simulate events of
// a device. In a separate process (STAND_IN_LOG, a file) it runs at 1 kHz from the start and logs how the device was
// closed. STAND_IN_STYLE sets the calibration style. STAND_IN_ROOM_Z shifts the centre of its workspace that many mm in
// front of its hand's. It appends each force, in N, to the file STAND_IN_FORCES, and "off" and "on" for its output, one
// line each after the monotonic time in ns; the lines survive any end of the process. While the file
// STAND_IN_FRAMES_FAIL exists, no frame can begin.
#include <fcntl.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "engine/device/device_model.h"
#include "engine/device/omni/hd_library.h"
#include "engine/device/scripted_hand.h"

using namespace moltact;

namespace {

struct State {
  std::recursive_mutex mutex;
  std::mutex ticking;  // held while the callback runs; taken before `mutex`
  std::vector<hd::ErrorInfo> errors;
  bool attached = true, initialised = false, in_frame = false, forces_on = false, running = false, manual = true,
       licensed = true;
  bool framed = false, ticks = false;  // there was a frame in this tick; a tick is in progress
  std::uint32_t error_at_end = hd::kNoError, error_at_begin = hd::kNoError;
  int begins_to_fail = 0;
  std::uint32_t calibration = hd::kCalibrated, style = hd::kInkwell, updates = 0;
  bool docked = false;
  int buttons = 0, inits = 0, init_ms = 0, updates_needed = 1;
  std::uint32_t init_error = hd::kNoError;
  double heat = 0.1, force[3] = {}, biggest_N = 0, at_stop_N = -1;
  Vec3 room_middle_mm{0.0};
  hd::Callback callback = nullptr;
  void* data = nullptr;
  hd::SchedulerHandle scheduled = 0;
  DeviceModel model{DeviceParameters{}, HandParameters{}, ScriptedHand().place()};
  ScriptedHand hand;
  std::atomic<bool> ends{false};
  std::thread clock;

  State() {
    if (std::getenv("STAND_IN_LOG")) manual = false;
    if (const char* z_mm = std::getenv("STAND_IN_ROOM_Z")) room_middle_mm.z = std::atof(z_mm);
    if (const char* named = std::getenv("STAND_IN_STYLE")) {
      style = std::uint32_t(std::atoi(named));
      calibration = hd::kNeedsManualInput;
    }
  }
  ~State() {
    ends = true;
    if (clock.joinable()) clock.join();
  }
};
State& state() {
  static State one;
  return one;
}
using Lock = std::lock_guard<std::recursive_mutex>;

void push(std::uint32_t code) { state().errors.push_back({code, 0, 0}); }

void note(const char* what) {
  static const int file = [] {
    const char* name = std::getenv("STAND_IN_FORCES");
    return name ? ::open(name, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600) : -1;
  }();
  if (file < 0) return;
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  char line[80];
  const int size =
      std::snprintf(line, sizeof line, "%lld %s\n", static_cast<long long>(t.tv_sec) * 1'000'000'000 + t.tv_nsec, what);
  (void)!::write(file, line, std::size_t(size));
}
void noteForce(double force_N) {
  char text[40];
  std::snprintf(text, sizeof text, "%.4f", force_N);
  note(text);
}

double norm(const double* v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

enum class Type { None, Boolean, Integer, Double };
Type typeOf(std::uint32_t what) {
  switch (what) {
    case hd::kInkwellSwitch:
      return Type::Boolean;
    case hd::kButtons:
    case hd::kInputDof:
    case hd::kOutputDof:
    case hd::kCalibrationStyle:
      return Type::Integer;
    case hd::kPosition:
    case hd::kTransform:
    case hd::kMotorTemperature:
    case hd::kMaxForce:
    case hd::kMaxContinuousForce:
    case hd::kMaxStiffness:
    case hd::kMaxDamping:
    case hd::kVelocityLimit:
    case hd::kForceImpulseLimit:
    case hd::kUsableWorkspace:
      return Type::Double;
    default:
      return Type::None;
  }
}
// Whether `what` is there and of the type that it is asked by.
bool isOf(Type type, std::uint32_t what) {
  const Type is = typeOf(what);
  if (is != type) push(is == Type::None ? hd::kInvalidEnum : hd::kInvalidInputType);
  return is == type;
}

bool inFrame() {
  if (!state().in_frame) push(hd::kInvalidOperation);
  return state().in_frame;
}

// One tick of the scheduler and of the world.
void step() {
  State& s = state();
  const std::lock_guard ticking(s.ticking);
  hd::Callback callback = nullptr;
  void* data = nullptr;
  {
    const Lock lock(s.mutex);
    if (s.running) callback = s.callback, data = s.data;
    if (callback && !s.attached) push(hd::kCommError);
    s.framed = false;
    s.ticks = true;
  }
  const hd::CallbackCode code = callback ? callback(data) : hd::kContinue;
  const Lock lock(s.mutex);
  s.ticks = false;
  if (s.in_frame) push(hd::kFrameError), s.in_frame = false;
  if (code == hd::kDone) s.callback = nullptr;
  const bool driven = s.forces_on && s.calibration == hd::kCalibrated && s.attached;
  const Vec3 force = driven ? Vec3(s.force[0], s.force[1], s.force[2]) : Vec3(0.0);
  s.model.tick({force}, s.hand.lead(0.001, s.model.held()));
}

}  // namespace

extern "C" {

hd::Handle hdInitDevice(const char*) {
  int wait_ms = 0;
  {
    const Lock lock(state().mutex);
    ++state().inits;
    wait_ms = state().init_ms;
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
  const Lock lock(state().mutex);
  if (!state().licensed) return push(hd::kInvalidLicense), hd::kInvalidHandle;
  if (!state().attached) return push(hd::kCommError), hd::kInvalidHandle;
  if (state().initialised) return push(hd::kAlreadyInitiated), hd::kInvalidHandle;
  state().initialised = true;
  if (state().init_error != hd::kNoError) push(state().init_error);
  return 0;
}
void hdDisableDevice(hd::Handle) {
  const Lock lock(state().mutex);
  if (!state().initialised || state().running) push(hd::kInvalidOperation);
  state().initialised = state().forces_on = false;
  if (const char* log = std::getenv("STAND_IN_LOG"))
    std::ofstream(log, std::ios::app) << "closed, " << state().biggest_N << " N at most, " << state().at_stop_N
                                      << " N at the stop, " << state().errors.size() << " errors\n";
}
void hdMakeCurrentDevice(hd::Handle device) {
  const Lock lock(state().mutex);
  if (device != 0 || !state().initialised) push(hd::kBadHandle);
}
void hdBeginFrame(hd::Handle) {
  const Lock lock(state().mutex);
  static const char* const fails = std::getenv("STAND_IN_FRAMES_FAIL");
  if (fails && ::access(fails, F_OK) == 0) return push(hd::kIllegalBegin);
  if (state().begins_to_fail > 0) {
    --state().begins_to_fail;
    return push(state().error_at_begin);
  }
  if (state().in_frame) push(hd::kIllegalBegin);
  if (state().ticks && std::exchange(state().framed, true)) return push(hd::kFrameError);
  state().in_frame = true;
}
void hdEndFrame(hd::Handle) {
  const Lock lock(state().mutex);
  if (!state().in_frame) push(hd::kIllegalEnd);
  state().in_frame = false;
  if (const std::uint32_t error = std::exchange(state().error_at_end, hd::kNoError); error != hd::kNoError) push(error);
}
hd::ErrorInfo hdGetError() {
  const Lock lock(state().mutex);
  if (state().errors.empty()) return {};
  const hd::ErrorInfo newest = state().errors.back();
  state().errors.pop_back();
  return newest;
}
void hdEnable(std::uint32_t what) {
  const Lock lock(state().mutex);
  if (what < 0x4000 || what > 0x4004) return push(hd::kInvalidEnum);
  if (what != hd::kForceOutput) return;
  state().forces_on = true;
  note("on");
}
void hdDisable(std::uint32_t what) {
  const Lock lock(state().mutex);
  if (what < 0x4000 || what > 0x4004) return push(hd::kInvalidEnum);
  if (what != hd::kForceOutput) return;
  state().forces_on = false;
  note("off");
}
void hdGetBooleanv(std::uint32_t what, hd::Boolean* out) {
  const Lock lock(state().mutex);
  // The switch opens when the stylus presses it.
  if (isOf(Type::Boolean, what) && inFrame()) *out = !state().docked;
}
void hdGetIntegerv(std::uint32_t what, int* out) {
  const Lock lock(state().mutex);
  if (!isOf(Type::Integer, what)) return;
  switch (what) {
    case hd::kButtons:
      if (inFrame()) *out = state().buttons;
      break;
    case hd::kInputDof:
      *out = 6;
      break;
    case hd::kOutputDof:
      *out = 3;
      break;
    default:
      *out = int(state().style);
  }
}
void hdGetDoublev(std::uint32_t what, double* out) {
  const Lock lock(state().mutex);
  if (!isOf(Type::Double, what)) return;
  switch (what) {
    case hd::kPosition: {
      if (!inFrame()) break;
      const Vec3 mm = state().model.sensed().mm;
      out[0] = mm.x, out[1] = mm.y, out[2] = mm.z;
      break;
    }
    case hd::kTransform: {
      if (!inFrame()) break;
      // Turned by a quarter round its y-axis.
      const Vec3 mm = state().model.sensed().mm;
      const double columns[16] = {0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, mm.x, mm.y, mm.z, 1};
      std::copy(columns, columns + 16, out);
      break;
    }
    case hd::kMotorTemperature:
      std::fill(out, out + 6, 0.0), out[1] = state().heat;
      break;
    case hd::kMaxForce:
      *out = 3.3;
      break;
    case hd::kMaxContinuousForce:
      *out = 0.88;
      break;
    case hd::kMaxStiffness:
      *out = 0.5;
      break;
    case hd::kMaxDamping:
      *out = 0.003;
      break;
    case hd::kVelocityLimit:
      *out = 1200;
      break;
    case hd::kForceImpulseLimit:
      *out = 4;
      break;
    default: {
      const Vec3& m = state().room_middle_mm;
      const double box[6] = {m.x - 80, m.y - 60, m.z - 35, m.x + 80, m.y + 60, m.z + 35};
      std::copy(box, box + 6, out);
    }
  }
}
void hdSetDoublev(std::uint32_t what, const double* in) {
  const Lock lock(state().mutex);
  if (what != hd::kCurrentForce) return push(hd::kInvalidEnum);
  if (!inFrame()) return;
  const double size = norm(in);
  if (!std::isfinite(size)) return push(hd::kForceError);
  if (size > 3.3 + 1e-9) push(hd::kExceededMaxForce);
  std::copy(in, in + 3, state().force);
  state().biggest_N = std::max(state().biggest_N, size);
  noteForce(size);
}
const char* hdGetString(std::uint32_t what) {
  switch (what) {
    case hd::kModel:
      return "Stand-in Omni";
    case hd::kSerial:
      return "42";
    default:
      return "";
  }
}
std::uint32_t hdCheckCalibration() {
  const Lock lock(state().mutex);
  return state().calibration;
}
void hdUpdateCalibration(std::uint32_t style) {
  const Lock lock(state().mutex);
  ++state().updates;
  if (style != state().style) return push(hd::kInvalidValue);
  if (state().in_frame) return push(hd::kInvalidOperation);
  if (--state().updates_needed <= 0) state().calibration = hd::kCalibrated;
}
void hdStartScheduler() {
  State& s = state();
  const Lock lock(s.mutex);
  if (!s.initialised) return push(hd::kTimerError);
  s.running = true;
  if (s.manual || s.clock.joinable()) return;
  s.ends = false;
  s.clock = std::thread([&s] {
    auto due = std::chrono::steady_clock::now();
    while (!s.ends) {
      due += std::chrono::milliseconds(1);
      std::this_thread::sleep_until(due);
      step();
    }
  });
}
void hdStopScheduler() {
  State& s = state();
  {
    const std::lock_guard ticking(s.ticking);
    const Lock lock(s.mutex);
    s.at_stop_N = norm(s.force);
    s.running = false;
  }
  s.ends = true;
  if (s.clock.joinable()) s.clock.join();
}
void hdSetSchedulerRate(unsigned long rate) {
  if (rate != 1000) push(hd::kInvalidValue);
}
hd::SchedulerHandle hdScheduleAsynchronous(hd::Callback callback, void* data, std::uint16_t) {
  const Lock lock(state().mutex);
  state().callback = callback;
  state().data = data;
  return ++state().scheduled;
}
void hdUnschedule(hd::SchedulerHandle handle) {
  const std::lock_guard ticking(state().ticking);
  const Lock lock(state().mutex);
  if (handle != state().scheduled) push(hd::kInvalidValue);
  state().callback = nullptr;
}

// For the tests.
void standInReset(bool manual) {
  State& s = state();
  const Lock lock(s.mutex);
  s.errors.clear();
  s.attached = s.licensed = true;
  s.initialised = s.in_frame = s.forces_on = s.running = false;
  s.manual = manual;
  s.calibration = hd::kCalibrated;
  s.style = hd::kInkwell;
  s.updates = 0;
  s.updates_needed = 1;
  s.buttons = s.inits = s.init_ms = 0;
  s.init_error = hd::kNoError;
  s.docked = false;
  s.heat = 0.1;
  s.room_middle_mm = Vec3(0.0);
  s.framed = s.ticks = false;
  s.error_at_end = hd::kNoError;
  s.begins_to_fail = 0;
  s.biggest_N = 0;
  s.at_stop_N = -1;
  std::fill(s.force, s.force + 3, 0.0);
  s.callback = nullptr;
  s.hand = ScriptedHand();
  s.model = DeviceModel(DeviceParameters{}, HandParameters{}, s.hand.place());
}
void standInStep(int ticks) {
  for (int k = 0; k < ticks; ++k) step();
}
void standInAttach(bool attached) {
  const Lock lock(state().mutex);
  state().attached = attached;
}
void standInError(std::uint32_t code) {
  const Lock lock(state().mutex);
  push(code);
}
void standInRoom(double x_mm, double y_mm, double z_mm) {
  const Lock lock(state().mutex);
  state().room_middle_mm = {x_mm, y_mm, z_mm};
}
void standInCalibration(std::uint32_t calibration, std::uint32_t style) {
  const Lock lock(state().mutex);
  state().calibration = calibration;
  state().style = style;
}
void standInHeat(double heat) {
  const Lock lock(state().mutex);
  state().heat = heat;
}
void standInButtons(int buttons) {
  const Lock lock(state().mutex);
  state().buttons = buttons;
}
void standInDock(bool docked) {
  const Lock lock(state().mutex);
  state().docked = docked;
}
// How often an update of the calibration is asked for until it is done.
void standInUpdatesNeeded(int times) {
  const Lock lock(state().mutex);
  state().updates_needed = times;
}
// Initialization takes this long and leaves this error, although it succeeds.
void standInInit(int ms, std::uint32_t error) {
  const Lock lock(state().mutex);
  state().init_ms = ms;
  state().init_error = error;
}
int standInInits() {
  const Lock lock(state().mutex);
  return state().inits;
}
void standInStopClock(bool stopped) {
  const Lock lock(state().mutex);
  state().running = !stopped;
}
double standInForce() {
  const Lock lock(state().mutex);
  return norm(state().force);
}
// What the motors are driven with: the force that was written last, while the output is on.
double standInDriven() {
  const Lock lock(state().mutex);
  return state().forces_on ? norm(state().force) : 0.0;
}
bool standInForcesOn() {
  const Lock lock(state().mutex);
  return state().forces_on;
}
// The end of the next frame leaves this error.
void standInErrorAtEnd(std::uint32_t code) {
  const Lock lock(state().mutex);
  state().error_at_end = code;
}
// Each of the next frames leaves this error when it is begun, and is not open.
void standInFailBegins(int frames, std::uint32_t code) {
  const Lock lock(state().mutex);
  state().begins_to_fail = frames;
  state().error_at_begin = code;
}
double standInForceAtStop() {
  const Lock lock(state().mutex);
  return state().at_stop_N;
}
std::uint32_t standInUpdates() {
  const Lock lock(state().mutex);
  return state().updates;
}
int standInErrorsLeft() {
  const Lock lock(state().mutex);
  return int(state().errors.size());
}
bool standInInitialised() {
  const Lock lock(state().mutex);
  return state().initialised;
}

}  // extern "C"
