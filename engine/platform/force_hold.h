// The end of all force of this process, whatever ends it: what a driver does last for its device is kept here and done
// by the handlers of signals, at exit() and by std::terminate; and one word says to every thread whether force may be
// given at all. The handlers are installed when the first LastAct is armed. What can be done for which device:
// docs/safety.md.
#pragma once

#include <cstdint>
#include <span>

namespace moltact {

enum class Hold : unsigned {
  Interrupted = 1,  ///< a person or the system wants the program to end, which ends in order (interrupt.h)
  Stopped = 2,      ///< the program is stopped (Ctrl-Z) and may go on
  Dying = 4,        ///< the process ends: a crash, a signal that nobody takes, exit()
};

/// True while no device is to be given force. Any thread, also the haptic one and a signal's handler: one load.
bool forceHeld() noexcept;
/// From now on no force, until letForce() with the same word. Any thread, also in a signal's handler.
void holdForce(Hold why) noexcept;
void letForce(Hold why) noexcept;

/// Holds the force for good and does every armed act: for a way out that no destructor sees. Waits for what other
/// threads have to do for it, kPatience_ms at most.
void endForce() noexcept;
inline constexpr int kPatience_ms = 40;

/// What a driver does last for one device, where the process ends otherwise than by its destructors.
class LastAct {
 public:
  /// Called in a signal's handler, on any thread, at any place of the program, again and again until it says true: only
  /// what is safe there. True: the last that the device was given is no force.
  using Act = bool (*)(void* data) noexcept;

  LastAct() = default;
  ~LastAct() { disarm(); }
  LastAct(const LastAct&) = delete;
  LastAct& operator=(const LastAct&) = delete;

  /// One act at a time. Where all kMost places are taken it is not kept, which tells false.
  bool arm(Act act, void* data) noexcept;
  /// After it returns the act is not called any more.
  void disarm() noexcept;

  static constexpr int kMost = 16;

 private:
  int place_ = -1;
};

/// A last report for a file of the system that is written to as it is, such as a hidraw node: it is opened a second
/// time, so that the report can be written whoever holds the other one.
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

/// Lets a crash by a full stack be handled on the calling thread while there is one. For threads that read what others
/// wrote.
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
