// Inhibits all force of this process and ends it, whatever ends the process. One atomic word says to every thread whether
// force may be given. A driver registers its last act for its device; signal handlers, exit() and std::terminate call
// it. The handlers are installed when the first LastAct is armed. docs/safety.md says what is possible for which device.
#pragma once

#include <cstdint>
#include <span>

namespace moltact {

enum class InhibitReason : unsigned {
  Interrupted = 1,  ///< a person or the system asks the program to end, and it ends in order (interrupt.h)
  Stopped = 2,      ///< the program is stopped (Ctrl-Z) and may be continued
  Dying = 4,        ///< the process ends: a crash, a signal that nobody handles, exit()
};

/// True while no device may be given force: at least one reason inhibits it. Any thread, also the haptic one and a signal
/// handler: one load.
bool forceInhibited() noexcept;
/// Inhibits all force for this reason, until permitForce() with the same reason. Any thread, also a signal handler.
void inhibitForce(InhibitReason why) noexcept;
/// Withdraws this reason. Force stays inhibited while another reason remains. Any thread, also a signal handler.
void permitForce(InhibitReason why) noexcept;

/// Inhibits the force for good and does every armed act. For an exit that runs no destructors. Waits for other threads
/// where an act needs them, kPatience_ms at most.
void endForce() noexcept;
inline constexpr int kPatience_ms = 40;

/// The last act of a driver for one device, where the process ends without running destructors.
class LastAct {
 public:
  /// Called in a signal handler, on any thread, at any point of the program, repeatedly until it returns true. It may do
  /// only what is safe there. True: the device was last given no force.
  using Act = bool (*)(void* data) noexcept;

  LastAct() = default;
  ~LastAct() { disarm(); }
  LastAct(const LastAct&) = delete;
  LastAct& operator=(const LastAct&) = delete;

  /// One act at a time. False where all kMax slots are taken; the act is then not registered.
  bool arm(Act act, void* data) noexcept;
  /// After it returns the act is not called any more.
  void disarm() noexcept;

  static constexpr int kMax = 16;

 private:
  int slot_ = -1;
};

/// A last report for a device file that takes reports unchanged, such as a hidraw node or a serial port. The file is
/// opened a second time, so that the report can be written whoever holds the first descriptor.
class LastReport {
 public:
  LastReport() = default;
  ~LastReport();
  LastReport(const LastReport&) = delete;
  LastReport& operator=(const LastReport&) = delete;

  /// False where the file cannot be opened. Not for the haptic thread.
  bool arm(const char* path, std::span<const std::uint8_t> report) noexcept;

 private:
  static bool write(void* self) noexcept;

  int file_ = -1;
  std::uint8_t report_[64] = {};
  std::size_t size_ = 0;
  LastAct act_;  // last, so that it ends first
};

/// While one exists, the calling thread handles a crash by stack overflow: it has an alternate signal stack. For threads
/// that read files which others wrote.
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
