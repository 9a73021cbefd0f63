// Inhibits all force of this process, and ends all force when the process ends for any reason. One atomic word holds
// the reasons for inhibition. A driver registers a last act for its device; signal handlers, exit() and std::terminate
// call it. The handlers are installed when the first LastAct is armed. docs/safety.md states what is possible for each
// device.
#pragma once

#include <cstdint>
#include <span>

namespace moltact {

enum class InhibitReason : unsigned {
  Interrupted = 1,  ///< a user or the system requests an orderly end of the program (interrupt.h)
  Stopped = 2,      ///< the program is stopped (Ctrl-Z) and may be continued
  Dying = 4,        ///< the process ends: a crash, an unhandled signal, exit()
};

/// True while at least one reason inhibits force; no device may then be given force. Any thread, including the haptic
/// one and a signal handler: one atomic load.
bool forceInhibited() noexcept;
/// Inhibits all force for this reason, until permitForce() with the same reason. Any thread, also a signal handler.
void inhibitForce(InhibitReason why) noexcept;
/// Withdraws this reason. Force stays inhibited while another reason remains. Any thread, also a signal handler.
void permitForce(InhibitReason why) noexcept;

/// Inhibits force permanently and performs every armed act, for an exit without destructors. If an act needs another
/// thread it waits for it, at most kPatience_ms.
void endForce() noexcept;
/// True from the beginning of endForce(). Any thread, also a signal handler.
bool forceEnded() noexcept;
inline constexpr int kPatience_ms = 40;

/// A driver's last act for one device, performed when the process ends without destructors.
class LastAct {
 public:
  /// Called in a signal handler, on any thread, at any point of the program, repeatedly until it returns true. It must
  /// be async-signal-safe. True: the device has received zero force as its last command.
  using Act = bool (*)(void* data) noexcept;

  LastAct() = default;
  ~LastAct() { disarm(); }
  LastAct(const LastAct&) = delete;
  LastAct& operator=(const LastAct&) = delete;

  /// One act per object. Returns false if all kMax slots are in use; the act is then not registered.
  bool arm(Act act, void* data) noexcept;
  /// After its return the act is no longer called.
  void disarm() noexcept;

  static constexpr int kMax = 16;

 private:
  int slot_ = -1;
};

/// A last report for a device file that takes reports unchanged, such as a hidraw node or a serial port. The file is
/// opened a second time, so that the report does not depend on the first descriptor.
class LastReport {
 public:
  LastReport() = default;
  ~LastReport();
  LastReport(const LastReport&) = delete;
  LastReport& operator=(const LastReport&) = delete;

  /// Returns false if the file cannot be opened. Not for the haptic thread.
  bool arm(const char* path, std::span<const std::uint8_t> report) noexcept;

 private:
  static bool write(void* self) noexcept;

  int file_ = -1;
  std::uint8_t report_[64] = {};
  std::size_t size_ = 0;
  LastAct act_;  // declared last, so that it is destroyed first
};

/// Gives the calling thread an alternate signal stack, so that it handles a crash by stack overflow. For threads that
/// read untrusted files.
class CrashStack {
 public:
  CrashStack() noexcept;
  ~CrashStack();
  CrashStack(const CrashStack&) = delete;
  CrashStack& operator=(const CrashStack&) = delete;

 private:
  void* stack_ = nullptr;
};

}  // namespace moltact
