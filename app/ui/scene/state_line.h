// Updates the state text at a pace that can be read or spoken. A contact is reported as soon as it has been constant
// for a moment, a force only if it has changed enough to matter. The caller supplies the time. Units: second, newton.
#pragma once

#include <string>

namespace moltact {

class StateLine {
 public:
  /// The line changes at most once per `pace_s`, and for the force alone only by `step_N` or more.
  struct Pace {
    double pace_s = 0.4;
    double rest_s = 0.1;  ///< minimum time of an unchanged contact before it is reported
    double step_N = 0.1;
  };
  static constexpr Pace reading() { return {}; }
  static constexpr Pace speaking() { return {1.5, 0.25, 0.5}; }

  explicit StateLine(Pace pace) : pace_(pace) {}

  /// `what`: the contact without the force, or why there is none; `line`: the whole sentence. Returns true if text()
  /// has changed.
  bool update(const std::string& what, const std::string& line, double force_N, double now_s);

  const std::string& text() const { return text_; }
  /// Whether `what` has not been reported yet.
  bool hasUnreported(const std::string& what) const { return what != reported_; }

 private:
  Pace pace_;
  std::string text_, reported_, candidate_;
  double shown_N_ = 0, shown_s_ = -1e9, candidate_s_ = 0;
};

}  // namespace moltact
