// The state text at a pace that can be read or spoken: a contact is reported at once when it has rested for a moment,
// the force only when it has changed enough to matter. Arithmetic on text; no clock of its own. Unit: second, newton.
#pragma once

#include <string>

namespace moltact {

class StateLine {
 public:
  /// The line changes no oftener than every `pace_s`, and for the force alone only by `step_N` or more.
  struct Pace {
    double pace_s = 0.4;
    double rest_s = 0.1;  ///< the contact must stay the same for so long before it is reported
    double step_N = 0.1;
  };
  static constexpr Pace reading() { return {}; }
  static constexpr Pace speaking() { return {1.5, 0.25, 0.5}; }

  explicit StateLine(Pace pace) : pace_(pace) {}

  /// `what`: what is touched, or why nothing is, without the force; `line`: the whole sentence. True when text()
  /// changed.
  bool update(const std::string& what, const std::string& line, double force_N, double now_s);

  const std::string& text() const { return text_; }
  /// `what` has not been reported yet.
  bool owes(const std::string& what) const { return what != told_; }

 private:
  Pace pace_;
  std::string text_, told_, candidate_;
  double told_N_ = 0, told_s_ = -1e9, candidate_s_ = 0;
};

}  // namespace moltact
