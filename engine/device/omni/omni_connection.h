// The one device that the maker's driver has for this process. Whether it is there shows only when it is opened, and
// that may take a while: so what a look has opened is kept for the opening that mostly follows, and closed where none
// does. Any thread but the haptic one.
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

  /// What is there, or was when it was last opened; it stays open for kKeepOpen.
  Expected<OmniSession> look(const hd::Library& hd);
  /// Opens it, or gives the one that a look has opened. It is taken from now on.
  Expected<OmniSession> take(const hd::Library& hd);
  void giveBack();
  /// The one that is taken, as it was opened last.
  std::optional<OmniSession> taken();
  /// It was opened anew, and may be another one.
  void renewed(const OmniSession& session);
  /// Closes what a look has opened, at once.
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
