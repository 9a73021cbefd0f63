// Searches for devices in a background thread, because a search takes some tens of milliseconds. Window's thread,
// except for the search itself.
#pragma once

#include <functional>
#include <future>
#include <optional>
#include <vector>

#include "engine/device/driver.h"

namespace moltact {

class DeviceLister {
 public:
  using Find = std::function<std::vector<FoundDevice>()>;
  explicit DeviceLister(Find find = findDevices) : find_(std::move(find)) {}

  /// Starts a search unless one is running. `waits`: blocks until the search is done (for ServoClock::Frames).
  void begin(bool waits);
  /// Returns the devices found, once; nothing while the search runs.
  std::optional<std::vector<FoundDevice>> take();

 private:
  Find find_;
  std::future<std::vector<FoundDevice>> seen_;
};

}  // namespace moltact
