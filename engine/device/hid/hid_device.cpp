#include "engine/device/hid/hid_device.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "engine/language/catalogue.h"
#include "engine/platform/force_hold.h"

namespace moltact {
namespace {

constexpr int kWait_ms = 1;       // for a report, before the force is given all the same
constexpr int kMostReports = 64;  // read at once: the newest is what counts
constexpr double kLonelyForce_s =
    0.02;  // without a word from the haptic thread: no force, as for a tick that is so late
constexpr auto kLookAgain = std::chrono::milliseconds(500);
constexpr auto kNap = std::chrono::milliseconds(20);

}  // namespace

Expected<std::unique_ptr<Device>> HidDevice::open(Opener opener, std::unique_ptr<HidProtocol> protocol,
                                                  DeviceInfo known) {
  std::unique_ptr<HidDevice> device(new HidDevice(std::move(known)));
  device->opener_ = std::move(opener);
  device->protocol_ = std::move(protocol);
  if (auto problem = device->openPort()) return *problem;
  const HidGuidance guidance = device->protocol_->guidance();
  State first;
  first.pose.fresh = false;
  first.pose.fault = guidance.text != nullptr;
  device->state_.write(first);
  device->guidance_.write(guidance);
  device->thread_ = std::thread([raw = device.get()] { raw->run(); });
  return std::unique_ptr<Device>(std::move(device));
}

HidDevice::~HidDevice() {
  ends_.store(true);
  if (thread_.joinable()) thread_.join();
}

// Another device of the kind may have come than the one that was: its own figures are asked for each time.
std::optional<Problem> HidDevice::openPort() {
  DeviceInfo info = known_;
  auto port = opener_([&](HidPort& candidate) {
    info = known_;
    return protocol_->begin(candidate, info);
  });
  if (!port) return port.problem();
  port_ = std::move(*port);
  info_.set(std::move(info));
  return std::nullopt;
}

bool HidDevice::revive(State& state) {
  if (openPort()) return false;
  state.pose.connected = true;
  state.pose.buttons = 0;
  ++state.pose.discontinuities;  // nobody knows where it was meanwhile
  state.taken = Clock::now();
  guidance_.write(protocol_->guidance());
  gone_.store(false);
  return true;
}

// Everything that has come, the newest counts; -1: the device is gone.
int HidDevice::take(State& state) {
  std::array<std::uint8_t, 64> in{};
  int size = port_->read(in, kWait_ms);
  for (int k = 0; k < kMostReports && size > 0; ++k) {
    if (protocol_->take({in.data(), std::min<std::size_t>(std::size_t(size), in.size())}, state.pose)) {
      ++state.count;
      state.taken = Clock::now();
    }
    size = port_->read(in, 0);
  }
  if (calibrate_.exchange(false, std::memory_order_acq_rel) && protocol_->calibrate()) ++state.pose.discontinuities;
  const HidGuidance guidance = protocol_->guidance();
  state.pose.fault = guidance.text != nullptr;
  guidance_.write(guidance);
  return size;
}

// The newest force, or none; false: the device took nothing.
bool HidDevice::giveNewest(State& state) {
  std::array<std::uint8_t, 64> out{};
  if (!last_report_told_) {
    if (const std::size_t length = protocol_->end(out)) {
      port_->lastReport({out.data(), length});
      last_report_told_ = true;
    }
  }
  const Command newest = command_.read();
  const bool anew = newest.count != taken_command_.count;
  if (anew) taken_command_ = newest;
  const bool lonely = std::chrono::duration<double>(Clock::now() - taken_command_.at).count() > kLonelyForce_s;
  const bool none = lonely || !taken_command_.motors_on || forceHeld();
  const std::size_t length = none ? protocol_->stop(out) : protocol_->give(taken_command_.force, out);
  if (length == 0) return true;
  if (!port_->write({out.data(), length})) return false;
  if (anew) state.wait_s = std::chrono::duration<double>(Clock::now() - taken_command_.at).count();
  return true;
}

// One that reads or writes no more may still listen: the last that is tried is to end its force.
void HidDevice::lose(State& state) noexcept {
  endForce();
  port_.reset();
  last_report_told_ = false;
  gone_.store(true);
  state.pose.connected = false;
  state_.write(state);
  wish_.write({});
  look_again_ = Clock::now() + kLookAgain;
}

void HidDevice::endForce() noexcept {
  if (!port_) return;
  std::array<std::uint8_t, 64> out{};
  try {
    if (const std::size_t length = protocol_->end(out)) port_->write({out.data(), length});
  } catch (...) {  // the port fails altogether
  }
}

void HidDevice::run() {
  State state;
  state.pose.fresh = false;
  Clock::time_point last = Clock::now();
  look_again_ = taken_command_.at = last;
  while (!ends_.load()) {
    try {
      if (!port_) {
        std::this_thread::sleep_for(kNap);
        if (Clock::now() < look_again_) continue;
        if (!revive(state)) {
          look_again_ = Clock::now() + kLookAgain;
          continue;
        }
        last = Clock::now();
      }
      if (take(state) < 0) {
        lose(state);
        continue;
      }
      const Clock::time_point now = Clock::now();
      protocol_->turnHand(turns_hand_.load(std::memory_order_relaxed));
      protocol_->pass(std::min(0.05, std::chrono::duration<double>(now - last).count()), state.pose);
      last = now;
      state_.write(state);
      wish_.write(protocol_->viewWish());
      if (!giveNewest(state)) lose(state);
    } catch (...) {  // memory is out, or a port throws: the device is opened anew
      lose(state);
    }
  }
  endForce();
}

DevicePose HidDevice::read(double) noexcept {
  const State& state = state_.read();
  DevicePose pose = state.pose;
  // A device without force may be silent while nobody moves it.
  const bool gives_force = info().gives_force;
  pose.fresh = !gives_force || state.count != last_told_;
  if (gives_force && state.count > 0)
    pose.age_s = float(std::chrono::duration<double>(Clock::now() - state.taken).count() + state.wait_s);
  last_told_ = state.count;
  return pose;
}

void HidDevice::ask(ForceN force, bool motors_on) noexcept {
  next_command_.force = force;
  next_command_.motors_on = motors_on;
  next_command_.at = Clock::now();
  ++next_command_.count;
  command_.write(next_command_);
}

DeviceStatus HidDevice::status() {
  DeviceStatus status;
  status.connected = !gone_.load();
  if (!status.connected) {
    status.ready = false;
    status.text = trf("{0} is unplugged: plug it in again.", tr(info().name.c_str()));
  } else if (const HidGuidance guidance = guidance_.read(); guidance.text) {
    status.ready = false;
    status.text = tr(guidance.text);
    status.asks_calibrate = guidance.asks_calibrate;
  }
  return status;
}

std::vector<FoundDevice> findHid(const HidKind& kind) {
  std::vector<FoundDevice> out, closed;
  std::string strangers;
  for (const HidEntry& entry : listHid()) {
    if (!kind.is(entry)) continue;
    FoundDevice one{.title = entry.title.empty() ? std::string(kind.title) : entry.title, .place = entry.path};
    DeviceInfo info = kind.known;
    const auto port = openHid(entry);
    const auto protocol = kind.protocol();
    const std::optional<Problem> problem = port ? protocol->begin(**port, info) : port.problem();
    one.gives_force = info.gives_force;
    if (!problem) {
      one.usable = true;
      one.by_itself = info.gives_force;
      out.push_back(std::move(one));
    } else if (protocol->ofKind()) {
      one.why = problem->text();
      closed.push_back(std::move(one));
    } else {
      strangers += "; " + one.title + ": " + problem->message;
    }
  }
  out.insert(out.end(), closed.begin(), closed.end());
  if (out.empty()) {
    FoundDevice none{.title = std::string(kind.title), .gives_force = kind.known.gives_force};
    none.why = tr("none is plugged in") + strangers;
    out.push_back(std::move(none));
  }
  return out;
}

Expected<std::unique_ptr<Device>> openHid(const HidKind& kind, const FoundDevice& found) {
  DeviceInfo known = kind.known;
  if (known.name.empty()) known.name = found.title;
  // The one that was found first; others of the kind only where that is not there, or no longer one.
  const auto opener = [is = kind.is,
                       path = found.place](const HidDevice::Accept& accept) -> Expected<std::unique_ptr<HidPort>> {
    std::vector<HidEntry> all = listHid();
    std::erase_if(all, [&](const HidEntry& entry) { return !is(entry); });
    std::stable_partition(all.begin(), all.end(), [&](const HidEntry& entry) { return entry.path == path; });
    Problem why{"", 0, 0, tr("the device is not plugged in"), tr("plug it in")};
    for (const HidEntry& entry : all) {
      auto port = openHid(entry);
      if (!port) {
        why = port.problem();
        continue;
      }
      const auto problem = accept(**port);
      if (!problem) return port;
      why = *problem;
    }
    return why;
  };
  return HidDevice::open(opener, kind.protocol(), std::move(known));
}

}  // namespace moltact
