// The check of a device in a person's hand: its places while nothing moves, a gentle pull, a wall to press on, and every
// way in which force must end. It asks before each part that moves the device. Calling thread; takes about half a minute.
// Units: millimetre, newton, second.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/device/device.h"

namespace moltact {

struct CheckedPart {
  std::string name;
  bool done = false;    ///< false: the person did not want it, or an earlier part forbids it
  bool passed = false;
  std::string found = {}; ///< what was measured, in words
};

struct DeviceCheckOptions {
  std::function<bool(const std::string&)> ask;  ///< the question before a part that moves the device; false leaves it out
  std::function<void(const std::string&)> tell; ///< what the person is to do now
  double part_s = 5.0;  ///< how long each part lasts
};

/// Checks the device and closes it. Parts that give force are left out for one that gives none.
std::vector<CheckedPart> checkDevice(std::unique_ptr<Device> device, const DeviceCheckOptions& options);

}  // namespace moltact
