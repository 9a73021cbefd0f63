// Opens a device on a thread of its own: a driver may take seconds to find that there is none. Window's thread; nothing
// blocks here but the destructor and take().
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <string>

#include "engine/device/driver.h"
#include "engine/platform/background.h"

namespace moltact {

class PendingDeviceOpen {
 public:
  explicit PendingDeviceOpen(std::string name)
      : found_(inBackground([name = std::move(name)] { return openDevice(name); })) {}

  bool done() const { return found_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// Call once, when done(): the device, or the reason why there is none.
  Expected<std::unique_ptr<Device>> take() { return found_.get(); }

 private:
  std::future<Expected<std::unique_ptr<Device>>> found_;
};

}  // namespace moltact
