// The check of a device in a person's hand: its positions while nothing moves, a gentle pull, a wall to press on, every
// way in which force must end, and the loop faults that can be made with a real device. Each is judged by the promises
// of docs/safety.md (force_monitor.h). It asks before each part that moves the device, and begins when the device is
// ready. Calling thread; takes a few minutes. Units: millimetre, newton, second.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/device/device.h"

namespace moltact {

struct CheckedPart {
  std::string name;
  bool done = false;  ///< false: the person declined it, or something forbids it
  bool passed = false;
  bool forces = false;     ///< the part is about the force
  std::string found = {};  ///< what was measured, in words
};

struct DeviceCheckOptions {
  /// Asks before a part that moves the device; false leaves the part out.
  std::function<bool(const std::string&)> ask = {};
  std::function<void(const std::string&)> tell = {};  ///< says what the person should do now
  /// Called some times a second while the device is not ready. True: the person holds it as its text asked for the
  /// calibration.
  std::function<bool(const DeviceStatus&)> guide = {};
  std::function<void(const CheckedPart&)> checked = {};  ///< called for each part when it is over
  std::function<bool()> interrupted = {};  ///< true: no force from now on, and the remaining parts are left out
  double part_s = 5.0;                     ///< how long each part lasts
  double ready_s = 2.0;                    ///< how long to wait for the device
  double unplug_s = 0.0;  ///< how long to wait for the plug to be pulled, and put back; 0: that part is left out
};

/// Checks the device and closes it. Parts that give force are left out for a device that gives none. Returns all parts.
std::vector<CheckedPart> checkDevice(std::unique_ptr<Device> device, const DeviceCheckOptions& options);

}  // namespace moltact
