// A device that speaks in HID reports. A thread of its own waits for them and hands the newest place over; it gives the
// newest force after each report, no force when the haptic thread has stopped writing for 100 ms, and opens the device
// anew when it was unplugged. What the reports mean is a protocol's, one file a kind of device.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <memory>
#include <span>
#include <thread>

#include "engine/core/triple_buffer.h"
#include "engine/device/device.h"
#include "engine/device/driver.h"
#include "engine/device/hid/hid_port.h"

namespace moltact {

/// What a kind of device's reports mean. Used by one thread at a time.
class HidProtocol {
 public:
  virtual ~HidProtocol() = default;
  /// Asks the device what it is, when it is opened or opened anew. A Problem where it is not of this kind.
  virtual std::optional<Problem> begin(HidPort&, DeviceInfo&) { return std::nullopt; }
  /// One report as it came, of any length and content. True: it held a new place, which is in `pose`.
  virtual bool take(std::span<const std::uint8_t> report, DevicePose& pose) noexcept = 0;
  /// Time passes: for devices that tell a speed and not a place.
  virtual void pass(double, DevicePose&) noexcept {}
  /// What the newest reports ask of the view, for devices that lead it.
  virtual ViewWish viewWish() const noexcept { return {}; }
  /// The report that gives this force, its id first; its length, 0 for a device without force.
  virtual std::size_t give(ForceN, std::span<std::uint8_t, 64>) noexcept { return 0; }
  /// The report that ends all force, with the motors off where they can be switched.
  virtual std::size_t stop(std::span<std::uint8_t, 64> out) noexcept { return give(ForceN{}, out); }
};

class HidDevice final : public Device {
 public:
  using Opener = std::function<Expected<std::unique_ptr<HidPort>>()>;

  /// Opens it. `info`: what is known of it beforehand. `opener` is kept and called again when the device was unplugged.
  static Expected<std::unique_ptr<Device>> open(Opener opener, std::unique_ptr<HidProtocol> protocol, DeviceInfo info);
  ~HidDevice() override;

  const DeviceInfo& info() const noexcept override { return info_; }
  DevicePose read(double dt_s) noexcept override;
  void write(ForceN force) noexcept override { ask(force, true); }
  void stop() noexcept override { ask({}, false); }
  DeviceStatus status() override;
  ViewWish viewWish() noexcept override { return wish_.read(); }

 private:
  HidDevice() = default;
  void run();
  bool reopen();
  void ask(ForceN force, bool motors_on) noexcept;

  Opener opener_;
  std::unique_ptr<HidProtocol> protocol_;
  DeviceInfo info_;
  std::unique_ptr<HidPort> port_;

  struct Told {
    DevicePose pose;
    std::uint32_t count = 0;
  };
  struct Asked {
    ForceN force;
    bool motors_on = false;
    std::uint32_t count = 0;
  };
  TripleBuffer<Told> told_;
  TripleBuffer<Asked> asked_;
  TripleBuffer<ViewWish> wish_;
  std::uint32_t last_told_ = 0;  // the haptic thread's
  Asked asking_;                 // the haptic thread's
  std::atomic<bool> ends_{false}, gone_{false};
  std::thread thread_;
};

/// One entry for each interface that `is` accepts: what a driver's find() gives. Those that cannot be opened say why.
std::vector<FoundDevice> findHid(bool (*is)(const HidEntry&), bool gives_force, std::string_view title);
/// An opener for the interface that `found` stands for; after an unplugging it looks for one of the same kind again.
HidDevice::Opener hidOpener(bool (*is)(const HidEntry&), const FoundDevice& found);

/// Little-endian numbers out of and into a report.
inline std::int16_t int16At(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::int16_t>(bytes[at] | bytes[at + 1] << 8);
}
inline std::uint16_t uint16At(std::span<const std::uint8_t> bytes, std::size_t at) { return static_cast<std::uint16_t>(int16At(bytes, at)); }
inline void putInt16(std::span<std::uint8_t> bytes, std::size_t at, int value) {
  bytes[at] = static_cast<std::uint8_t>(value & 0xFF);
  bytes[at + 1] = static_cast<std::uint8_t>((value >> 8) & 0xFF);
}

}  // namespace moltact
