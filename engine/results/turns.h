// Who is at the one device of a class, who is next, and for how long: a round of turns of set length. Pure logic on a
// given clock; window's thread. Unit: second.
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
    HandOver,  ///< the next student is called; the time waits
    Running,
    Paused,
  };

  /// Names or codes, one a line; blanks around them and empty lines go, and a name that stands twice counts once.
  static std::vector<std::string> namesIn(std::string_view lines);

  /// Calls the first student. Does nothing without names. `turn_s` is clamped to kShortest_s and kLongest_s.
  void begin(std::vector<std::string> names, double turn_s);
  void end() { state_ = State::Off; }

  State state() const { return state_; }
  bool on() const { return state_ != State::Off; }
  const std::vector<std::string>& names() const { return names_; }
  double turn_s() const { return turn_s_; }
  double left_s() const { return left_s_; }
  /// Turns that have been begun, the one that goes on among them.
  std::size_t turnsBegun() const { return begun_; }

  /// The student whose turn it is; empty when off.
  const std::string& current() const;
  /// Who comes after; the same one where there is no other.
  const std::string& next() const;
  /// Everyone else, from the next on.
  std::vector<std::string> waiting() const;

  /// The student has the device in the hand: the time runs.
  void start();
  void pause();
  void goOn();
  /// Calls the next student.
  void passOn();
  /// Calls this one out of turn; the round goes on after him. Unknown names change nothing.
  void call(std::string_view name);
  /// A minute longer (or any time), for the turn that goes on.
  void extend(double by_s);
  /// Takes one out of the round. When it is his turn, the next is called; without anyone left, turns end.
  void leave(std::string_view name);

  /// Time goes by. True when the turn has just run out: the next student has been called.
  bool tick(double dt_s);

 private:
  std::vector<std::string> names_;
  std::size_t at_ = 0, begun_ = 0;
  double turn_s_ = 180.0, left_s_ = 0.0;
  State state_ = State::Off;
};

}  // namespace moltact
