// The meaning of a device's reports, one class for each kind of device. Pure translation between bytes and poses or
// forces: PacketDevice (packet_device.h) owns the thread, the port and the watchdog. One thread at a time.
// Units: millimetre, newton, newton millimetre, second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/core/problem.h"
#include "engine/device/device.h"
#include "engine/device/packet/packet_port.h"

namespace moltact {

/// The reason why a device gives no force yet, in words for the person. While there is a text there is no force.
struct DeviceGuidance {
  const char* text = nullptr;   ///< lives as long as the program
  bool asks_calibrate = false;  ///< the device waits for calibrate()
};

class PacketProtocol {
 public:
  virtual ~PacketProtocol() = default;
  /// Asks the device for its description, when it is listed, opened or reopened. A Problem where it is not of this
  /// kind.
  virtual std::optional<Problem> begin(PacketPort&, DeviceInfo&) { return std::nullopt; }
  /// After begin() returned a Problem: false where the device is of another kind altogether.
  virtual bool ofKind() const noexcept { return true; }
  virtual DeviceGuidance guidance() const noexcept { return {}; }
  /// The person holds the device as guidance() asked. True: from now on the same pose gives another place.
  virtual bool calibrate() noexcept { return false; }
  /// Parses one report as it came, of any length and content. True: it held a new place, which is now in `pose`.
  virtual bool parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept = 0;
  /// Advances the pose by `dt_s`, for devices that report a speed and no place.
  virtual void advance(double /*dt_s*/, DevicePose&) noexcept {}
  /// The motion of the view that the newest reports ask for, for devices that lead it.
  virtual ViewMotion viewMotion() const noexcept { return {}; }
  /// As Device::rotateHand; called before each advance().
  virtual void rotateHand(bool) noexcept {}
  /// Encodes the report that gives this force, and this torque where the device drives one (DeviceSpecs::dof_out 6).
  /// Its id comes first. Returns its length; 0: nothing is to be written.
  virtual std::size_t encode(const Wrench&, ReportBuffer) noexcept { return 0; }
  /// Encodes the report that ends all force, with the motors off where they can be switched.
  virtual std::size_t encodeStop(ReportBuffer out) noexcept { return encode(Wrench{}, out); }
  /// Encodes the last report that the device gets: no force. Unlike encodeStop() it returns a report even where the
  /// same one was sent just before, for that one may not have arrived; 0 only where no force can have been given.
  virtual std::size_t encodeFinalReport(ReportBuffer out) noexcept { return encodeStop(out); }
};

}  // namespace moltact
