// Opens a device on a separate thread, because a driver may take seconds to find that there is none. Window's thread;
// only the destructor and take() block.
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "engine/device/driver.h"
#include "engine/platform/background.h"

namespace moltact {

class PendingDeviceOpen {
 public:
  /// Identifies hardware by the driver's name and the port. Empty: unknown.
  using Hardware = std::string;
  struct Opened {
    std::optional<FoundDevice> found;  ///< empty: the driver does not list it
    bool in_use = false;               ///< it is the hardware in use and was not opened again
    Expected<std::unique_ptr<Device>> device{nullptr};
    Hardware hardware;
  };
  /// Opens the device of that name, unless it is the hardware `in_use`, which this process has open.
  PendingDeviceOpen(std::string name, Hardware in_use)
      : found_(inBackground(openUnlessInUse, std::move(name), std::move(in_use))) {}

  bool done() const { return found_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// Returns the device, or the reason why there is none. Call once, when done().
  Opened take() { return found_.get(); }

 private:
  static Opened openUnlessInUse(const std::string& name, const Hardware& in_use) {
    Opened out;
    out.found = findDevice(name);
    if (out.found && !out.found->place.empty()) out.hardware = name.substr(0, name.find(':')) + ' ' + out.found->place;
    // A driver may append to the port that it is in use.
    out.in_use = !in_use.empty() && (out.hardware == in_use || out.hardware.starts_with(in_use + ','));
    if (!out.in_use) out.device = openDevice(name);
    return out;
  }

  std::future<Opened> found_;
};

}  // namespace moltact
