// A port whose other end the test controls: what the device sends and receives. Any thread.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <utility>
#include <vector>

#include "engine/device/packet/packet_device.h"

namespace moltact::test {

using Report = std::vector<std::uint8_t>;

// The device's end of a port.
struct Wire {
  std::mutex mutex;
  std::deque<Report> to_host;
  std::vector<Report> from_host;
  std::vector<std::chrono::steady_clock::time_point> came;  // of each of them
  bool plugged = true;
  // Failures while the device still receives.
  bool no_read = false, no_write_once = false, throws_once = false;
  std::atomic<int> write_ms{0};  // how long writing a report blocks
  Report feature;

  void send(Report report) {
    const std::lock_guard lock(mutex);
    to_host.push_back(std::move(report));
  }
  std::size_t written() {
    const std::lock_guard lock(mutex);
    return from_host.size();
  }
  Report last() {
    const std::lock_guard lock(mutex);
    return from_host.empty() ? Report() : from_host.back();
  }
  void plug(bool in) {
    const std::lock_guard lock(mutex);
    plugged = in;
  }
};

class WirePort final : public PacketPort {
 public:
  explicit WirePort(std::shared_ptr<Wire> wire) : wire_(std::move(wire)) {}
  int read(std::span<std::uint8_t> report, int wait_ms) override {
    {
      const std::lock_guard lock(wire_->mutex);
      if (!wire_->plugged || wire_->no_read) return -1;
      if (std::exchange(wire_->throws_once, false)) throw std::bad_alloc();
      if (!wire_->to_host.empty()) {
        const Report next = wire_->to_host.front();
        wire_->to_host.pop_front();
        std::copy_n(next.begin(), std::min(next.size(), report.size()), report.begin());
        return int(std::min(next.size(), report.size()));
      }
    }
    if (wait_ms) std::this_thread::sleep_for(std::chrono::microseconds(200));
    return 0;
  }
  bool write(std::span<const std::uint8_t> report) override {
    std::this_thread::sleep_for(std::chrono::milliseconds(wire_->write_ms));
    const std::lock_guard lock(wire_->mutex);
    if (!wire_->plugged || std::exchange(wire_->no_write_once, false)) return false;
    wire_->from_host.emplace_back(report.begin(), report.end());
    wire_->came.push_back(std::chrono::steady_clock::now());
    return true;
  }
  int feature(std::span<std::uint8_t> report) override {
    const std::lock_guard lock(wire_->mutex);
    if (wire_->feature.empty()) return -1;
    std::copy(wire_->feature.begin(), wire_->feature.end(), report.begin());
    return int(wire_->feature.size());
  }

 private:
  std::shared_ptr<Wire> wire_;
};

inline PacketDevice::Opener over(std::shared_ptr<Wire> wire) {
  return [wire](const PacketDevice::Accept& accept) -> Expected<std::unique_ptr<PacketPort>> {
    {
      const std::lock_guard lock(wire->mutex);
      if (!wire->plugged) return Problem{"", 0, 0, "not there", ""};
    }
    std::unique_ptr<PacketPort> port = std::make_unique<WirePort>(wire);
    if (const auto problem = accept(*port)) return *problem;
    return port;
  };
}

// Waits a few seconds for `done`; the caller checks the result.
template <class Done>
void waitFor(Done done) {
  for (int k = 0; k < 5000 && !done(); ++k) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

inline Report of(const auto& bytes) { return {bytes.begin(), bytes.end()}; }

}  // namespace moltact::test
