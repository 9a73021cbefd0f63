// Turns of a class at its only device: who has the turn, who is next, and for how long. Pure logic; the caller supplies
// the time. Window's thread. Unit: second.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moltact {

class Turns {
 public:
  static constexpr double kShortest_s = 15.0, kLongest_s = 3600.0;

  enum class State {
    Off,       ///< there are no turns
    HandOver,  ///< the next student is called; the time is stopped
    Running,
    Paused,
  };

  /// Parses names or codes, one per line. Blanks around them and empty lines are removed; duplicates count once.
  static std::vector<std::string> namesIn(std::string_view lines);

  /// Calls the first student. Does nothing without names. `turn_s` is clamped to kShortest_s and kLongest_s.
  void begin(std::vector<std::string> names, double turn_s);
  void end() { state_ = State::Off; }

  State state() const { return state_; }
  bool on() const { return state_ != State::Off; }
  const std::vector<std::string>& names() const { return names_; }
  double turn_s() const { return turn_s_; }
  double left_s() const { return left_s_; }
  /// The number of turns begun, including the current one.
  std::size_t turnsBegun() const { return begun_; }

  /// The student whose turn it is; empty when off.
  const std::string& current() const;
  /// The student after the current one; the same if there is no other.
  const std::string& next() const;
  /// All other students, beginning with the next one.
  std::vector<std::string> waiting() const;

  /// Starts the time: the student has the device.
  void start();
  void pause();
  void resume();
  /// Calls the next student.
  void passOn();
  /// Calls this student out of turn; the order then continues after this student. Unknown names change nothing.
  void call(std::string_view name);
  /// Extends the current turn.
  void extend(double by_s);
  /// Removes a student. If it was this student's turn, the next one is called; if none is left, the turns end.
  void leave(std::string_view name);

  /// Advances the time. Returns true if the turn has just ended and the next student has been called.
  bool tick(double dt_s);

 private:
  std::vector<std::string> names_;
  std::size_t at_ = 0, begun_ = 0;
  double turn_s_ = 180.0, left_s_ = 0.0;
  State state_ = State::Off;
};

}  // namespace moltact
