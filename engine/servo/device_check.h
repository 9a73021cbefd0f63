// Checks a device held by a user: its positions at rest, a gentle pull, and a wall to press on. Also every event that
// must switch the force off, and injected loop faults. Each part is judged by the guarantees of docs/safety.md
// (force_monitor.h). The check starts when the device is ready and asks before each part that moves it. Blocks the
// calling thread for a few minutes. Units: millimetre, newton, second.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/device/device.h"

namespace moltact {

/// The result of one part of the check.
struct CheckedPart {
  std::string name;
  bool done = false;  ///< false: declined by the user, or not possible
  bool passed = false;
  bool forces = false;     ///< the part tests the force
  std::string found = {};  ///< the measured values, as text
};

struct DeviceCheckOptions {
  /// Asks before a part that moves the device; false skips the part.
  std::function<bool(const std::string&)> ask = {};
  std::function<void(const std::string&)> tell = {};  ///< shows an instruction to the user
  /// Called several times a second while the device is not ready. Returns true when the user confirms that the
  /// device is held as the text for its calibration asks.
  std::function<bool(const DeviceStatus&)> guide = {};
  std::function<void(const CheckedPart&)> checked = {};  ///< called after each part
  std::function<bool()> interrupted = {};                ///< true: ends all force and skips the remaining parts
  double part_s = 5.0;                                   ///< duration of each part
  double ready_s = 2.0;                                  ///< longest wait for the device
  double unplug_s = 0.0;  ///< longest wait for unplugging, and for plugging in again; 0: skips that part
};

/// Checks the device and closes it. Parts with force are skipped for a device without force. Returns all parts.
std::vector<CheckedPart> checkDevice(std::unique_ptr<Device> device, const DeviceCheckOptions& options);

}  // namespace moltact
