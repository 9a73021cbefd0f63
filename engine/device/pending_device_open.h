// Opens a device on a thread of its own: a driver may take seconds to find that there is none. Window's thread; nothing
// blocks here but the destructor and take().
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
  /// A device as its driver lists it, where hardware has a place: the driver's name and the place. Empty: unknown.
  using Hardware = std::string;
  struct Opened {
    std::optional<FoundDevice> found;  ///< nothing where the driver does not list it
    bool in_use = false;               ///< it is the hardware that was in use: it was not opened again
    Expected<std::unique_ptr<Device>> device{nullptr};
    Hardware hardware;
  };
  /// Opens the device of that name, unless it is `in_use`, which this process has open.
  PendingDeviceOpen(std::string name, Hardware in_use)
      : found_(inBackground(openUnlessInUse, std::move(name), std::move(in_use))) {}

  bool done() const { return found_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// Call once, when done(): the device, or the reason why there is none.
  Opened take() { return found_.get(); }

 private:
  static Opened openUnlessInUse(const std::string& name, const Hardware& in_use) {
    Opened out;
    out.found = findDevice(name);
    if (out.found && !out.found->place.empty()) out.hardware = name.substr(0, name.find(':')) + ' ' + out.found->place;
    // A driver may add to the place that it is in use.
    out.in_use = !in_use.empty() && (out.hardware == in_use || out.hardware.starts_with(in_use + ','));
    if (!out.in_use) out.device = openDevice(name);
    return out;
  }

  std::future<Opened> found_;
};

}  // namespace moltact
