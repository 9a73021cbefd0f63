// Shows the window or a command that a person or the system asks the program to end (Ctrl-C, a closed terminal, the
// session's end), so that it closes the device and saves the work in order. Not for the haptic thread.
#pragma once

#include <memory>

namespace moltact {

/// While one exists, the first such request inhibits all force at once (force_inhibit.h) and seen() returns true; the
/// second ends the program in the system's usual way. One at a time. It must outlive the device.
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
