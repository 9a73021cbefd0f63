// A device that exchanges packets over HID, a serial line or a network. A PacketProtocol interprets the reports, a
// PacketPort transports them. The device's own thread waits for reports and publishes the newest position. Without
// threads (a page in a browser) each tick reads what has arrived, and the time between frames counts as delay.
//
// The thread sends the newest force after each report, and zero force when the haptic thread has not written for
// kCommandTimeout_s. It reopens the device after an unplugging. The last report gives no force, whatever ends the
// device: a failed read or write, an exception, the destructor or a signal. The device measures its share of the delay:
// the age of a position when it is read, and the time that a force waits for the thread.
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
  /// The lateness accepted for a tick (safety::kStale_s): without a command for this time there is no force.
  static constexpr double kCommandTimeout_s = 0.02;

  /// Checks a port. Returns a Problem if it does not lead to a device of the kind.
  using Accept = std::function<std::optional<Problem>(PacketPort&)>;
  /// Opens the first device that is accepted.
  using Opener = std::function<Expected<std::unique_ptr<PacketPort>>(const Accept&)>;

  /// Opens the device. `known` is the description known in advance; the protocol completes it. `opener` is called again
  /// after an unplugging. Without `own_thread` the ticks do the device's work. `lost` is the message about a
  /// disconnected device, with a placeholder for its name.
  static Expected<std::unique_ptr<Device>> open(Opener opener, std::unique_ptr<PacketProtocol> protocol,
                                                DeviceInfo known, bool own_thread = threadsAvailable(),
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
    std::uint32_t count = 0;       // number of received positions
    Clock::time_point received{};  // time of the newest position
    double wait_s = 0;             // time from the newest command to its sending
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
  void writeNewestForce() noexcept;
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
  // Used only by the device's own thread, or without one by the ticks.
  Command newest_command_;
  bool last_report_kept_ = false;  // stored in the port, before the first force
  Clock::time_point look_again_{}, last_turn_{};
  State own_state_;

  TripleBuffer<State> state_;
  TripleBuffer<Command> command_;
  TripleBuffer<ViewMotion> view_motion_;
  TripleBuffer<DeviceGuidance> guidance_;
  std::uint32_t last_read_ = 0;  // haptic thread: count of the last position
  Command next_command_;         // haptic thread
  std::atomic<bool> ends_{false}, gone_{false}, calibrate_{false}, rotates_hand_{false};
  std::thread thread_;
};

}  // namespace moltact
