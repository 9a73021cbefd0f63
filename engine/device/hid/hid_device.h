// A device that speaks in HID reports. A thread of its own waits for them and hands the newest place over; it gives the
// newest force after each report, no force when the haptic thread has stopped writing for 20 ms, and opens the device
// anew when it was unplugged. The last report that it writes is one without force, whatever ends it: a read or a write
// that fails, an exception, the destructor, a signal. It measures its own share of the delay: how old a place is when
// it is read, and how long a force waits for the thread. What the reports mean is a protocol's, one file a kind of
// device.
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
#include "engine/device/driver.h"
#include "engine/device/hid/hid_port.h"
#include "engine/device/kept_info.h"

namespace moltact {

/// What stands between a device and its force, in words for the person. While there is a text there is no force.
struct HidGuidance {
  const char* text = nullptr;   ///< lives as long as the program
  bool asks_calibrate = false;  ///< calibrate() is waited for
};

/// What a kind of device's reports mean. Used by one thread at a time.
class HidProtocol {
 public:
  virtual ~HidProtocol() = default;
  /// Asks the device what it is, when it is looked at, opened or opened anew. A Problem where it is not of this kind.
  virtual std::optional<Problem> begin(HidPort&, DeviceInfo&) { return std::nullopt; }
  /// After begin() gave a Problem: false where it is something else altogether.
  virtual bool ofKind() const noexcept { return true; }
  virtual HidGuidance guidance() const noexcept { return {}; }
  /// The person holds the device as guidance() asked. True: its places are others from now on.
  virtual bool calibrate() noexcept { return false; }
  /// One report as it came, of any length and content. True: it held a new place, which is in `pose`.
  virtual bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept = 0;
  /// Time passes: for devices that tell a speed and not a place.
  virtual void pass(double, DevicePose&) noexcept {}
  /// What the newest reports ask of the view, for devices that lead it.
  virtual ViewWish viewWish() const noexcept { return {}; }
  /// As Device::turnHand; asked before each pass().
  virtual void turnHand(bool) noexcept {}
  /// The report that gives this force, its id first; its length, 0 for a device without force.
  virtual std::size_t give(ForceN, std::span<std::uint8_t, 64>) noexcept { return 0; }
  /// The report that ends all force, with the motors off where they can be switched.
  virtual std::size_t stop(std::span<std::uint8_t, 64> out) noexcept { return give(ForceN{}, out); }
  /// The same for good: a report in any case, for it may be that the one before did not arrive; 0 only where none with
  /// a force can have been given.
  virtual std::size_t end(std::span<std::uint8_t, 64> out) noexcept { return stop(out); }
};

class HidDevice final : public Device {
 public:
  /// A Problem where the port leads to no device of the kind.
  using Accept = std::function<std::optional<Problem>(HidPort&)>;
  /// Opens the first device that is accepted.
  using Opener = std::function<Expected<std::unique_ptr<HidPort>>(const Accept&)>;

  /// Opens it. `known`: what is known of it beforehand. `opener` is kept and called again when the device was
  /// unplugged.
  static Expected<std::unique_ptr<Device>> open(Opener opener, std::unique_ptr<HidProtocol> protocol, DeviceInfo known);
  ~HidDevice() override;

  const DeviceInfo& info() const noexcept override { return info_.get(); }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN force) noexcept override { ask(force, true); }
  void stop() noexcept override { ask({}, false); }
  DeviceStatus status() override;
  void calibrate() override { calibrate_.store(true, std::memory_order_release); }
  ViewWish viewWish() noexcept override { return wish_.read(); }
  void turnHand(bool on) noexcept override { turns_hand_.store(on, std::memory_order_relaxed); }

 private:
  using Clock = std::chrono::steady_clock;
  struct State {
    DevicePose pose;
    std::uint32_t count = 0;
    Clock::time_point taken{};  // the newest place
    double wait_s = 0;          // of the newest force, until it was written
  };
  struct Command {
    ForceN force;
    bool motors_on = false;
    std::uint32_t count = 0;
    Clock::time_point at{};
  };

  explicit HidDevice(DeviceInfo known) : known_(known), info_(std::move(known)) {}
  std::optional<Problem> openPort();
  void run();
  bool revive(State& state);
  int take(State& state);
  bool giveNewest(State& state);
  void lose(State& state) noexcept;
  void endForce() noexcept;
  void ask(ForceN force, bool motors_on) noexcept;

  Opener opener_;
  std::unique_ptr<HidProtocol> protocol_;
  DeviceInfo known_;
  KeptInfo info_;
  std::unique_ptr<HidPort> port_;
  // The device's own thread's.
  Command taken_command_;          // the newest that was asked
  bool last_report_told_ = false;  // to the port, before the first force
  Clock::time_point look_again_{};

  TripleBuffer<State> state_;
  TripleBuffer<Command> command_;
  TripleBuffer<ViewWish> wish_;
  TripleBuffer<HidGuidance> guidance_;
  std::uint32_t last_told_ = 0;  // the haptic thread's
  Command next_command_;         // the haptic thread's
  std::atomic<bool> ends_{false}, gone_{false}, calibrate_{false}, turns_hand_{false};
  std::thread thread_;
};

/// A kind of HID device, as its driver knows it.
struct HidKind {
  std::string_view title;                      ///< where the device does not tell its own
  bool (*is)(const HidEntry&);                 ///< by what the system lists of it: it may be one
  std::unique_ptr<HidProtocol> (*protocol)();  ///< a new one
  DeviceInfo known;                            ///< its name is the found one's
};
/// One entry for each device of the kind: each is asked what it is. Those that cannot be opened say why and come last.
std::vector<FoundDevice> findHid(const HidKind& kind);
/// Opens the one that `found` stands for; after an unplugging it looks for one of the same kind again.
Expected<std::unique_ptr<Device>> openHid(const HidKind& kind, const FoundDevice& found);

/// Little-endian numbers out of and into a report.
inline std::int16_t int16At(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
}
inline std::uint16_t uint16At(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint16_t>(int16At(bytes, at));
}
inline void putInt16(std::span<std::uint8_t> bytes, std::size_t at, int value) {
  bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
  bytes[at + 1] = static_cast<std::uint8_t>((value >> 8) & 0xFF);
}

}  // namespace moltact
