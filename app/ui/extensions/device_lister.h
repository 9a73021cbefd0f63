// Looks which devices there are away from the window's thread, for it takes some tens of milliseconds. Window's thread,
// but for the looking itself.
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

  /// Begins to look; while it is looking it goes on with that. `waits`: until it has seen, as on the frames' clock.
  void begin(bool waits);
  /// The devices found, once; nothing while the search runs.
  std::optional<std::vector<FoundDevice>> take();

 private:
  Find find_;
  std::future<std::vector<FoundDevice>> seen_;
};

}  // namespace moltact
