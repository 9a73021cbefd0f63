// A device that speaks in packets: HID, a serial line, a network. Its own thread waits for reports and hands the newest
// place over; where no thread can be had (a page in a browser) each tick takes what has come, and the time from one
// frame's ticks to the next one's counts as delay. It gives the newest force after each report, and no force when the
// haptic thread has not written for kCommandTimeout_s. It reopens the device after it was unplugged. The last report
// that it writes gives no force, whatever ends it: a read or a write that fails, an exception, the destructor, a
// signal. It measures its own part of the delay: how old a place is when it is read, and how long a force waits for the
// thread. A PacketProtocol knows what the reports mean, a PacketPort how they travel.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <thread>

#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"
#include "engine/device/packet/packet_port.h"
#include "engine/device/packet/packet_protocol.h"
#include "engine/device/versioned_device_info.h"
#include "engine/platform/background.h"

namespace moltact {

class PacketDevice final : public Device {
 public:
  /// As late as a tick may be (safety::kStale_s): without a command from the haptic thread for so long, no force.
  static constexpr double kCommandTimeout_s = 0.02;

  /// Judges a port. A Problem where it leads to no device of the kind.
  using Accept = std::function<std::optional<Problem>(PacketPort&)>;
  /// Opens the first device that is accepted.
  using Opener = std::function<Expected<std::unique_ptr<PacketPort>>(const Accept&)>;

  /// Opens the device. `known` is its description as far as it is known beforehand; the protocol completes it. `opener`
  /// is kept and called again after the device was unplugged. Without `own_thread` the ticks do the device's work.
  /// `lost` is the sentence with the device's name for the time while it is away.
  static Expected<std::unique_ptr<Device>> open(Opener opener, std::unique_ptr<PacketProtocol> protocol,
                                                DeviceInfo known, bool own_thread = threadsCanBeHad(),
                                                const char* lost = kUnplugged);
  static const char* const kUnplugged;
  ~PacketDevice() override;

  const DeviceInfo& info() const noexcept override { return info_.get(); }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN force) noexcept override { command({.force = force}, true); }
  void writeWrench(const Wrench& wrench) noexcept override { command(wrench, true); }
  void stop() noexcept override { command({}, false); }
  DeviceStatus status() override;
  void calibrate() override { calibrate_.store(true, std::memory_order_release); }
  ViewMotion viewMotion() noexcept override { return view_motion_.read(); }
  void rotateHand(bool on) noexcept override { rotates_hand_.store(on, std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;
  struct State {
    DevicePose pose;
    std::uint32_t count = 0;       // of places that have come
    Clock::time_point received{};  // the newest place
    double wait_s = 0;             // of the newest command, until it was written
  };
  struct Command {
    Wrench wrench;
    bool motors_on = false;
    std::uint32_t count = 0;
    Clock::time_point at{};
  };

  PacketDevice(DeviceInfo known, bool own_thread) : known_(known), info_(std::move(known)), own_thread_(own_thread) {}
  std::optional<Problem> openPort();
  void run();
  void takeTurn(int wait_ms) noexcept;
  void giveNewest() noexcept;
  bool reopen(State& state);
  int receive(State& state, int wait_ms);
  bool sendNewest(State& state);
  void lose(State& state) noexcept;
  void sendFinalReport() noexcept;
  void command(const Wrench& wrench, bool motors_on) noexcept;

  Opener opener_;
  std::unique_ptr<PacketProtocol> protocol_;
  DeviceInfo known_;
  VersionedDeviceInfo info_;
  const bool own_thread_;
  const char* lost_ = kUnplugged;
  std::unique_ptr<PacketPort> port_;
  // The device's own thread only, or without one the ticks'.
  Command newest_command_;
  bool last_report_kept_ = false;  // by the port, before the first force
  Clock::time_point look_again_{}, last_turn_{};
  State own_state_;

  TripleBuffer<State> state_;
  TripleBuffer<Command> command_;
  TripleBuffer<ViewMotion> view_motion_;
  TripleBuffer<DeviceGuidance> guidance_;
  std::uint32_t last_read_ = 0;  // of the haptic thread: the count of the last place
  Command next_command_;         // of the haptic thread
  std::atomic<bool> ends_{false}, gone_{false}, calibrate_{false}, rotates_hand_{false};
  std::thread thread_;
};

}  // namespace moltact
