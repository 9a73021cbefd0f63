// A person's or the system's wish to end the program (Ctrl-C, the terminal closed, the session's end) seen by the
// window or a command, so that a device is closed and what was done is saved in order. Not for the haptic thread.
#pragma once

#include <memory>

namespace moltact {

/// While there is one, the first such wish ends all force at once (force_inhibit.h) and shows here; the second ends the
/// program as ever. One at a time. Outlives the device.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

  bool seen() const noexcept;

 private:
  struct Before;
  std::unique_ptr<Before> before_;
};

}  // namespace moltact
