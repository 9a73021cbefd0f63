#include "engine/device/hid/hid_device.h"

#include <algorithm>
#include <array>
#include <chrono>

namespace moltact {
namespace {

using Clock = std::chrono::steady_clock;
constexpr int kWait_ms = 2;            // for a report, before the force is given all the same
constexpr int kMostReports = 64;       // read at once: the newest is what counts
constexpr double kLonelyForce_s = 0.1; // without a word from the haptic thread: no force
constexpr auto kLookAgain = std::chrono::milliseconds(500);
constexpr auto kNap = std::chrono::milliseconds(20);

}  // namespace

Expected<std::unique_ptr<Device>> HidDevice::open(Opener opener, std::unique_ptr<HidProtocol> protocol, DeviceInfo info) {
  std::unique_ptr<HidDevice> device(new HidDevice);
  device->opener_ = std::move(opener);
  device->protocol_ = std::move(protocol);
  device->info_ = std::move(info);
  auto port = device->opener_();
  if (!port) return port.problem();
  device->port_ = std::move(*port);
  if (auto problem = device->protocol_->begin(*device->port_, device->info_)) return *problem;
  device->thread_ = std::thread([raw = device.get()] { raw->run(); });
  return std::unique_ptr<Device>(std::move(device));
}

HidDevice::~HidDevice() {
  ends_.store(true);
  if (thread_.joinable()) thread_.join();
}

bool HidDevice::reopen() {
  auto port = opener_();
  if (!port) return false;
  // Another device of the kind may have come: its figures are not those that the loop knows, but it must be of the kind.
  DeviceInfo info = info_;
  if (protocol_->begin(**port, info)) return false;
  port_ = std::move(*port);
  return true;
}

void HidDevice::run() {
  Told told;
  told.pose.fresh = false;
  std::array<std::uint8_t, 64> in{}, out{};
  Clock::time_point last = Clock::now(), asked_at = last, look_again = last;
  std::uint32_t asked_count = 0;
  const auto lose = [&] {
    port_.reset();
    gone_.store(true);
    told.pose.connected = false;
    told_.write(told);
    wish_.write({});
    look_again = Clock::now() + kLookAgain;
  };
  while (!ends_.load()) {
    if (!port_) {
      std::this_thread::sleep_for(kNap);
      if (Clock::now() < look_again) continue;
      if (!reopen()) {
        look_again = Clock::now() + kLookAgain;
        continue;
      }
      gone_.store(false);
      told.pose.connected = true;
      ++told.pose.placements;  // nobody knows where it was meanwhile
      last = Clock::now();
    }
    int size = port_->read(in, kWait_ms);
    for (int k = 0; k < kMostReports && size > 0; ++k) {
      if (protocol_->take({in.data(), std::min<std::size_t>(std::size_t(size), in.size())}, told.pose)) ++told.count;
      size = port_->read(in, 0);
    }
    if (size < 0) {
      lose();
      continue;
    }
    const Clock::time_point now = Clock::now();
    protocol_->pass(std::min(0.05, std::chrono::duration<double>(now - last).count()), told.pose);
    last = now;
    told_.write(told);
    wish_.write(protocol_->viewWish());

    const Asked& asked = asked_.read();
    if (asked.count != asked_count) {
      asked_count = asked.count;
      asked_at = now;
    }
    const bool lonely = std::chrono::duration<double>(now - asked_at).count() > kLonelyForce_s;
    if (const std::size_t length = lonely || !asked.motors_on ? protocol_->stop(out) : protocol_->give(asked.force, out))
      if (!port_->write({out.data(), length})) lose();
  }
  if (!port_) return;
  if (const std::size_t length = protocol_->stop(out)) port_->write({out.data(), length});
}

DevicePose HidDevice::read(double) noexcept {
  const Told& told = told_.read();
  DevicePose pose = told.pose;
  // A device without force may be silent while nobody moves it.
  pose.fresh = !info_.gives_force || told.count != last_told_;
  last_told_ = told.count;
  return pose;
}

void HidDevice::ask(ForceN force, bool motors_on) noexcept {
  asking_.force = force;
  asking_.motors_on = motors_on;
  ++asking_.count;
  asked_.write(asking_);
}

DeviceStatus HidDevice::status() {
  DeviceStatus status;
  status.connected = status.ready = !gone_.load();
  if (!status.connected) status.text = info_.name + " is unplugged: plug it in again.";
  return status;
}

std::vector<FoundDevice> findHid(bool (*is)(const HidEntry&), bool gives_force, std::string_view title) {
  std::vector<FoundDevice> out;
  for (const HidEntry& entry : listHid()) {
    if (!is(entry)) continue;
    FoundDevice one{.title = entry.title.empty() ? std::string(title) : entry.title, .place = entry.path, .gives_force = gives_force,
                    .by_itself = gives_force};
    const auto port = openHid(entry);
    one.usable = bool(port);
    if (!port) one.why = port.problem().text();
    out.push_back(std::move(one));
  }
  if (out.empty()) {
    FoundDevice none{.title = std::string(title), .gives_force = gives_force};
    none.why = "none is plugged in";
    out.push_back(std::move(none));
  }
  return out;
}

HidDevice::Opener hidOpener(bool (*is)(const HidEntry&), const FoundDevice& found) {
  return [is, path = found.place]() -> Expected<std::unique_ptr<HidPort>> {
    const std::vector<HidEntry> all = listHid();
    const HidEntry* best = nullptr;
    for (const HidEntry& entry : all)
      if (is(entry) && (!best || entry.path == path)) best = &entry;
    if (!best) return Problem{"", 0, 0, "the device is not plugged in", "plug it in"};
    return openHid(*best);
  };
}

}  // namespace moltact
