// Looks for a device that is waited for and opens it, on a thread of its own: a driver may take seconds to find that
// there is none. Window's thread; nothing here waits but the destructor and take().
#pragma once

#include <chrono>
#include <future>
#include <memory>
#include <string>

#include "engine/device/driver.h"
#include "engine/platform/background.h"

namespace moltact {

class DeviceSearch {
 public:
  explicit DeviceSearch(std::string name)
      : found_(inBackground([name = std::move(name)] { return openDevice(name); })) {}

  bool done() const { return found_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
  /// Once, when it is done: the device, or why there is none.
  Expected<std::unique_ptr<Device>> take() { return found_.get(); }

 private:
  std::future<Expected<std::unique_ptr<Device>>> found_;
};

}  // namespace moltact
