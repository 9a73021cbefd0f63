// The check of a device in a person's hand: its places while nothing moves, a gentle pull, a wall to press on, every
// way in which force must end, and the faults of the loop that can be made with a real device, each judged by the
// promises of docs/safety.md (force_monitor.h). It asks before each part that moves the device, and begins when the
// device is ready. Calling thread; takes a few minutes. Units: millimetre, newton, second.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/device/device.h"

namespace moltact {

struct CheckedPart {
  std::string name;
  bool done = false;  ///< false: the person did not want it, or something forbids it
  bool passed = false;
  bool forces = false;     ///< it is about the force
  std::string found = {};  ///< what was measured, in words
};

struct DeviceCheckOptions {
  std::function<bool(const std::string&)> ask =
      {};  ///< the question before a part that moves the device; false leaves it out
  std::function<void(const std::string&)> tell = {};  ///< what the person is to do now
  /// Some times a second while the device is not ready. True: the person holds it as its text asked for the
  /// calibration.
  std::function<bool(const DeviceStatus&)> guide = {};
  std::function<void(const CheckedPart&)> checked = {};  ///< each part, when it is over
  std::function<bool()> interrupted = {};  ///< true: no force from now on, and all that is left is left out
  double part_s = 5.0;                     ///< how long each part lasts
  double ready_s = 2.0;                    ///< how long the device is waited for
  double unplug_s = 0.0;  ///< how long it is waited for that the plug is pulled, and put back; 0: that part is left out
};

/// Checks the device and closes it. Parts that give force are left out for one that gives none. All parts are told of.
std::vector<CheckedPart> checkDevice(std::unique_ptr<Device> device, const DeviceCheckOptions& options);

}  // namespace moltact
