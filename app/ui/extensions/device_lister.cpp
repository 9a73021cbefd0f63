#include "app/ui/extensions/device_lister.h"

#include <chrono>
#include <exception>
#include <system_error>

namespace moltact {

void DeviceLister::begin(bool waits) {
  if (seen_.valid()) return;
  // A look that fails has seen nothing new.
  const auto guarded = [find = find_]() -> std::vector<FoundDevice> {
    try {
      return find();
    } catch (const std::exception&) {
      return {};
    }
  };
  try {
    seen_ = std::async(waits ? std::launch::deferred : std::launch::async, guarded);
  } catch (const std::system_error&) {  // no further thread can be had
    seen_ = std::async(std::launch::deferred, guarded);
    waits = true;
  }
  if (waits) seen_.wait();
}

std::optional<std::vector<FoundDevice>> DeviceLister::take() {
  if (!seen_.valid() || seen_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return std::nullopt;
  return seen_.get();
}

}  // namespace moltact
