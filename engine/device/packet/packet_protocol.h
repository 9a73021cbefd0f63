// The interpretation of a device's reports, one class per kind of device. It only translates between bytes and poses or
// forces; PacketDevice (packet_device.h) owns the thread, the port and the watchdog. One thread at a time. Units:
// millimetre, newton, newton millimetre, second.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "engine/core/problem.h"
#include "engine/device/device.h"
#include "engine/device/packet/packet_port.h"

namespace moltact {

/// The reason why a device gives no force yet, for the user. While the text is set there is no force.
struct DeviceGuidance {
  const char* text = nullptr;   ///< static; null: the device is ready
  bool asks_calibrate = false;  ///< the device waits for calibrate()
};

class PacketProtocol {
 public:
  virtual ~PacketProtocol() = default;
  /// Requests the device's description when it is listed, opened or reopened. Returns a Problem if it is not of this
  /// kind.
  virtual std::optional<Problem> begin(PacketPort&, DeviceInfo&) { return std::nullopt; }
  /// After a Problem of begin(): false if the device is of a different kind altogether.
  virtual bool ofKind() const noexcept { return true; }
  virtual DeviceGuidance guidance() const noexcept { return {}; }
  /// Calibrates the device, which the user now holds as guidance() requested. Returns true if the calibration changes
  /// the position of the present pose.
  virtual bool calibrate() noexcept { return false; }
  /// Parses a received report of any length and content. Returns true if it contained a new position, which is then in
  /// `pose`.
  virtual bool parseReport(std::span<const std::uint8_t> report, DevicePose& pose) noexcept = 0;
  /// Advances the pose by `dt_s`, for devices that report a speed instead of a position.
  virtual void advance(double /*dt_s*/, DevicePose&) noexcept {}
  /// The motion of the view requested by the newest reports, for devices that control it.
  virtual ViewMotion viewMotion() const noexcept { return {}; }
  /// As Device::rotateHand; called before each advance().
  virtual void rotateHand(bool) noexcept {}
  /// Encodes the report with this force, and with this torque if the device drives one (DeviceSpecs::dof_out 6). Its
  /// first byte is the report's id. Returns the length in bytes; 0: nothing to write.
  virtual std::size_t encode(const Wrench&, ReportBuffer) noexcept { return 0; }
  /// Encodes the report that ends all force, with the motors off if they can be switched.
  virtual std::size_t encodeStop(ReportBuffer out) noexcept { return encode(Wrench{}, out); }
  /// Encodes the last report to the device, with zero force. Unlike encodeStop() it also returns a report if an equal
  /// one was just sent, because that one may have been lost. Returns 0 only if no force can have been output.
  virtual std::size_t encodeFinalReport(ReportBuffer out) noexcept { return encodeStop(out); }
};

}  // namespace moltact
