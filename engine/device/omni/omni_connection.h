// Manages the one device that the vendor's driver has for this process. Whether it is present is known only after
// opening it, which may take some seconds. Therefore a device opened by look() stays open for the take() that usually
// follows, and is closed if none does. Any thread except the haptic one; the calls block.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/device/omni/omni_session.h"

namespace moltact {

class OmniConnection {
 public:
  static constexpr std::chrono::seconds kKeepOpen{2};

  static OmniConnection& get();
  ~OmniConnection();

  /// Opens the device to describe it; it stays open for kKeepOpen. Returns a Problem if the device is in use (taken()
  /// then describes it) or cannot be opened.
  Expected<OmniSession> look(const hd::Library& hd);
  /// Opens the device, or takes over the one opened by look(). It then counts as in use.
  Expected<OmniSession> take(const hd::Library& hd);
  /// Marks the device as no longer in use. Does not close it; the caller has done so.
  void giveBack();
  /// The description of the device in use, if any.
  std::optional<OmniSession> taken();
  /// Reports that the device in use was reopened; it may be a different one.
  void renewed(const OmniSession& session);
  /// Closes immediately a device that look() has opened.
  void closeUnused();

 private:
  Expected<OmniSession> opened(const hd::Library& hd);
  void run();

  std::mutex mutex_;
  std::condition_variable changed_;
  const hd::Library* hd_ = nullptr;
  std::optional<OmniSession> session_, taken_;
  std::chrono::steady_clock::time_point until_{};
  bool ends_ = false;
  std::thread closer_;
};

}  // namespace moltact
