#include "engine/device/packet/packet_device.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "engine/language/catalogue.h"
#include "engine/platform/force_inhibit.h"

namespace moltact {
namespace {

constexpr int kWait_ms = 1;      // longest wait for a report before the force is sent
constexpr int kMaxReports = 64;  // reports read at once; only the newest position counts
constexpr auto kLookAgain = std::chrono::milliseconds(500);
constexpr auto kNap = std::chrono::milliseconds(20);
constexpr double kSameFrame_s = 0.002;  // without a thread: ticks within this time belong to one frame

}  // namespace

const char* const PacketDevice::kUnplugged = N_("{0} is unplugged: plug it in again.");

Expected<std::unique_ptr<Device>> PacketDevice::open(Opener opener, std::unique_ptr<PacketProtocol> protocol,
                                                     DeviceInfo known, bool own_thread, const char* lost) {
  std::unique_ptr<PacketDevice> device(new PacketDevice(std::move(known), own_thread));
  device->lost_ = lost;
  device->opener_ = std::move(opener);
  device->protocol_ = std::move(protocol);
  if (auto problem = device->openPort()) return *problem;
  const DeviceGuidance guidance = device->protocol_->guidance();
  State first;
  first.pose.fresh = false;
  first.pose.fault = guidance.text != nullptr;
  device->state_.write(first);
  device->guidance_.write(guidance);
  device->own_state_.pose.fresh = false;
  device->last_turn_ = device->look_again_ = device->newest_command_.at = Clock::now();
  if (device->own_thread_) device->thread_ = std::thread([raw = device.get()] { raw->run(); });
  return std::unique_ptr<Device>(std::move(device));
}

PacketDevice::~PacketDevice() {
  ends_.store(true);
  if (thread_.joinable()) thread_.join();
  if (!own_thread_) sendFinalReport();
}

// A different device of the kind may have been plugged in, so its figures are requested each time.
std::optional<Problem> PacketDevice::openPort() {
  DeviceInfo info = known_;
  auto port = opener_([&](PacketPort& candidate) {
    info = known_;
    return protocol_->begin(candidate, info);
  });
  if (!port) return port.problem();
  port_ = std::move(*port);
  info_.set(std::move(info));
  return std::nullopt;
}

bool PacketDevice::reopen(State& state) {
  if (openPort()) return false;
  state.pose.connected = true;
  state.pose.buttons = 0;
  ++state.pose.discontinuities;  // its motion meanwhile is unknown
  state.received = Clock::now();
  guidance_.write(protocol_->guidance());
  gone_.store(false);
  return true;
}

// Reads all reports that have arrived; the newest position counts. Returns -1 if the device is disconnected.
int PacketDevice::receive(State& state, int wait_ms) {
  std::array<std::uint8_t, kMaxReportBytes> in{};
  int size = port_->read(in, wait_ms);
  for (int k = 0; k < kMaxReports && size > 0; ++k) {
    if (protocol_->parseReport({in.data(), std::min<std::size_t>(std::size_t(size), in.size())}, state.pose)) {
      ++state.count;
      state.received = Clock::now();
    }
    if (k + 1 < kMaxReports) size = port_->read(in, 0);  // every report that is read is also parsed
  }
  if (calibrate_.exchange(false, std::memory_order_acq_rel) && protocol_->calibrate()) ++state.pose.discontinuities;
  const DeviceGuidance guidance = protocol_->guidance();
  state.pose.fault = guidance.text != nullptr;
  guidance_.write(guidance);
  return size;
}

// Sends the newest force, or zero. Returns false if the device did not accept it.
bool PacketDevice::sendNewest(State& state) {
  std::array<std::uint8_t, kMaxReportBytes> out{};
  if (!last_report_kept_) {
    if (const std::size_t length = protocol_->encodeFinalReport(out)) {
      port_->lastReport({out.data(), length});
      last_report_kept_ = true;
    }
  }
  const Command newest = command_.read();
  const bool is_new = newest.count != newest_command_.count;
  if (is_new) newest_command_ = newest;
  const bool timed_out = std::chrono::duration<double>(Clock::now() - newest_command_.at).count() > kCommandTimeout_s;
  const bool none = timed_out || !newest_command_.motors_on || forceInhibited();
  const std::size_t length = none ? protocol_->encodeStop(out) : protocol_->encode(newest_command_.wrench, out);
  if (length == 0) return true;
  if (!port_->write({out.data(), length})) return false;
  if (is_new && own_thread_) state.wait_s = std::chrono::duration<double>(Clock::now() - newest_command_.at).count();
  return true;
}

// A device that can no longer be read or written may still accept a report: the last attempt ends its force.
void PacketDevice::lose(State& state) noexcept {
  sendFinalReport();
  port_.reset();
  last_report_kept_ = false;
  gone_.store(true);
  state.pose.connected = false;
  state_.write(state);
  view_motion_.write({});
  look_again_ = Clock::now() + kLookAgain;
}

void PacketDevice::sendFinalReport() noexcept {
  if (!port_) return;
  std::array<std::uint8_t, kMaxReportBytes> out{};
  try {
    if (const std::size_t length = protocol_->encodeFinalReport(out)) port_->write({out.data(), length});
  } catch (...) {  // the port fails completely
  }
}

void PacketDevice::takeTurn(int wait_ms) noexcept {
  State& state = own_state_;
  try {
    if (!port_) {
      if (Clock::now() < look_again_) return;
      if (!reopen(state)) {
        look_again_ = Clock::now() + kLookAgain;
        return;
      }
      last_turn_ = Clock::now();
    }
    if (receive(state, wait_ms) < 0) return lose(state);
    const Clock::time_point now = Clock::now();
    const double since_s = std::chrono::duration<double>(now - last_turn_).count();
    if (!own_thread_ && since_s > kSameFrame_s) state.wait_s = since_s;
    last_turn_ = now;
    protocol_->rotateHand(rotates_hand_.load(std::memory_order_relaxed));
    protocol_->advance(std::min(0.05, since_s), state.pose);
    state_.write(state);
    view_motion_.write(protocol_->viewMotion());
  } catch (...) {  // out of memory, or the port throws: the device is reopened
    return lose(state);
  }
  if (own_thread_) writeNewestForce();
}

void PacketDevice::writeNewestForce() noexcept {
  if (!port_) return;
  try {
    if (sendNewest(own_state_)) return;
  } catch (...) {  // as above
  }
  lose(own_state_);
}

void PacketDevice::run() {
  while (!ends_.load()) {
    if (!port_) std::this_thread::sleep_for(kNap);
    takeTurn(kWait_ms);
  }
  sendFinalReport();
}

DevicePose PacketDevice::read(double) noexcept {
  if (!own_thread_) takeTurn(0);
  const State& state = state_.read();
  DevicePose pose = state.pose;
  // A device without force may send nothing while it is not moved.
  const bool gives_force = info().gives_force;
  pose.fresh = !gives_force || state.count != last_read_;
  if (gives_force && state.count > 0)
    pose.age_s = float(std::chrono::duration<double>(Clock::now() - state.received).count() + state.wait_s);
  last_read_ = state.count;
  return pose;
}

void PacketDevice::command(const Wrench& wrench, bool motors_on) noexcept {
  next_command_.wrench = wrench;
  next_command_.motors_on = motors_on;
  next_command_.at = Clock::now();
  ++next_command_.count;
  command_.write(next_command_);
  if (!own_thread_) writeNewestForce();
}

DeviceStatus PacketDevice::status() {
  DeviceStatus status;
  status.connected = !gone_.load();
  if (!status.connected) {
    status.ready = false;
    status.text = trf(lost_, tr(info().name.c_str()));
  } else if (const DeviceGuidance guidance = guidance_.read(); guidance.text) {
    status.ready = false;
    status.text = tr(guidance.text);
    status.asks_calibrate = guidance.asks_calibrate;
  }
  return status;
}

}  // namespace moltact
