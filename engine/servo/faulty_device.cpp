#include "engine/servo/faulty_device.h"

#include <cmath>
#include <utility>

#include "engine/platform/realtime.h"

namespace moltact {
namespace {

constexpr std::int64_t kPeriod_ns = 1'000'000;
constexpr double kLeap_mm = 20.0;
constexpr int kLatest_ms = 15;

}  // namespace

FaultyDevice::FaultyDevice(std::unique_ptr<Device> device)
    : device_(std::move(device)), judge_(device_->info().max_force_N) {}

void FaultyDevice::inject(LoopFault fault, int ticks) {
  left_.store(ticks);
  fault_.store(fault, std::memory_order_release);
}

FaultyDevice::Given FaultyDevice::given() {
  return {broken_.exchange(nullptr), ticks_.exchange(0), fresh_.exchange(0), peak_N_.exchange(0.0), last_N_.load()};
}

bool FaultyDevice::startClock(ClockListener& target) {
  target_.store(&target);
  ends_.store(false);
  lent_ = device_->startClock(*this);
  if (!lent_) clock_ = std::thread([this] { run(); });
  return true;
}

void FaultyDevice::stopClock() {
  ends_.store(true);
  if (clock_.joinable()) clock_.join();
  if (std::exchange(lent_, false)) device_->stopClock();
  target_.store(nullptr);
}

void FaultyDevice::run() noexcept {
  becomeRealtime();
  for (std::int64_t due_ns = monotonic_ns() + kPeriod_ns; !ends_.load(); due_ns += kPeriod_ns) {
    if (const std::int64_t now_ns = monotonic_ns(); now_ns - due_ns > 10 * kPeriod_ns) due_ns = now_ns;
    sleepUntil(due_ns);
    onDeviceTick();
  }
}

// A tick of the device's own clock, or of the clock that replaces it.
void FaultyDevice::onDeviceTick() noexcept {
  const LoopFault fault = fault_.load(std::memory_order_acquire);
  if (fault == LoopFault::Late) {
    late_ = (late_ + 7) % kLatest_ms;
    sleepUntil(monotonic_ns() + late_ * kPeriod_ns);
  }
  if (fault != LoopFault::Lost) tick();
  if (fault == LoopFault::Doubled) tick();
  if (fault == LoopFault::Late || fault == LoopFault::Lost || fault == LoopFault::Doubled) passed();
}

void FaultyDevice::tick() noexcept {
  if (ClockListener* const target = target_.load(); target && !ends_.load()) target->onDeviceTick();
}

void FaultyDevice::passed() noexcept {
  if (left_.fetch_sub(1) <= 1) fault_.store(LoopFault::None);
}

DevicePose FaultyDevice::read(double dt_s) noexcept {
  DevicePose pose = device_->read(dt_s);
  const DeviceInfo& info = device_->info();
  if (std::exchange(judged_, &info) != &info) judge_.otherDevice(info.max_force_N);
  if (pose.connected && pose.fresh) fresh_.fetch_add(1, std::memory_order_relaxed);
  // Faults of the device itself are treated like injected ones.
  const bool stood = std::exchange(stood_, false),
             connection_changed = std::exchange(was_connected_, pose.connected) != pose.connected;
  const bool bad = misread(pose) || pose.fault || !pose.connected || !finite(pose.position.mm);
  if (stood || connection_changed || std::exchange(was_bad_, bad) || bad) judge_.expectSoft();
  judge_.lasting(bad);
  // Other faults, such as a loop that is late by itself, are unknown here.
  now_ = {.fresh = pose.fresh, .at_once = true};
  return pose;
}

// Returns true if the position was falsified.
bool FaultyDevice::misread(DevicePose& pose) noexcept {
  const LoopFault fault = fault_.load(std::memory_order_acquire);
  const bool odd = left_.load() % 2;
  switch (fault) {
    case LoopFault::Stall:  // the next tick detects that it is late
      sleepUntil(monotonic_ns() + left_.exchange(0) * kPeriod_ns);
      stood_ = true;
      break;
    case LoopFault::PositionJump:
      pose.position.mm.x += odd ? kLeap_mm : -kLeap_mm;
      break;
    case LoopFault::NotANumber:
      pose.position.mm.y = odd ? std::nan("") : HUGE_VAL;
      break;
    case LoopFault::Frozen:
      pose.fresh = false;
      break;
    default:
      return false;
  }
  passed();
  return fault == LoopFault::PositionJump || fault == LoopFault::NotANumber;
}

void FaultyDevice::write(ForceN force) noexcept {
  note(force.N, false);
  device_->write(force);
}

void FaultyDevice::writeWrench(const Wrench& wrench) noexcept {
  note(wrench.force.N, false);
  device_->writeWrench(wrench);
}

void FaultyDevice::stop() noexcept {
  note(Vec3(0.0), true);
  device_->stop();
}

void FaultyDevice::note(const Vec3& force_N, bool stopped) noexcept {
  now_.stopped = stopped;
  if (const char* broken = judge_.judge(force_N, now_); broken && !broken_.load()) broken_.store(broken);
  const double size = glm::length(force_N);
  last_N_.store(size, std::memory_order_relaxed);
  if (size > peak_N_.load(std::memory_order_relaxed)) peak_N_.store(size, std::memory_order_relaxed);
  ticks_.fetch_add(1, std::memory_order_relaxed);
}

}  // namespace moltact
