// The one device that the vendor's driver has for this process. It shows whether it is there only when it is opened,
// and opening may take a while. So a device that look() has opened is kept for the take() that mostly follows, and
// closed when none does. Any thread but the haptic one.
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

  /// The device as it is now, or as it was when it was last opened; it stays open for kKeepOpen.
  Expected<OmniSession> look(const hd::Library& hd);
  /// Opens the device, or hands over the one that look() has opened. It is in use from now on.
  Expected<OmniSession> take(const hd::Library& hd);
  void giveBack();
  /// The device that is in use, as it was opened last.
  std::optional<OmniSession> taken();
  /// The device in use was reopened, and may be another one.
  void renewed(const OmniSession& session);
  /// Closes at once what look() has opened.
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
