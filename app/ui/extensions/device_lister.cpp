#include "app/ui/extensions/device_lister.h"

#include <chrono>
#include <exception>

#include "engine/platform/background.h"

namespace moltact {

void DeviceLister::begin(bool waits) {
  if (seen_.valid()) return;
  // A failed search returns no devices.
  const auto guarded = [find = find_]() -> std::vector<FoundDevice> {
    try {
      return find();
    } catch (const std::exception&) {
      return {};
    }
  };
  seen_ = inBackground(guarded);
  if (waits) seen_.wait();
}

std::optional<std::vector<FoundDevice>> DeviceLister::take() {
  if (!seen_.valid() || seen_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return seen_.get();
}

}  // namespace moltact
