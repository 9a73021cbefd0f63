// A person's wish to end a command (Ctrl-C, the terminal closed, the system going down) seen by the command, so that a device
// is closed in order. Not for the haptic thread.
#pragma once

#include <memory>

namespace moltact {

/// While there is one, the first such wish only shows here; the second ends the program as ever. One at a time.
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
