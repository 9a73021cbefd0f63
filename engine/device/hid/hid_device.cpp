#include "engine/device/hid/hid_device.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "engine/platform/force_hold.h"

namespace moltact {
namespace {

constexpr int kWait_ms = 1;            // for a report, before the force is given all the same
constexpr int kMostReports = 64;       // read at once: the newest is what counts
constexpr double kLonelyForce_s = 0.02; // without a word from the haptic thread: no force, as for a tick that is so late
constexpr auto kLookAgain = std::chrono::milliseconds(500);
constexpr auto kNap = std::chrono::milliseconds(20);

}  // namespace

Expected<std::unique_ptr<Device>> HidDevice::open(Opener opener, std::unique_ptr<HidProtocol> protocol, DeviceInfo known) {
  std::unique_ptr<HidDevice> device(new HidDevice(std::move(known)));
  device->opener_ = std::move(opener);
  device->protocol_ = std::move(protocol);
  if (auto problem = device->openPort()) return *problem;
  const HidGuidance guidance = device->protocol_->guidance();
  Told first;
  first.pose.fresh = false;
  first.pose.trouble = guidance.text != nullptr;
  device->told_.write(first);
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

bool HidDevice::revive(Told& told) {
  if (openPort()) return false;
  told.pose.connected = true;
  told.pose.buttons = 0;
  ++told.pose.placements;  // nobody knows where it was meanwhile
  told.taken = Clock::now();
  guidance_.write(protocol_->guidance());
  gone_.store(false);
  return true;
}

// Everything that has come, the newest counts; -1: the device is gone.
int HidDevice::take(Told& told) {
  std::array<std::uint8_t, 64> in{};
  int size = port_->read(in, kWait_ms);
  for (int k = 0; k < kMostReports && size > 0; ++k) {
    if (protocol_->take({in.data(), std::min<std::size_t>(std::size_t(size), in.size())}, told.pose)) {
      ++told.count;
      told.taken = Clock::now();
    }
    size = port_->read(in, 0);
  }
  if (calibrate_.exchange(false, std::memory_order_acq_rel) && protocol_->calibrate()) ++told.pose.placements;
  const HidGuidance guidance = protocol_->guidance();
  told.pose.trouble = guidance.text != nullptr;
  guidance_.write(guidance);
  return size;
}

// The newest force, or none; false: the device took nothing.
bool HidDevice::giveNewest(Told& told) {
  std::array<std::uint8_t, 64> out{};
  if (!last_report_told_) {
    if (const std::size_t length = protocol_->end(out)) {
      port_->lastReport({out.data(), length});
      last_report_told_ = true;
    }
  }
  const Asked newest = asked_.read();
  const bool anew = newest.count != taken_.count;
  if (anew) taken_ = newest;
  const bool lonely = std::chrono::duration<double>(Clock::now() - taken_.at).count() > kLonelyForce_s;
  const bool none = lonely || !taken_.motors_on || forceHeld();
  const std::size_t length = none ? protocol_->stop(out) : protocol_->give(taken_.force, out);
  if (length == 0) return true;
  if (!port_->write({out.data(), length})) return false;
  if (anew) told.wait_s = std::chrono::duration<double>(Clock::now() - taken_.at).count();
  return true;
}

// One that reads or writes no more may still listen: the last that is tried is to end its force.
void HidDevice::lose(Told& told) noexcept {
  endForce();
  port_.reset();
  last_report_told_ = false;
  gone_.store(true);
  told.pose.connected = false;
  told_.write(told);
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
  Told told;
  told.pose.fresh = false;
  Clock::time_point last = Clock::now();
  look_again_ = taken_.at = last;
  while (!ends_.load()) {
    try {
      if (!port_) {
        std::this_thread::sleep_for(kNap);
        if (Clock::now() < look_again_) continue;
        if (!revive(told)) {
          look_again_ = Clock::now() + kLookAgain;
          continue;
        }
        last = Clock::now();
      }
      if (take(told) < 0) {
        lose(told);
        continue;
      }
      const Clock::time_point now = Clock::now();
      protocol_->pass(std::min(0.05, std::chrono::duration<double>(now - last).count()), told.pose);
      last = now;
      told_.write(told);
      wish_.write(protocol_->viewWish());
      if (!giveNewest(told)) lose(told);
    } catch (...) {  // memory is out, or a port throws: the device is opened anew
      lose(told);
    }
  }
  endForce();
}

DevicePose HidDevice::read(double) noexcept {
  const Told& told = told_.read();
  DevicePose pose = told.pose;
  // A device without force may be silent while nobody moves it.
  const bool gives_force = info().gives_force;
  pose.fresh = !gives_force || told.count != last_told_;
  if (gives_force && told.count > 0) pose.age_s = float(std::chrono::duration<double>(Clock::now() - told.taken).count() + told.wait_s);
  last_told_ = told.count;
  return pose;
}

void HidDevice::ask(ForceN force, bool motors_on) noexcept {
  asking_.force = force;
  asking_.motors_on = motors_on;
  asking_.at = Clock::now();
  ++asking_.count;
  asked_.write(asking_);
}

DeviceStatus HidDevice::status() {
  DeviceStatus status;
  status.connected = !gone_.load();
  if (!status.connected) {
    status.ready = false;
    status.text = info().name + " is unplugged: plug it in again.";
  } else if (const HidGuidance guidance = guidance_.read(); guidance.text) {
    status.ready = false;
    status.text = guidance.text;
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
    none.why = "none is plugged in" + strangers;
    out.push_back(std::move(none));
  }
  return out;
}

Expected<std::unique_ptr<Device>> openHid(const HidKind& kind, const FoundDevice& found) {
  DeviceInfo known = kind.known;
  if (known.name.empty()) known.name = found.title;
  // The one that was found first; others of the kind only where that is not there, or no longer one.
  const auto opener = [is = kind.is, path = found.place](const HidDevice::Accept& accept) -> Expected<std::unique_ptr<HidPort>> {
    std::vector<HidEntry> all = listHid();
    std::erase_if(all, [&](const HidEntry& entry) { return !is(entry); });
    std::stable_partition(all.begin(), all.end(), [&](const HidEntry& entry) { return entry.path == path; });
    Problem why{"", 0, 0, "the device is not plugged in", "plug it in"};
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
