// Reports that a user or the system requests the end of the program (Ctrl-C, a closed terminal, the end of the
// session). The window or command then closes the device and saves its work. Not for the haptic thread.
#pragma once

#include <memory>

namespace moltact {

/// While it exists, the first request inhibits all force immediately (force_inhibit.h) and makes seen() return true;
/// the second ends the program in the system's default way. One instance at a time. It must outlive the device.
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
